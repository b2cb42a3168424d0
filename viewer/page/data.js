// SPDX-License-Identifier: Apache-2.0
// The data inside of a page: unpacked when it is asked for, each once.
const ilot = (window.ilot = { waiting: new Map(), unpacked: new Map() });

ilot.unpack = async function (text) {
  const letters = atob(text);
  const bytes = new Uint8Array(letters.length);
  for (let i = 0; i < letters.length; ++i) bytes[i] = letters.charCodeAt(i);
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
};

ilot.has = (name) => document.querySelector(`script[data-ilot="${name}"]`) !== null;

// Returns the bytes of the data of this name; null when the page has none.
ilot.bytes = function (name) {
  if (!ilot.unpacked.has(name)) {
    const element = document.querySelector(`script[data-ilot="${name}"]`);
    ilot.unpacked.set(name, element ? ilot.unpack(element.textContent) : Promise.resolve(null));
  }
  return ilot.unpacked.get(name);
};

ilot.parsed = new Map();
ilot.json = function (name) {
  if (!ilot.parsed.has(name))
    ilot.parsed.set(name, ilot.bytes(name).then((bytes) => (bytes ? JSON.parse(new TextDecoder().decode(bytes)) : null)));
  return ilot.parsed.get(name);
};

// Script files beside the page call this with their content.
ilot.tile = function (name, text) {
  const wait = ilot.waiting.get(name);
  if (wait) wait.done(ilot.unpack(text));
};

// Returns the bytes of a tile that is in the page or in a script file beside it.
ilot.tileBytes = function (tile) {
  if (!tile.file) return ilot.bytes(tile.name);
  if (!ilot.waiting.has(tile.name)) {
    const wait = {};
    wait.promise = new Promise((done, failed) => { wait.done = done; wait.failed = failed; });
    ilot.waiting.set(tile.name, wait);
    const script = document.createElement('script');
    script.src = tile.file;
    script.onerror = () => wait.failed(new Error(`${tile.file} is not beside this page`));
    document.head.append(script);
  }
  return ilot.waiting.get(tile.name).promise;
};

// Whole numbers as ilot packs them: seven bits a byte, the lowest first.
ilot.Numbers = class {
  constructor(bytes) { this.bytes = bytes; this.at = 0; }
  whole() {
    let value = 0, factor = 1;
    for (;;) {
      const byte = this.bytes[this.at++];
      value += (byte & 127) * factor;
      if (byte < 128 || this.at >= this.bytes.length) return value;
      factor *= 128;
    }
  }
  signed() {
    const value = this.whole();
    return value % 2 === 0 ? value / 2 : -(value + 1) / 2;
  }
  done() { return this.at >= this.bytes.length; }
};

// The columns of the points by name, and what is known of them.
ilot.points = async function () {
  const [scene, bytes] = await Promise.all([ilot.json('scene'), ilot.bytes('points')]);
  const about = scene.points;
  const types = { u8: Uint8Array, i8: Int8Array, u16: Uint16Array, u32: Uint32Array };
  const columns = {};
  for (const c of about.columns) columns[c.name] = new types[c.type](bytes.buffer, c.at, about.count);
  return { about, columns };
};

ilot.qualities = ['good', 'check', 'bad', 'none', ''];
ilot.qualityNames = ['good', 'check', 'bad', 'outline only', 'not judged'];

// The rank of a facade or object by what it states of itself, as a quality.
ilot.facadeQuality = (f) => (f.error_mm <= 0 ? 4 : f.error_mm <= 10 ? 0 : f.error_mm <= 30 ? 1 : 2);
ilot.objectQuality = (o) => (o[2] >= 800 ? 0 : o[2] >= 500 ? 1 : 2);

ilot.colour = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
ilot.make = function (tag, properties = {}, ...children) {
  const element = Object.assign(document.createElement(tag), properties);
  element.append(...children);
  return element;
};
