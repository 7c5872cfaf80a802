"""The two FMUs: interface specifications, model descriptions, and the PythonFMU backend."""
