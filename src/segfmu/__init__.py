"""segfmu."""
