"""Polynomial pieces of a plan: made, evaluated, checked."""
