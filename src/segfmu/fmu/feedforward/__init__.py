"""What the models of planner and flat inverse share, whatever the load hangs on."""
