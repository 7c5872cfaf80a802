"use strict";
// The crane in three dimensions: a parallel projection as SVG, so that it prints and needs no WebGL.
(() => {
  const stage = document.getElementById("stage");
  if (!stage) return;
  const scenes = JSON.parse(document.getElementById("data").textContent).scenes;
  const NAMES = "http://www.w3.org/2000/svg";
  const FACES = [[0, 1, 3, 2], [4, 5, 7, 6], [0, 1, 5, 4], [2, 3, 7, 6], [0, 2, 6, 4], [1, 3, 7, 5]];
  const MOST_NAMES = 20;
  const FLOOR = [[0, 0], [1, 0], [1, 1], [0, 1]];
  const view = {azimuth: 35, elevation: 25, zoom: 1};
  const find = (name) => document.getElementById(name);
  const play = find("play"), slider = find("time"), speed = find("speed"), which = find("which");
  let scene = scenes[0], number = 0, bounds, time = 0, playing = false, last = 0;

  const svg = document.createElementNS(NAMES, "svg");
  svg.setAttribute("aria-hidden", "true");
  stage.append(svg);

  // corners of a box, the last coordinate fastest
  const corners = (low, high) => [0, 1, 2, 3, 4, 5, 6, 7].map((i) => [
    i & 4 ? high[0] : low[0], i & 2 ? high[1] : low[1], i & 1 ? high[2] : low[2],
  ]);

  function prepare() {
    const points = [...scene.path, ...scene.waypoints];
    for (const [i, value] of scene.travel[0].entries()) points.push([value, scene.travel[1][i], 0]);
    for (const box of scene.obstacles) points.push(clipped(box).minimum, clipped(box).maximum);
    const frames = [2, 3, 4].map((row) => scene.frames[row]);
    for (let i = 0; i < scene.times.length; i += 4) points.push(frames.map((row) => row[i]));
    const low = [0, 1, 2].map((k) => Math.min(...points.map((p) => p[k])));
    const high = [0, 1, 2].map((k) => Math.max(...points.map((p) => p[k])));
    bounds = {low, high, middle: low.map((value, k) => 0.5 * (value + high[k])), points};
    for (const box of scene.obstacles) {
      bounds.points.push(...corners(clipped(box).minimum, clipped(box).maximum));
    }
    bounds.points.push(...FLOOR.map(([i, j]) => [i ? high[0] : low[0], j ? high[1] : low[1], low[2]]));
    for (const x of scene.travel[0]) for (const y of scene.travel[1]) bounds.points.push([x, y, 0]);
    slider.max = scene.times[scene.times.length - 1];
  }

  // of an obstacle what is near the motion: some reach to the end of the world
  function clipped(box) {
    const points = [...scene.path, [scene.travel[0][0], scene.travel[1][0], 0],
                    [scene.travel[0][1], scene.travel[1][1], 0]];
    const low = [0, 1, 2].map((k) => Math.min(...points.map((p) => p[k])));
    const high = [0, 1, 2].map((k) => Math.max(...points.map((p) => p[k])));
    const reach = 0.25 * Math.max(...low.map((value, k) => high[k] - value));
    const inside = (value, k) => Math.max(low[k] - reach, Math.min(high[k] + reach, value));
    return {name: box.name, minimum: box.minimum.map(inside), maximum: box.maximum.map(inside)};
  }

  function projection() {
    const a = view.azimuth * Math.PI / 180, e = view.elevation * Math.PI / 180;
    const across = (p) => p[0] * Math.cos(a) + p[1] * Math.sin(a);
    const into = (p) => -p[0] * Math.sin(a) + p[1] * Math.cos(a);
    const raw = (p) => {
      const q = p.map((value, k) => value - bounds.middle[k]);
      return [across(q), into(q) * Math.sin(e) + q[2] * Math.cos(e), into(q) * Math.cos(e) - q[2] * Math.sin(e)];
    };
    const all = bounds.points.map(raw);
    const width = stage.clientWidth || 600, height = stage.clientHeight || 400;
    const least = [0, 1].map((k) => Math.min(...all.map((p) => p[k])));
    const most = [0, 1].map((k) => Math.max(...all.map((p) => p[k])));
    const [wide, tall] = least.map((value, k) => Math.max(most[k] - value, 1e-9));
    const scale = view.zoom * Math.min((width - 50) / wide, (height - 40) / tall);
    svg.setAttribute("viewBox", `0 0 ${width} ${height}`);
    const place = (p) => {
      const [u, v, depth] = raw(p);
      return [
        width / 2 + scale * (u - 0.5 * (least[0] + most[0])),
        height / 2 - scale * (v - 0.5 * (least[1] + most[1])), depth,
      ];
    };
    return {place, height, scale};
  }

  const add = (name, attributes, text) => {
    const made = document.createElementNS(NAMES, name);
    for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
    if (text !== undefined) made.textContent = text;
    svg.append(made);
    return made;
  };
  const trace = (points) => points.map((p) => `${p[0].toFixed(1)},${p[1].toFixed(1)}`).join(" ");
  const line = (p, q, name) => add("polyline", {points: trace([p, q]), class: name});

  function cuboid(place, low, high, name) {
    const points = corners(low, high).map(place);
    const faces = FACES.map((face) => face.map((i) => points[i]));
    const depth = (face) => face.reduce((sum, p) => sum + p[2], 0);
    faces.sort((a, b) => depth(b) - depth(a));
    for (const face of faces) add("polygon", {points: trace(face), class: name});
    return points;
  }

  // values of all rows at a time, linear between frames
  function state() {
    const times = scene.times;
    const share = time / times[times.length - 1] * (times.length - 1);
    const i = Math.min(Math.floor(share), times.length - 2), rest = share - i;
    return {i, values: scene.frames.map((row) => row[i] + rest * (row[i + 1] - row[i]))};
  }

  function draw() {
    const {place, height, scale} = projection();
    const {i, values} = state();
    const [bridge, trolley, x, y, z, swayX, swayY] = values;
    svg.replaceChildren();
    const {low, high} = bounds;
    const floor = FLOOR.map(([i, j]) => place([i ? high[0] : low[0], j ? high[1] : low[1], low[2]]));
    add("polygon", {points: trace(floor), class: "floor"});
    const boxes = scene.obstacles.map(clipped);
    for (const box of boxes) cuboid(place, box.minimum, box.maximum, "box");
    for (const side of scene.travel[1]) {
      line(place([scene.travel[0][0], side, 0]), place([scene.travel[0][1], side, 0]), "rail");
    }
    add("polyline", {points: trace(scene.path.map(place)), class: "path"});
    const trail = [];
    for (let j = 0; j <= i; j += 1) trail.push(place([2, 3, 4].map((row) => scene.frames[row][j])));
    trail.push(place([x, y, z]));
    add("polyline", {points: trace(trail), class: "trail", id: "trail"});
    crane(place, bridge, trolley, [x, y, z]);
    labels(place, boxes);
    axes(place, height, scale);
    const words = `${time.toFixed(2)} s: load at x ${x.toFixed(3)}, y ${y.toFixed(3)}, z ${z.toFixed(3)} m; `
      + `sway ${swayX.toFixed(2)} and ${swayY.toFixed(2)} deg`;
    find("state").textContent = words;
    slider.setAttribute("aria-valuetext", `${time.toFixed(1)} seconds`);
    document.dispatchEvent(new CustomEvent("scenetime", {detail: {time, scene: number}}));
  }

  function crane(place, bridge, trolley, load) {
    line(place([bridge, scene.travel[1][0], 0]), place([bridge, scene.travel[1][1], 0]), "girder");
    line(place([bridge, trolley, 0]), place(load), "rope");
    const [u, v] = place([bridge, trolley, 0]);
    add("rect", {x: u - 8, y: v - 6, width: 16, height: 12, rx: 2, class: "trolley"});
    const {size, centre} = scene.load;
    if (Math.max(...size) > 0) {
      const middle = load.map((value, k) => value + centre[k]);
      const points = [-0.5, 0.5].map((s) => middle.map((value, k) => value + s * size[k]));
      cuboid(place, points[0], points[1], "load");
    }
    const [a, b] = place(load);
    add("circle", {cx: a, cy: b, r: Math.max(...size) > 0 ? 3.5 : 7, class: "load", id: "load"});
  }

  function labels(place, boxes) {
    scene.waypoints.forEach((point, k) => {
      const [u, v] = place(point);
      add("circle", {cx: u, cy: v, r: 4.5, class: "waypoint"});
      const ends = k === 0 || k === scene.waypoints.length - 1;
      if (ends || scene.waypoints.length <= MOST_NAMES) add("text", {x: u + 8, y: v + 15}, String(k + 1));
    });
    for (const box of boxes.length <= MOST_NAMES ? boxes : []) {
      const points = corners(box.minimum, box.maximum).map(place);
      const lowest = Math.max(...points.map((p) => p[1]));
      const middle = points.reduce((sum, p) => sum + p[0], 0) / points.length;
      add("text", {x: middle, y: lowest - 8, "text-anchor": "middle"}, box.name);
    }
  }

  // directions of x, y and z in the corner
  function axes(place, height, scale) {
    const origin = place([0, 0, 0]), corner = [44, height - 40];
    ["x", "y", "z"].forEach((name, k) => {
      const tip = place([0, 1, 2].map((j) => (j === k ? 1 : 0)));
      const side = [0, 1].map((j) => 34 / scale * (tip[j] - origin[j]));
      if (Math.hypot(...side) < 6) return;
      const end = [corner[0] + side[0], corner[1] + side[1]];
      line(corner, end, "axis");
      add("text", {x: end[0] + (side[0] < 0 ? -12 : 4), y: end[1] + (side[1] > 4 ? 12 : 2)}, name);
    });
  }

  function moveTo(value) {
    const end = scene.times[scene.times.length - 1];
    time = Math.min(Math.max(value, 0), end);
    slider.value = time;
    draw();
    if (time >= end) stop();
  }

  function stop() {
    playing = false;
    play.textContent = "Play";
    play.setAttribute("aria-pressed", "false");
  }

  function step(now) {
    if (!playing) return;
    moveTo(time + Number(speed.value) * (now - last) / 1000);
    last = now;
    requestAnimationFrame(step);
  }

  play.addEventListener("click", () => {
    if (playing) return stop();
    if (time >= scene.times[scene.times.length - 1]) time = 0;
    playing = true;
    last = performance.now();
    play.textContent = "Pause";
    play.setAttribute("aria-pressed", "true");
    requestAnimationFrame(step);
  });
  slider.addEventListener("input", () => moveTo(Number(slider.value)));
  // a step of the keys is a fiftieth of the run
  slider.addEventListener("keydown", (event) => {
    const side = {ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1}[event.key];
    if (!side) return;
    event.preventDefault();
    moveTo(time + side * scene.times[scene.times.length - 1] / 50);
  });

  const turn = (azimuth, elevation) => {
    view.azimuth += azimuth;
    view.elevation = Math.max(0, Math.min(90, view.elevation + elevation));
    draw();
  };
  const enlarge = (factor) => {
    view.zoom = Math.max(0.3, Math.min(8, view.zoom * factor));
    draw();
  };
  const numbers = (text) => text.split(",").map(Number);
  document.querySelectorAll("[data-view]").forEach((button) => button.addEventListener("click", () => {
    [view.azimuth, view.elevation] = numbers(button.dataset.view);
    view.zoom = 1;
    draw();
  }));
  document.querySelectorAll("[data-turn]").forEach((button) => button.addEventListener("click", () =>
    turn(...numbers(button.dataset.turn))));
  document.querySelectorAll("[data-zoom]").forEach((button) => button.addEventListener("click", () =>
    enlarge(Number(button.dataset.zoom))));
  stage.addEventListener("keydown", (event) => {
    const turns = {ArrowLeft: [-5, 0], ArrowRight: [5, 0], ArrowUp: [0, 5], ArrowDown: [0, -5]};
    if (turns[event.key]) turn(...turns[event.key]);
    else if (event.key === "+" || event.key === "=") enlarge(1.25);
    else if (event.key === "-") enlarge(0.8);
    else return;
    event.preventDefault();
  });
  stage.addEventListener("pointermove", (event) => {
    if (event.buttons === 1) turn(-0.5 * event.movementX, 0.5 * event.movementY);
  });
  which?.addEventListener("change", () => {
    number = Number(which.value);
    scene = scenes[number];
    stop();
    prepare();
    moveTo(0);
  });
  new ResizeObserver(() => draw()).observe(stage);
  prepare();
  draw();
})();
