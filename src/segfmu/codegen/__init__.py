"""Generators of all generated files: SymPy to Python, kernels to C, records to enums and docs."""
