"""segfmu beside its peers on this machine, in one process: `make bench`, or `python -m benchmarks`.

Every part is a module with one function `measure(settings) -> Part`. docs/benchmarks.md tells how
to read the tables.
"""
