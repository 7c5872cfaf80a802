"""A crane whose load hangs on a hook: a double pendulum."""
