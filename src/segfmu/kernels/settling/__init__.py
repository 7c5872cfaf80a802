"""From any state of a motion to one from which the planner goes on, or to a velocity."""
