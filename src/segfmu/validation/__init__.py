"""Missions as files, the judgement of a run, and its tables and plots."""
