within ;
package Segfmu "Swing-free motion of a gantry crane: planner and crane as FMUs, and a crane in plain Modelica"
  annotation(
    version = "0.3.0",
    Documentation(info = "<html>
<p>{MODELS} All classes run an FMU (FMI 2.0 model exchange); the folders of
the unpacked FMUs are in this package's Resources/FMUs, or are given by the parameter <code>folder</code>.
A connector of one class belongs to the connector of the same name of the other.</p>
<p>PlainCrane is a second crane, of Newton's equations in Modelica alone, to check the first one.</p>
</html>"),
    Icon(graphics = {
      Rectangle(extent = {{-100, 100}, {100, -100}}, lineColor = {60, 60, 60}, fillColor = {245, 245, 245}, fillPattern = FillPattern.Solid, radius = 25),
      Line(points = {{-80, 60}, {80, 60}}, color = {60, 60, 60}, thickness = 3),
      Line(points = {{-20, 60}, {20, -30}}, color = {60, 60, 60}),
      Ellipse(extent = {{5, -25}, {45, -65}}, lineColor = {200, 90, 0}, fillColor = {200, 90, 0}, fillPattern = FillPattern.Solid)}));
end Segfmu;
