"""Load and rope against obstacles."""
