within Segfmu;
package Types "Enumerations of the parameters"
  type Shape = enumeration(smoothstep, plateau) "shape of the acceleration ramps";
  type Synchronization = enumeration(none, waypoints, total) "where the axes meet in time";
  type Mode = enumeration(mission, target, velocity, stop, inching, emergency) "what the load does";
  type DriveMode = enumeration(force, velocity) "what the drives follow";
  type SlackRope = enumeration(error, free_fall) "a rope that would have to push";
  type GustShape = enumeration(cosine, sine) "course of a gust over time";
  type FeedbackDesign = enumeration(lqr, flatness) "how the gains of the feedback come about";
  type FeedbackSource = enumeration(state, measured) "what the feedback knows of the crane";
  type OffsetCause = enumeration(wind, sensor) "what a lasting deviation of a sway angle is";
end Types;
