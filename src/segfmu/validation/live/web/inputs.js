"use strict";
// Keys, two pads and a gamepad as one joystick: parts of the greatest speed along the screen to the
// right, into it, and upwards.
class Joystick {
  // what a gamepad at rest may show, and the steps of its way: every change is a new plan
  static DEAD = 0.15;
  static STEPS = 10;
  static KEYS = {
    ArrowRight: [0, 1], ArrowLeft: [0, -1], ArrowUp: [1, 1], ArrowDown: [1, -1],
    PageUp: [2, 1], PageDown: [2, -1], w: [2, 1], s: [2, -1],
  };

  // acts: what keys and buttons of a gamepad do beside, by name
  constructor(pad, lift, acts) {
    this.acts = acts;
    this.held = new Set();
    this.pads = [0, 0, 0];
    this.pressed = new Set();
    document.addEventListener("keydown", (event) => this.press(event));
    document.addEventListener("keyup", (event) => this.held.delete(Joystick.named(event.key)));
    window.addEventListener("blur", () => this.held.clear());
    this.drag(pad, (right, up) => { [this.pads[0], this.pads[1]] = [right, up]; });
    this.drag(lift, (_, up) => { this.pads[2] = up; });
  }

  // a letter is the same with and without shift
  static named(key) {
    return key.length === 1 ? key.toLowerCase() : key;
  }

  press(event) {
    const {target} = event, key = Joystick.named(event.key);
    if (event.ctrlKey || event.altKey || event.metaKey || target.matches("input, select")) return;
    const act = {" ": "stop", m: "mission", p: "plain"}[key];
    if (Joystick.KEYS[key]) this.held.add(key);
    else if (act && !event.repeat && !(key === " " && target.matches("button, summary"))) this.acts[act]();
    else return;
    event.preventDefault();
  }

  // a pad that a finger or a mouse pulls, and that springs back
  drag(pad, tell) {
    const knob = pad.querySelector(".knob"), KNOB = 33;
    const move = (right, up) => {
      knob.style.transform = `translate(${KNOB * right}%, ${-KNOB * up}%)`;
      tell(Joystick.stepped(right), Joystick.stepped(up));
    };
    const follow = (event) => {
      const {left, top, width, height} = pad.getBoundingClientRect();
      const limit = (value) => Math.max(-1, Math.min(1, value));
      const across = pad.dataset.axes === "1" ? 0 : limit(2.5 * (event.clientX - left - width / 2) / width);
      move(across, limit(-2.5 * (event.clientY - top - height / 2) / height));
    };
    pad.addEventListener("pointerdown", (event) => {
      pad.setPointerCapture(event.pointerId);
      follow(event);
    });
    pad.addEventListener("pointermove", (event) => {
      if (pad.hasPointerCapture(event.pointerId)) follow(event);
    });
    for (const end of ["lostpointercapture", "pointercancel"]) pad.addEventListener(end, () => move(0, 0));
  }

  static stepped(value) {
    return Math.abs(value) < Joystick.DEAD ? 0 : Math.round(value * Joystick.STEPS) / Joystick.STEPS;
  }

  // the first gamepad: left stick across, right stick up and down; button 0 stops, 1 switches
  gamepad() {
    const found = [...navigator.getGamepads()].find((pad) => pad);
    if (!found) return [0, 0, 0];
    const axis = (i) => Joystick.stepped(found.axes[i] ?? 0);
    ["stop", "plain"].forEach((act, i) => {
      const down = Boolean(found.buttons[i]?.pressed);
      if (down && !this.pressed.has(act)) this.acts[act]();
      this.pressed[down ? "add" : "delete"](act);
    });
    return [axis(0), -axis(1), -axis(3)];
  }

  // azimuth: of the view [deg]; returns parts along x, y, z
  parts(azimuth) {
    const sum = this.gamepad().map((value, k) => value + this.pads[k]);
    for (const key of this.held) sum[Joystick.KEYS[key][0]] += Joystick.KEYS[key][1];
    const [right, into, up] = sum.map((value) => Math.max(-1, Math.min(1, value)));
    // to the axis that is next to what the screen shows
    const quarter = Math.round(azimuth / 90) * Math.PI / 2;
    const [c, s] = [Math.cos(quarter), Math.sin(quarter)].map(Math.round);
    // no -0, which would be another number
    return [right * c - into * s, right * s + into * c, up].map((value) => value + 0);
  }
}
