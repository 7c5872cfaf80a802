"use strict";
// One FMU of FMI 2.0 for co-simulation, as a WebAssembly library.

// bytes from the page: deflated, in letters of base64
async function unpacked(text) {
  const packed = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

// A function that C can call takes a module of its own: this one imports "e" "f" with `count`
// parameters of i32 and without a result, and exports it.
function callable(call, count) {
  const i32 = 0x7f, section = (id, ...content) => [id, content.length, ...content];
  const code = [
    0, 0x61, 0x73, 0x6d, 1, 0, 0, 0,
    ...section(1, 1, 0x60, count, ...Array(count).fill(i32), 0),
    ...section(2, 1, 1, 0x65, 1, 0x66, 0, 0),
    ...section(7, 1, 1, 0x66, 0, 0),
  ];
  return new WebAssembly.Instance(new WebAssembly.Module(new Uint8Array(code)), {e: {f: call}}).exports.f;
}

class Fmu {
  static OK = 0;
  static WARNING = 1;

  // description: of the page's data
  static async load(description) {
    const fmu = new Fmu();
    fmu.name = description.name;
    fmu.variables = description.variables;
    fmu.message = "";
    const files = {"start.bin": await unpacked(description.start)};
    const host = wasi(() => fmu.library.memory, files, (text) => console.warn(text));
    const code = await unpacked(description.code);
    const {instance} = await WebAssembly.instantiate(code, {wasi_snapshot_preview1: host});
    fmu.library = instance.exports;
    fmu.library._initialize();
    fmu.instantiate(description.guid);
    return fmu;
  }

  instantiate(guid) {
    const table = this.library.__indirect_function_table;
    const logger = table.grow(1);
    // environment, instance, status, category, message, further arguments
    table.set(logger, callable((_e, _i, status, _c, message) => this.hear(status, message), 6));
    const COSIMULATION = 1;
    const callbacks = this.room(5 * 4);
    new Uint32Array(this.library.memory.buffer, callbacks, 5).set([logger, 0, 0, 0, 0]);
    this.component = this.library.fmi2Instantiate(
      this.text(this.name), COSIMULATION, this.text(guid), this.text("/"), callbacks, 0, 1);
    if (!this.component) throw new Error(`${this.name}: ${this.message}`);
  }

  hear(status, message) {
    const bytes = new Uint8Array(this.library.memory.buffer);
    const text = new TextDecoder().decode(bytes.slice(message, bytes.indexOf(0, message)));
    // it is a format of printf
    if (status > Fmu.WARNING) this.message = text.replaceAll("%%", "%");
  }

  room(size) {
    const place = this.library.malloc(size);
    if (!place) throw new Error(`${this.name}: out of memory`);
    return place;
  }

  text(words) {
    const bytes = new TextEncoder().encode(`${words}\0`), place = this.room(bytes.length);
    new Uint8Array(this.library.memory.buffer, place, bytes.length).set(bytes);
    return place;
  }

  call(name, ...words) {
    this.message = "";
    if (this.library[`fmi2${name}`](this.component, ...words) > Fmu.WARNING) {
      throw new Error(`${this.name}: ${this.message || `${name} failed`}`);
    }
  }

  // Variables of one type, orders of their derivatives or none, with memory for their values.
  channel(names, orders = null) {
    const count = names.length * (orders ?? 1), kind = this.variables[names[0]][1];
    const made = {count, kind, references: this.room(4 * count), values: this.room(8 * count), orders: 0};
    const words = new Uint32Array(this.library.memory.buffer, made.references, count);
    words.forEach((_, i) => { [words[i]] = this.variables[names[i % names.length]]; });
    if (orders !== null) {
      made.orders = this.room(4 * count);
      new Int32Array(this.library.memory.buffer, made.orders, count).forEach((_, i, all) => {
        all[i] = 1 + Math.floor(i / names.length);
      });
    }
    return made;
  }

  // the numbers of a channel; memory that has grown has another buffer
  values(channel) {
    const Numbers = channel.kind === "Real" ? Float64Array : Int32Array;
    return new Numbers(this.library.memory.buffer, channel.values, channel.count);
  }

  read(channel) {
    this.call(`Get${channel.kind}`, channel.references, channel.count, channel.values);
    return this.values(channel);
  }

  write(channel) {
    this.call(`Set${channel.kind}`, channel.references, channel.count, channel.values);
  }

  readSlopes(channel) {
    this.call("GetRealOutputDerivatives", channel.references, channel.count, channel.orders, channel.values);
    return this.values(channel);
  }

  writeSlopes(channel) {
    this.call("SetRealInputDerivatives", channel.references, channel.count, channel.orders, channel.values);
  }

  // values by name, one after the other
  set(values) {
    for (const [name, value] of Object.entries(values)) {
      this.own ??= {};
      const channel = this.own[name] ??= this.channel([name]);
      this.values(channel)[0] = Number(value);
      this.write(channel);
    }
  }

  // until the end of initialisation mode, in which `connect` is called
  begin(time, settings, connect) {
    this.call("Reset");
    this.set(settings);
    this.call("SetupExperiment", 0, 0.0, time, 0, 0.0);
    this.call("EnterInitializationMode");
    connect();
    this.call("ExitInitializationMode");
  }

  step(time, end) {
    this.call("DoStep", time, end - time, 1);
  }
}
