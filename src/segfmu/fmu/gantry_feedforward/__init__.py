"""GantryFeedforward: interface, slave, and model in C."""
