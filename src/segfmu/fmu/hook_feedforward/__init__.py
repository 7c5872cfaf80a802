"""HookFeedforward: interface, and model in C."""
