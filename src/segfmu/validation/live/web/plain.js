"use strict";
// The plain joystick: what is commanded goes as a ramp straight to the drives, and nobody thinks of
// the load that swings.
class PlainRamp {
  // speeds [m/s] and accelerations [m/s2] of x, y, z; room: least and greatest places [m]
  constructor(speeds, accelerations, room) {
    Object.assign(this, {speeds, accelerations, room, velocity: [0, 0, 0]});
  }

  // Velocities [m/s] of bridge, trolley and rope a time later: along a wanted velocity or to a target,
  // and slow enough to stop before the ends of the room, as limit switches have it.
  follow({velocity, target}, place, step) {
    this.velocity = this.velocity.map((now, k) => {
      const rate = this.accelerations[k], [low, high] = this.room[k];
      const braking = (way) => Math.sqrt(2 * rate * Math.max(way - Math.abs(now) * step, 0));
      const ahead = target ? target[k] - place[k] : 0;
      const most = Math.min(this.speeds[k], target ? braking(Math.abs(ahead)) : Infinity);
      const wanted = target ? Math.sign(ahead) * most : velocity[k];
      const safe = Math.max(-braking(place[k] - low), Math.min(braking(high - place[k]), wanted));
      return now + Math.max(-rate * step, Math.min(rate * step, safe - now));
    });
    const [x, y, z] = this.velocity;
    return [x, y, -z];
  }
}
