"""Native FMUs: sources in C99, compilers, archives."""
