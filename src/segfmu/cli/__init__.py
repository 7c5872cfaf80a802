"""The command line."""

from segfmu.cli.app import app, main, run

__all__ = ["app", "main", "run"]
