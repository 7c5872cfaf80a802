"""Polynomial pieces of a plan: from phases, evaluated, checked."""
