"use strict";
// Runs that are played in the view of the crane.
(() => {
  const stage = document.getElementById("stage");
  if (!stage) return;
  const scenes = JSON.parse(document.getElementById("data").textContent).scenes;
  const find = (name) => document.getElementById(name);
  const play = find("play"), slider = find("time"), speed = find("speed"), which = find("which");
  let scene = scenes[0], number = 0, time = 0, playing = false, last = 0, decimals = 3;
  const view = new CraneView(stage, () => draw());

  function prepare() {
    const rows = [2, 3, 4].map((row) => scene.frames[row]), points = [];
    for (let i = 0; i < scene.times.length; i += 4) points.push(rows.map((row) => row[i]));
    view.show(scene, points);
    const sizes = [2, 3, 4].map((row) => Math.max(...scene.frames[row]) - Math.min(...scene.frames[row]));
    decimals = CraneView.decimals(Math.max(...sizes), 3);
    slider.max = scene.times[scene.times.length - 1];
  }

  // values of all rows at a time, linear between frames
  function state() {
    const times = scene.times;
    const share = time / times[times.length - 1] * (times.length - 1);
    const i = Math.min(Math.floor(share), times.length - 2), rest = share - i;
    return {i, values: scene.frames.map((row) => row[i] + rest * (row[i + 1] - row[i]))};
  }

  function draw() {
    const {i, values} = state();
    const [bridge, trolley, x, y, z, swayX, swayY, ...rest] = values, trail = [];
    // places of the bodies between rope and load, then angles of the links below them
    const bodies = scene.bodies.map((name, k) => ({name, place: rest.slice(3 * k, 3 * k + 3)}));
    const angles = rest.slice(3 * bodies.length), links = scene.links.map(
      (name, k) => `, ${name} ${angles[2 * k].toFixed(2)} and ${angles[2 * k + 1].toFixed(2)} deg`);
    for (let j = 0; j <= i; j += 1) trail.push([2, 3, 4].map((row) => scene.frames[row][j]));
    trail.push([x, y, z]);
    view.draw({bridge, trolley, bodies, load: [x, y, z], trail});
    const places = [x, y, z].map((value, k) => `${"xyz"[k]} ${CraneView.told(value, decimals)}`);
    const words = `${time.toFixed(2)} s: load at ${places.join(", ")} m; `
      + `sway ${swayX.toFixed(2)} and ${swayY.toFixed(2)} deg`
      + links.join("");
    find("state").textContent = words;
    slider.setAttribute("aria-valuetext", `${time.toFixed(1)} seconds`);
    document.dispatchEvent(new CustomEvent("scenetime", {detail: {time, scene: number}}));
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
  stage.addEventListener("keydown", (event) => {
    const turns = {ArrowLeft: [-5, 0], ArrowRight: [5, 0], ArrowUp: [0, 5], ArrowDown: [0, -5]};
    if (turns[event.key]) view.turn(...turns[event.key]);
    else if (event.key === "+" || event.key === "=") view.enlarge(1.25);
    else if (event.key === "-") view.enlarge(0.8);
    else return;
    event.preventDefault();
  });
  which?.addEventListener("change", () => {
    number = Number(which.value);
    scene = scenes[number];
    stop();
    prepare();
    moveTo(0);
  });
  prepare();
  draw();
})();
