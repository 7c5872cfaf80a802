"""The crane's equations, its flat inverse, drives, friction and wind."""
