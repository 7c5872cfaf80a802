"""FMUs: one folder per model, and the code that all models share."""
