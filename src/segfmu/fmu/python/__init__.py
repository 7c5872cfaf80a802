"""FMUs on PythonFMU."""
