"""What an FMU is by the standard: interface specification, model descriptions, documentation."""
