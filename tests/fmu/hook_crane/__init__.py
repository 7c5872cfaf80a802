"""HookCrane as an FMU."""
