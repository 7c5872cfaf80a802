"""The numeric core: plain typed functions on floats and arrays, translated to C by Pyccel."""
