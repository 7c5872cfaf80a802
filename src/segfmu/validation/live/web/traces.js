"use strict";
// Curves of the last seconds on a canvas.
class Trace {
  static DASHES = [[], [9, 3], [3, 2]];
  static COLOURS = ["--x", "--y", "--z"];

  // least: of the scale, so that what does not move shows as a line; window [s]
  constructor(canvas, window, least, unit) {
    Object.assign(this, {canvas, window, least, unit, rows: []});
    this.context = canvas.getContext("2d");
  }

  // values at a time; those out of the window are forgotten
  add(time, values) {
    this.rows.push([time, ...values]);
    while (this.rows[0][0] < time - this.window) this.rows.shift();
  }

  clear() {
    this.rows = [];
  }

  // greatest magnitude of each curve
  get peaks() {
    return (this.rows[0] ?? []).slice(1).map((_, k) =>
      this.rows.reduce((most, row) => Math.max(most, Math.abs(row[k + 1])), 0));
  }

  // a round number at or above a value
  static round(value) {
    const size = 10 ** Math.floor(Math.log10(value));
    return [1, 2, 5, 10].find((step) => step * size >= value * (1 - 1e-9)) * size;
  }

  draw() {
    const {canvas, context: c, rows} = this, ratio = window.devicePixelRatio || 1;
    const width = canvas.clientWidth, height = canvas.clientHeight, LEFT = 44, RIM = 8;
    if (canvas.width !== Math.round(width * ratio) || canvas.height !== Math.round(height * ratio)) {
      [canvas.width, canvas.height] = [width, height].map((size) => Math.round(size * ratio));
    }
    const style = getComputedStyle(canvas), colour = (name) => style.getPropertyValue(name);
    c.setTransform(ratio, 0, 0, ratio, 0, 0);
    c.clearRect(0, 0, width, height);
    const most = Trace.round(Math.max(this.least, ...this.peaks));
    const end = rows.length ? rows[rows.length - 1][0] : 0;
    const x = (time) => width - RIM - (end - time) / this.window * (width - LEFT - RIM);
    const y = (value) => height / 2 - value / most * (height / 2 - RIM);
    c.font = "12px system-ui, sans-serif";
    c.textAlign = "right";
    c.textBaseline = "middle";
    c.lineWidth = 1;
    c.setLineDash([]);
    for (const value of [-most, 0, most]) {
      c.strokeStyle = colour("--line");
      c.beginPath();
      c.moveTo(LEFT, y(value));
      c.lineTo(width - RIM, y(value));
      c.stroke();
      c.fillStyle = colour("--ink");
      c.fillText(String(Number(value.toPrecision(3))), LEFT - 6, y(value));
    }
    c.lineWidth = 2;
    for (let k = 1; k < (rows[0]?.length ?? 0); k += 1) {
      c.strokeStyle = colour(Trace.COLOURS[k - 1]);
      c.setLineDash(Trace.DASHES[k - 1]);
      c.beginPath();
      for (const row of rows) c.lineTo(x(row[0]), y(row[k]));
      c.stroke();
    }
  }
}
