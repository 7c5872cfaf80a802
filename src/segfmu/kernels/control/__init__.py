"""Observer, sway feedback and the tracking controller."""
