"""Mission files, the verdict on a run, and its tables and plots."""
