"""SymPy -> typed Python: the only writer of generated files."""
