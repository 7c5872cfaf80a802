"use strict";
// The crane in three dimensions: a parallel projection as SVG, so that it prints and needs no WebGL.
class CraneView {
  static NAMES = "http://www.w3.org/2000/svg";
  static FACES = [[0, 1, 3, 2], [4, 5, 7, 6], [0, 1, 5, 4], [2, 3, 7, 6], [0, 2, 6, 4], [1, 3, 7, 5]];
  static FLOOR = [[0, 0], [1, 0], [1, 1], [0, 1]];

  // decimals with which values up to a size are told, a thousandth of it at least
  static decimals(size, least) {
    const MOST = 6;
    return Math.min(MOST, Math.max(least, 2 - Math.floor(Math.log10(size || 1))));
  }

  // a value with decimals, without a sign before zeros only
  static told(value, decimals) {
    return value.toFixed(decimals).replace(/^-(?=[0.]*$)/, "");
  }

  // changed: called when everything has to be drawn again
  constructor(stage, changed) {
    this.stage = stage;
    this.changed = () => {
      this.still = null;
      changed();
    };
    this.azimuth = 35;
    this.elevation = 25;
    this.zoom = 1;
    this.svg = this.make("svg", {"aria-hidden": "true"}, stage);
    // what stays where it is while the crane moves, and what moves
    this.behind = this.make("g", {}, this.svg);
    this.front = this.make("g", {}, this.svg);
    this.listen();
  }

  // scene: travel, path, waypoints, obstacles, load as scene.py has them; points: all that must show
  show(scene, points) {
    this.scene = scene;
    const seen = [...points, ...scene.path, ...scene.waypoints];
    for (const [i, value] of scene.travel[0].entries()) seen.push([value, scene.travel[1][i], 0]);
    this.boxes = scene.obstacles.map((box) => this.clipped(box));
    for (const box of this.boxes) seen.push(box.minimum, box.maximum);
    const low = [0, 1, 2].map((k) => Math.min(...seen.map((p) => p[k])));
    const high = [0, 1, 2].map((k) => Math.max(...seen.map((p) => p[k])));
    for (const box of this.boxes) seen.push(...this.corners(box.minimum, box.maximum));
    this.floor = CraneView.FLOOR.map(([i, j]) => [i ? high[0] : low[0], j ? high[1] : low[1], low[2]]);
    seen.push(...this.floor);
    for (const x of scene.travel[0]) for (const y of scene.travel[1]) seen.push([x, y, 0]);
    this.bounds = {low, high, middle: low.map((value, k) => 0.5 * (value + high[k])), points: seen};
    this.still = null;
  }

  // of an obstacle what is near the motion: some reach to the end of the world
  clipped(box) {
    const {path, travel} = this.scene;
    const points = [...path, [travel[0][0], travel[1][0], 0], [travel[0][1], travel[1][1], 0]];
    const low = [0, 1, 2].map((k) => Math.min(...points.map((p) => p[k])));
    const high = [0, 1, 2].map((k) => Math.max(...points.map((p) => p[k])));
    const reach = 0.25 * Math.max(...low.map((value, k) => high[k] - value));
    const inside = (value, k) => Math.max(low[k] - reach, Math.min(high[k] + reach, value));
    return {name: box.name, minimum: box.minimum.map(inside), maximum: box.maximum.map(inside)};
  }

  // corners of a box, the last coordinate fastest
  corners(low, high) {
    return [0, 1, 2, 3, 4, 5, 6, 7].map((i) => [
      i & 4 ? high[0] : low[0], i & 2 ? high[1] : low[1], i & 1 ? high[2] : low[2],
    ]);
  }

  // across the screen, upwards on it, and into it
  turned(p) {
    const a = this.azimuth * Math.PI / 180, e = this.elevation * Math.PI / 180;
    const q = p.map((value, k) => value - this.bounds.middle[k]);
    const across = q[0] * Math.cos(a) + q[1] * Math.sin(a);
    const into = -q[0] * Math.sin(a) + q[1] * Math.cos(a);
    return [across, into * Math.sin(e) + q[2] * Math.cos(e), into * Math.cos(e) - q[2] * Math.sin(e)];
  }

  project() {
    const all = this.bounds.points.map((p) => this.turned(p));
    const width = this.stage.clientWidth || 600, height = this.stage.clientHeight || 400;
    const least = [0, 1].map((k) => Math.min(...all.map((p) => p[k])));
    const most = [0, 1].map((k) => Math.max(...all.map((p) => p[k])));
    const [wide, tall] = least.map((value, k) => Math.max(most[k] - value, 1e-9));
    const scale = this.zoom * Math.min((width - 50) / wide, (height - 40) / tall);
    this.svg.setAttribute("viewBox", `0 0 ${width} ${height}`);
    this.projection = {
      width, height, scale, middle: [0, 1].map((k) => 0.5 * (least[k] + most[k])),
    };
  }

  // place on the screen, and depth
  place(p) {
    const {width, height, scale, middle} = this.projection, [u, v, depth] = this.turned(p);
    return [width / 2 + scale * (u - middle[0]), height / 2 - scale * (v - middle[1]), depth];
  }

  // the point [x, y] of a height z that a place on the screen shows; null if it is seen from the side
  point(screen, z) {
    const at = [0, 1].map((k) => this.place([k === 0 ? 1 : 0, k, z]));
    const origin = this.place([0, 0, z]);
    const [[a, b], [c, d]] = at.map((p) => [p[0] - origin[0], p[1] - origin[1]]);
    const area = a * d - b * c, [u, v] = [screen[0] - origin[0], screen[1] - origin[1]];
    const LEAST = 0.05;
    if (Math.abs(area) < LEAST * this.projection.scale ** 2) return null;
    return [(u * d - v * c) / area, (v * a - u * b) / area];
  }

  make(name, attributes, into = this.layer, text = undefined) {
    const made = document.createElementNS(CraneView.NAMES, name);
    for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
    if (text !== undefined) made.textContent = text;
    into.append(made);
    return made;
  }

  trace(points) {
    return points.map((p) => `${p[0].toFixed(1)},${p[1].toFixed(1)}`).join(" ");
  }

  line(p, q, name) {
    this.polyline([p, q].map((point) => this.place(point)), name);
  }

  polyline(points, name, attributes = {}) {
    this.make("polyline", {points: this.trace(points), class: name, ...attributes});
  }

  cuboid(low, high, name) {
    const points = this.corners(low, high).map((p) => this.place(p));
    const faces = CraneView.FACES.map((face) => face.map((i) => points[i]));
    const depth = (face) => face.reduce((sum, p) => sum + p[2], 0);
    faces.sort((a, b) => depth(b) - depth(a));
    for (const face of faces) this.make("polygon", {points: this.trace(face), class: name});
  }

  // bridge and trolley, load and its trail [m]; bodies between them, from above; target: where it shall go, if any
  draw({bridge, trolley, load, trail, bodies = [], target = null}) {
    if (!this.still) this.surroundings();
    this.layer = this.front;
    this.front.replaceChildren();
    this.polyline(trail.map((p) => this.place(p)), "trail", {id: "trail"});
    if (target) this.mark(target);
    const {travel} = this.scene;
    this.line([bridge, travel[1][0], 0], [bridge, travel[1][1], 0], "girder");
    const places = [...bodies.map(({place}) => place), load];
    this.line([bridge, trolley, 0], places[0], "rope");
    for (let k = 1; k < places.length; k += 1) this.line(places[k - 1], places[k], "link");
    const [u, v] = this.place([bridge, trolley, 0]);
    this.make("rect", {x: u - 8, y: v - 6, width: 16, height: 12, rx: 2, class: "trolley"});
    for (const {name, place} of bodies) {
      const [x, y] = this.place(place);
      this.make("rect", {x: x - 4, y: y - 5, width: 8, height: 10, rx: 3, class: "body", id: name});
    }
    this.hang(load);
  }

  hang(load) {
    const {size, centre} = this.scene.load, [u, v] = this.place(load);
    if (Math.max(...size) > 0) {
      const middle = load.map((value, k) => value + centre[k]);
      const [low, high] = [-0.5, 0.5].map((s) => middle.map((value, k) => value + s * size[k]));
      this.cuboid(low, high, "load");
    }
    const r = Math.max(...size) > 0 ? 3.5 : 7;
    this.make("circle", {cx: u, cy: v, r, class: "load", id: "load"});
  }

  mark(target) {
    const [u, v] = this.place(target), [x, y] = this.place([...target.slice(0, 2), this.bounds.low[2]]);
    this.polyline([[u, v], [x, y]], "target");
    this.make("circle", {cx: u, cy: v, r: 6, class: "target", id: "target"});
  }

  surroundings() {
    this.project();
    this.still = this.layer = this.behind;
    this.behind.replaceChildren();
    this.make("polygon", {points: this.trace(this.floor.map((p) => this.place(p))), class: "floor"});
    for (const box of this.boxes) this.cuboid(box.minimum, box.maximum, "box");
    const {travel, path} = this.scene;
    for (const side of travel[1]) this.line([travel[0][0], side, 0], [travel[0][1], side, 0], "rail");
    this.polyline(path.map((p) => this.place(p)), "path");
    this.labels();
    this.axes();
  }

  labels() {
    const {waypoints} = this.scene, last = waypoints.length - 1, texts = [];
    const places = waypoints.map((point) => this.place(point));
    for (const [u, v] of places) this.make("circle", {cx: u, cy: v, r: 4.5, class: "waypoint"});
    const write = (x, y, text, more = {}) => texts.push(this.make("text", {x, y, ...more}, this.layer, text));
    // the first ones stay, so the ends begin
    for (const k of [0, last, ...places.keys()].filter((k, i) => i < 2 || (k > 0 && k < last))) {
      write(places[k][0] + 8, places[k][1] + 15, String(k + 1));
    }
    for (const box of this.boxes) {
      const points = this.corners(box.minimum, box.maximum).map((p) => this.place(p));
      const lowest = Math.max(...points.map((p) => p[1]));
      const middle = points.reduce((sum, p) => sum + p[0], 0) / points.length;
      write(middle, lowest - 8, box.name, {"text-anchor": "middle"});
    }
    this.thin(texts);
  }

  // remove texts that lie on one before them
  thin(texts) {
    const kept = [];
    for (const [text, box] of texts.map((one) => [one, one.getBBox()])) {
      if (kept.some((b) => box.x < b.x + b.width && b.x < box.x + box.width
        && box.y < b.y + b.height && b.y < box.y + box.height)) text.remove();
      else kept.push(box);
    }
  }

  // directions of x, y and z in the corner
  axes() {
    const {height, scale} = this.projection, LONG = 34, SHORTEST = 6;
    const origin = this.place([0, 0, 0]), corner = [44, height - 40];
    ["x", "y", "z"].forEach((name, k) => {
      const tip = this.place([0, 1, 2].map((j) => (j === k ? 1 : 0)));
      const side = [0, 1].map((j) => LONG / scale * (tip[j] - origin[j]));
      if (Math.hypot(...side) < SHORTEST) return;
      const end = [corner[0] + side[0], corner[1] + side[1]];
      this.polyline([corner, end], "axis");
      const place = {x: end[0] + (side[0] < 0 ? -12 : 4), y: end[1] + (side[1] > 4 ? 12 : 2)};
      this.make("text", place, this.layer, name);
    });
  }

  turn(azimuth, elevation) {
    this.azimuth += azimuth;
    this.elevation = Math.max(0, Math.min(90, this.elevation + elevation));
    this.changed();
  }

  enlarge(factor) {
    this.zoom = Math.max(0.3, Math.min(8, this.zoom * factor));
    this.changed();
  }

  // buttons of the page, a pointer that drags, and a stage of another size
  listen() {
    const numbers = (text) => text.split(",").map(Number);
    const buttons = (name, act) => document.querySelectorAll(`[data-${name}]`).forEach((button) =>
      button.addEventListener("click", () => act(...numbers(button.dataset[name]))));
    buttons("view", (azimuth, elevation) => {
      Object.assign(this, {azimuth, elevation, zoom: 1});
      this.changed();
    });
    buttons("turn", (azimuth, elevation) => this.turn(azimuth, elevation));
    buttons("zoom", (factor) => this.enlarge(factor));
    this.stage.addEventListener("pointermove", (event) => {
      if (event.buttons === 1) this.turn(-0.5 * event.movementX, 0.5 * event.movementY);
    });
    new ResizeObserver(() => this.changed()).observe(this.stage);
  }
}
