"use strict";
// The page: frames, controls and words.
const data = JSON.parse(document.getElementById("data").textContent);
const find = (name) => document.getElementById(name);

// of plan.status and plan.refused
const REDUCED = 1, PENDING = 7;
const REASON = [
  "", "", "limits of the load", "the rope is too short or too long there", "the end of the workspace",
  "an obstacle is in the way", "the drives are too weak", "", "an end stop",
];
// s of a frame that are made up for at most, and ms of work in one: then the crane is slower instead
const LONGEST = 0.1, WORK = 14;
// points of the trail, and of a trace
const POINTS = 400;
const DEGREES = 180 / Math.PI;

class Page {
  constructor(driver) {
    this.driver = driver;
    this.view = new CraneView(find("stage"), () => {});
    this.view.show(data.scene, data.room[0].flatMap((x) =>
      data.room[1].flatMap((y) => data.room[2].map((z) => [x, y, z]))));
    this.decimals = {
      place: CraneView.decimals(Math.max(...data.room.map(([low, high]) => high - low)), 2),
      speed: CraneView.decimals(Math.max(...data.speeds), 2),
    };
    // the longer axis of the room across the screen
    const [wide, deep] = data.room.map(([low, high]) => high - low);
    if (deep > wide) this.view.azimuth = 60;
    const acts = {
      stop: () => driver.stop(), mission: () => this.fly(), plain: () => this.choose(!driver.plain),
    };
    this.joystick = new Joystick(find("pad"), find("lift"), acts);
    this.sway = new Trace(find("sway"), data.window, 0.1, "deg");
    this.speed = new Trace(find("speed"), data.window, 0.1 * Math.max(...data.speeds), "m/s");
    this.trail = [];
    this.sampled = -Infinity;
    this.left = 0;
    this.rate = 60;
    this.listen(acts);
    requestAnimationFrame((now) => this.frame(now));
  }

  listen(acts) {
    find("stop").addEventListener("click", acts.stop);
    find("mission").addEventListener("click", acts.mission);
    for (const radio of document.querySelectorAll("[name=mode]")) {
      radio.addEventListener("change", () => this.choose(radio.value === "plain"));
    }
    // arrow keys drive again
    for (const input of document.querySelectorAll("[name=mode], #pace")) {
      input.addEventListener("change", () => input.blur());
    }
    for (const name of ["windx", "windy", "mass"]) {
      find(name).addEventListener("input", () => this.label(name));
      find(name).addEventListener("pointerup", () => find(name).blur());
      this.label(name);
    }
    for (const name of ["windx", "windy"]) {
      find(name).addEventListener("input", () =>
        this.driver.blow(["windx", "windy"].map((axis) => this.value(axis))));
    }
    find("mass").addEventListener("change", () => this.driver.take(this.value("mass")));
    this.aim();
  }

  label(name) {
    const [factor, unit] = data.units[name === "mass" ? "mass" : "force"];
    const words = `${Number((factor * this.value(name)).toPrecision(3))} ${unit}`;
    find(`${name}-value`).textContent = words;
    find(name).setAttribute("aria-valuetext", words);
  }

  // of a slider, which has shares of the strongest wind [N] and of the mission's load [kg]
  value(name) {
    return Number(find(name).value) * (name === "mass" ? data.mass : data.wind);
  }

  // a click that does not drag the view sets a target on the floor, at the load's height
  aim() {
    const NEAR = 5;
    let from = null;
    this.view.stage.addEventListener("pointerdown", (event) => { from = [event.clientX, event.clientY]; });
    this.view.stage.addEventListener("pointerup", (event) => {
      if (!from || Math.hypot(event.clientX - from[0], event.clientY - from[1]) > NEAR) return;
      const {left, top} = this.view.stage.getBoundingClientRect();
      const floor = this.view.point([event.clientX - left, event.clientY - top], this.view.bounds.low[2]);
      this.told = floor ? "" : "raise the view to see the floor, then click on it";
      if (floor) this.driver.goTo([...floor, this.driver.load[2]]);
    });
  }

  choose(plain) {
    this.driver.choose(plain);
    this.forget();
  }

  fly() {
    this.driver.fly();
    this.forget();
  }

  forget() {
    find(this.driver.plain ? "plain" : "free").checked = true;
    this.trail = [];
    for (const trace of [this.sway, this.speed]) trace.clear();
  }

  frame(now) {
    requestAnimationFrame((next) => this.frame(next));
    const passed = Math.min((now - (this.last ?? now)) / 1000, LONGEST);
    this.last = now;
    if (passed > 0) this.rate += 0.05 * (1 / passed - this.rate);
    this.driver.steer(this.joystick.parts(this.view.azimuth));
    this.left += passed * Number(find("pace").value);
    const until = performance.now() + WORK;
    while (this.left >= data.step && performance.now() < until) {
      this.driver.step();
      this.left -= data.step;
      this.sample();
    }
    // what a frame has no time for is left out
    if (this.left >= data.step) this.left = 0;
    this.draw();
  }

  sample() {
    const {driver} = this, {state} = driver.system;
    if (driver.time < this.sampled + data.window / POINTS) return;
    this.sampled = driver.time;
    this.trail.push(driver.load);
    if (this.trail.length > POINTS) this.trail.shift();
    this.sway.add(driver.time, ["sway.x.angle", "sway.y.angle"].map((name) => DEGREES * state[name]));
    this.speed.add(driver.time, Driver.SPEED.map((name) => state[name]));
  }

  draw() {
    const {driver} = this, {state} = driver.system, load = driver.load;
    this.view.draw({
      bridge: state["bridge.position"], trolley: state["trolley.position"], load,
      trail: [...this.trail, load], target: driver.command.target,
    });
    this.sway.draw();
    this.speed.draw();
    const swayed = (values) => `${Math.max(...values.map(Math.abs)).toFixed(3)}°`;
    find("now").textContent = swayed(["sway.x.angle", "sway.y.angle"].map((name) => DEGREES * state[name]));
    find("most").textContent = swayed(this.sway.peaks.length ? this.sway.peaks : [0]);
    const pace = Math.hypot(...Driver.SPEED.map((name) => state[name]));
    find("pace-now").textContent = `${CraneView.told(pace, this.decimals.speed)} m/s`;
    find("place").textContent = load.map((value) => CraneView.told(value, this.decimals.place)).join(", ");
    this.tell(driver.message || this.told || (driver.command.kind === "none" ? "" : this.outcome()));
    find("rate").textContent = `${driver.time.toFixed(1)} s, ${Math.round(this.rate)} frames a second`;
  }

  // what became of the last command
  outcome() {
    const [status, refused] = this.driver.taken;
    if (status === 0) return "";
    if (status === PENDING) return "not taken yet: other plans are tried";
    return status === REDUCED ? `reduced: ${REASON[refused]}` : `not taken: ${REASON[status]}`;
  }

  // only what is new, as readers of screens speak it
  tell(words) {
    if (words !== find("told").textContent) find("told").textContent = words;
  }
}

let page;
Driver.load(data).then((driver) => {
  page = new Page(driver);
  document.body.dataset.drawn = "yes";
}).catch((error) => {
  find("told").textContent = `this browser cannot run the page: ${error.message}`;
});
