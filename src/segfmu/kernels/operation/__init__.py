"""A motion under an operator's hand: commands -> plans, each one checked up to its standstill."""
