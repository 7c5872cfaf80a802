"""The FMUs as a Modelica package, generated from their interface specifications."""
