"""The crane with a hook: parameters, equations, declaration as a flat system, and feedback."""
