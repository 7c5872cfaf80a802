"""Methods that a crane may be driven by in place of the plan: the baselines of comparisons."""
