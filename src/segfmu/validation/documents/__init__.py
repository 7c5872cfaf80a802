"""JSON documents that commands print with --json: models, from which their schemas follow."""
