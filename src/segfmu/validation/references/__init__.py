"""References inside of FMUs, after FMI-LS-REF: written at the build, and repeated."""
