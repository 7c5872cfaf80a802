"""A load with a spreader."""
