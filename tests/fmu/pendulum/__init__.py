"""A further model in one folder: a load that swings in a plane below a trolley."""
