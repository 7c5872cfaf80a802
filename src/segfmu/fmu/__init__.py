"""FMUs: one folder a model, and what all of them share."""
