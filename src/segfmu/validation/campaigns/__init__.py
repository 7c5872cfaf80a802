"""Campaigns: many runs of scenarios with factors that differ, their table, and what it says."""
