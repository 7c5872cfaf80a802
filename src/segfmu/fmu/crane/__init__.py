"""What cranes as models have in common: their sources in C, whatever hangs on the rope."""
