"""GantryCrane: interface, slave, and model in C."""
