within Segfmu.Examples;
model HookMission "A load on hook and sling: both FMUs with their start values, without feedback"
  extends HookCoupled(crane(feedback_enabled = false));
  annotation(experiment(StopTime = 9, Interval = 0.001, Tolerance = 1e-8));
end HookMission;
