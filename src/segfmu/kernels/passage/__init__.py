"""From waypoints with free velocities and accelerations to those with which a plan is short."""
