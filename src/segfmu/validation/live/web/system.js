"use strict";
// Both FMUs, coupled and stepped as segfmu.cosim.System does by default: with the derivatives of the
// setpoints, and with steps that also end at events.
class CraneSystem {
  // s; as segfmu.cosim has them: times that differ by less are equal, and the least step to an event
  static INSTANT = 1e-9;
  static LEAST = 1e-12;

  // data: of the page; shown: names of GantryCrane's outputs that are read at every point
  static async load(data, shown) {
    const system = new CraneSystem();
    [system.feedforward, system.crane] = await Promise.all(data.fmus.map(Fmu.load));
    const {feedforward, crane} = system;
    system.setpoints = feedforward.channel(data.links);
    system.inputs = crane.channel(data.links);
    system.slopesOut = feedforward.channel(data.links, data.orders);
    system.slopesIn = crane.channel(data.links, data.orders);
    system.nextEvent = feedforward.channel(["plan.next_event"]);
    system.shown = crane.channel(shown);
    system.names = shown;
    system.pending = [];
    return system;
  }

  // Both anew, at a time, with values by name of variable.
  begin(time, feedforward, crane) {
    this.time = time;
    this.pending = [];
    this.feedforward.begin(time, feedforward, () => {});
    this.beginCrane(crane);
  }

  // The crane alone anew, at the present time; `connect` is called before its initialisation ends.
  beginCrane(values, connect = () => {}) {
    this.crane.begin(this.time, values, () => {
      this.exchange();
      connect();
    });
    this.observe();
  }

  // New values of inputs and tunable parameters, from the present time on.
  change(fmu, values) {
    this.pending.push([fmu, values]);
  }

  // To a communication point.
  advance(end) {
    if (this.apply()) this.exchange();
    while (this.time < end) {
      const event = this.event;
      const within = this.time + CraneSystem.LEAST < event && event < end - CraneSystem.INSTANT;
      this.step(within ? event : end);
    }
    this.observe();
  }

  // To a communication point, the crane alone, with the inputs that it was given.
  advanceCrane(end) {
    this.apply();
    this.crane.step(this.time, end);
    this.time = end;
    this.observe();
  }

  // whether there were changes
  apply() {
    const due = this.pending;
    this.pending = [];
    for (const [fmu, values] of due) fmu.set(values);
    return due.length > 0;
  }

  step(end) {
    this.crane.values(this.slopesIn).set(this.feedforward.readSlopes(this.slopesOut));
    this.crane.writeSlopes(this.slopesIn);
    this.feedforward.step(this.time, end);
    this.crane.step(this.time, end);
    this.time = end;
    this.exchange();
  }

  // the setpoints of the present time, from the one to the other
  exchange() {
    const values = this.feedforward.read(this.setpoints);
    [this.event] = this.feedforward.read(this.nextEvent);
    this.crane.values(this.inputs).set(values);
    this.crane.write(this.inputs);
  }

  observe() {
    const values = this.crane.read(this.shown);
    this.state = Object.fromEntries(this.names.map((name, i) => [name, values[i]]));
  }
}
