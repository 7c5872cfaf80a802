"""Planner and crane for a load with a spreader."""
