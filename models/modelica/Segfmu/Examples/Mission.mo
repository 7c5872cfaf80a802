within Segfmu.Examples;
model Mission "Both FMUs with their start values: the mission that they were built for"
  extends Coupled;
  annotation(experiment(StopTime = 8, Interval = 0.001, Tolerance = 1e-8));
end Mission;
