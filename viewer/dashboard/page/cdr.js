// Messages of ROS 2 from their bytes (CDR 1, little-endian) and the schema that the server sends along.

const numbers = {
  bool: [1, (v, at) => v.getUint8(at) !== 0], byte: [1, (v, at) => v.getUint8(at)],
  uint8: [1, (v, at) => v.getUint8(at), Uint8Array], int8: [1, (v, at) => v.getInt8(at), Int8Array],
  uint16: [2, (v, at) => v.getUint16(at, true), Uint16Array], int16: [2, (v, at) => v.getInt16(at, true), Int16Array],
  uint32: [4, (v, at) => v.getUint32(at, true), Uint32Array], int32: [4, (v, at) => v.getInt32(at, true), Int32Array],
  float32: [4, (v, at) => v.getFloat32(at, true), Float32Array], float64: [8, (v, at) => v.getFloat64(at, true), Float64Array],
  uint64: [8, (v, at) => Number(v.getBigUint64(at, true))], int64: [8, (v, at) => Number(v.getBigInt64(at, true))],
};
const kHead = 4; // bytes of encapsulation; numbers are aligned behind them
const text = new TextDecoder();

class Reader {
  constructor(bytes) {
    this.bytes = bytes;
    this.view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    this.at = kHead;
  }
  align(size) {
    const over = (this.at - kHead) % size;
    if (over !== 0) this.at += size - over;
  }
  number([size, read]) {
    this.align(size);
    const value = read(this.view, this.at);
    this.at += size;
    return value;
  }
  string() {
    const length = this.number(numbers.uint32);
    const value = text.decode(this.bytes.subarray(this.at, this.at + Math.max(0, length - 1)));
    this.at += length;
    return value;
  }
  list(kind, count) {
    const [size, read, Typed] = kind;
    if (count === 0) return Typed ? new Typed(0) : [];
    this.align(size);
    const from = this.at;
    this.at += size * count;
    if (this.at > this.bytes.length) throw new Error("a message is cut off");
    if (!Typed) return Array.from({ length: count }, (_, k) => read(this.view, from + k * size));
    return new Typed(this.bytes.slice(from, this.at).buffer);
  }
}

// The schema's types: its own first, then "MSG: pkg/Name" behind a line of 80 '='.
function typesOf(schema) {
  const types = new Map();
  for (const [index, part] of schema.split(/^={80}\n/m).entries()) {
    const lines = part.split("\n").map((line) => line.trim()).filter((line) => line && !line.startsWith("#"));
    const name = index === 0 ? "" : lines.shift().replace(/^MSG:\s*/, "");
    types.set(name, lines.filter((line) => !line.includes("=")).map((line) => {
      const [, type, list, count, field] = /^([\w/]+)(\[(?:<=)?(\d*)\])?\s+(\w+)/.exec(line);
      return { type, field, isList: Boolean(list), count: count ? Number(count) : null };
    }));
  }
  return types;
}

export function makeDecoder(schema) {
  const types = typesOf(schema);
  const find = (type) => types.get(type) ?? types.get(type.replace("/msg/", "/"));
  const readOne = (reader, type) => {
    if (type === "string") return reader.string();
    const number = numbers[type];
    return number ? reader.number(number) : readFields(reader, find(type));
  };
  const readFields = (reader, fields) => {
    const message = {};
    for (const { type, field, isList, count } of fields) {
      if (!isList) {
        message[field] = readOne(reader, type);
        continue;
      }
      const length = count ?? reader.number(numbers.uint32);
      const number = numbers[type];
      if (number) message[field] = reader.list(number, length);
      else {
        // Each takes a byte at least: a length that is only claimed takes no memory.
        if (length > reader.bytes.length) throw new Error("a message is cut off");
        message[field] = Array.from({ length }, () => readOne(reader, type));
      }
    }
    return message;
  };
  return (bytes) => readFields(new Reader(bytes), types.get(""));
}
