"""Parameters of a crane file from measured signals, through the model of GantryCrane."""
