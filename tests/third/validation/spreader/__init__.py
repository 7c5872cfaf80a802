"""Files with a spreader."""
