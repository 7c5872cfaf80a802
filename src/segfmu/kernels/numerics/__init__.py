"""Roots, small matrices, integration, random numbers."""
