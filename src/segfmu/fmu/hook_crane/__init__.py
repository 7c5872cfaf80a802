"""HookCrane: interface and model in C."""
