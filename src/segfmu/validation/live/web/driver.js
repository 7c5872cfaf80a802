"use strict";
// One operator's crane: commands in, the state of the crane out, a communication step at a time.
class Driver {
  static STATE = [
    "bridge.position", "trolley.position", "rope.length", "sway.x.angle", "sway.y.angle",
    "bridge.velocity", "trolley.velocity", "rope.velocity", "sway.x.rate", "sway.y.rate",
  ];
  static LOAD = ["load.position.x", "load.position.y", "load.position.z"];
  static SPEED = ["load.velocity.x", "load.velocity.y", "load.velocity.z"];
  static DRIVES = ["velocity.bridge", "velocity.trolley", "velocity.hoist"];
  // of command.mode
  static MODES = {mission: 1, target: 2, velocity: 3, stop: 4};

  static async load(data) {
    const driver = new Driver(), shown = [...Driver.STATE, ...Driver.LOAD, ...Driver.SPEED];
    driver.data = data;
    driver.system = await CraneSystem.load(data, shown);
    driver.status = driver.system.feedforward.channel(["plan.status", "plan.refused"]);
    driver.done = driver.system.feedforward.channel(["plan.done"]);
    driver.drives = driver.system.crane.channel(Driver.DRIVES);
    driver.points = 0;
    driver.wind = [0, 0];
    driver.mass = data.mass;
    driver.plain = false;
    driver.system.time = 0;
    driver.rest(data.start);
    return driver;
  }

  get time() {
    return this.system.time;
  }

  // The load hangs at rest at a place, or at the start where it cannot: inside of an obstacle.
  rest(place) {
    this.onMission = false;
    try {
      this.begin(this.resting(place));
    } catch (error) {
      if (place === this.data.start) throw error;
      this.rest(this.data.start);
      this.message = error.message;
    }
  }

  // settings of a plan that stays at a place
  resting(place) {
    const inside = place.map((value, k) =>
      Math.max(this.data.room[k][0], Math.min(this.data.room[k][1], value)));
    const settings = {"waypoint.count": 2, "planner.duration": 0};
    for (const i of [1, 2]) {
      ["x", "y", "z"].forEach((axis, k) => {
        settings[`waypoint[${i}].position.${axis}`] = inside[k];
        for (const name of ["velocity", "acceleration"]) settings[`waypoint[${i}].${name}.${axis}`] = 0;
      });
      settings[`waypoint[${i}].dwell`] = 0;
    }
    return settings;
  }

  begin(settings) {
    const {data} = this;
    this.ramp = new PlainRamp(data.speeds, data.accelerations, data.room);
    this.command = {kind: "none", velocity: [0, 0, 0], target: null};
    this.system.begin(this.time, settings, this.equipment());
    this.message = "";
  }

  // what the crane has in this run
  equipment() {
    const own = {"crane.payload_mass": this.mass, "wind.x": this.wind[0], "wind.y": this.wind[1]};
    return this.plain ? {...own, "feedback.enabled": false} : own;
  }

  // where load and carriage would come to rest: below the trolley
  get place() {
    const {state} = this.system;
    return [state["bridge.position"], state["trolley.position"], -state["rope.length"]];
  }

  get load() {
    return Driver.LOAD.map((name) => this.system.state[name]);
  }

  // ---- commands ----

  // Whether the operator's joystick goes straight to the drives; the load is at rest first.
  choose(plain) {
    const place = this.place;
    this.plain = plain;
    this.rest(place);
  }

  // Parts of the greatest speed, from -1 to 1; zero of a joystick that is released stops the load.
  steer(parts) {
    const moved = parts.some((part) => part !== 0);
    if (!moved && this.command.kind !== "velocity") return;
    const velocity = parts.map((part, k) => part * this.data.speeds[k]);
    if (velocity.every((value, k) => value === this.command.velocity[k])
        && this.command.kind === "velocity") return;
    if (!moved) return this.stop();
    this.order("velocity", {velocity});
  }

  goTo(target) {
    this.order("target", {
      target: target.map((value, k) => Math.max(this.data.room[k][0], Math.min(this.data.room[k][1], value))),
    });
  }

  stop() {
    this.order("stop", {});
  }

  // The mission's own motion, from its first waypoint.
  fly() {
    this.plain = false;
    this.begin({...this.data.limits, "waypoint.count": this.data.waypoints});
    this.onMission = true;
    this.command.kind = "mission";
  }

  order(kind, {velocity = [0, 0, 0], target = null}) {
    // behind the mission, the load has the limits of the joystick again
    if (this.onMission && this.system.feedforward.read(this.done)[0]) this.rest(this.load);
    this.command = {kind, velocity, target};
    this.message = "";
    if (this.plain) return;
    const values = {"command.mode": Driver.MODES[kind]};
    ["x", "y", "z"].forEach((axis, k) => {
      values[`command.velocity.${axis}`] = velocity[k];
      if (target) values[`command.target.${axis}`] = target[k];
    });
    this.system.change(this.system.feedforward, values);
  }

  // ---- surroundings ----

  // Force on the load along x and y [N].
  blow(wind) {
    this.wind = wind;
    this.system.change(this.system.crane, {"wind.x": wind[0], "wind.y": wind[1]});
  }

  // Another mass of the load [kg]: the crane goes on from its state.
  take(mass) {
    this.mass = mass;
    const state = Object.fromEntries(Driver.STATE.map((name) => [name, this.system.state[name]]));
    this.system.beginCrane(
      {...this.equipment(), "start.on_reference": false, ...state}, () => this.setDrives(this.setpoints()));
  }

  setpoints() {
    const [x, y, z] = this.ramp.velocity;
    return this.plain ? [x, y, -z] : null;
  }

  setDrives(velocities) {
    if (!velocities) return;
    this.system.crane.values(this.drives).set(velocities);
    this.system.crane.write(this.drives);
  }

  // ---- steps ----

  // One communication step; what an FMU refuses is told, and the load is at rest again.
  step() {
    const {step} = this.data, end = (this.points + 1) * step;
    try {
      if (this.plain) {
        this.setDrives(this.ramp.follow(this.command, this.place, step));
        this.system.advanceCrane(end);
      } else {
        this.system.advance(end);
      }
      this.points += 1;
    } catch (error) {
      const place = this.place;
      this.rest(place);
      this.message = error.message;
    }
  }

  // what became of the last command: plan.status and plan.refused, 0 taken
  get taken() {
    return this.plain ? [0, 0] : this.system.feedforward.read(this.status);
  }
}
