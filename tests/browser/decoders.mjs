// What messages of ours mean, by other people's code: each is decoded by the schema that came with it, and
// each schema of ROS 2 compared with the public definition of its type.
import assert from "node:assert/strict";

export function makeDecoders(require) {
  const { parse } = require("@foxglove/rosmsg");
  const { MessageReader } = require("@foxglove/rosmsg2-serialization");
  const { ros2humble } = require("@foxglove/rosmsg-msgs-common");
  const Ajv = require("ajv/dist/2020").default;

  const text = (bytes) => new TextDecoder("utf-8", { fatal: true }).decode(bytes);

  // Names and types of fields; constants and defaults have no bytes.
  const layout = (definition) =>
    definition.definitions
      .filter((field) => !field.isConstant)
      .map(({ name, type, isArray, arrayLength, isComplex }) =>
        [name, type, Boolean(isArray), arrayLength ?? 0, Boolean(isComplex)]);

  function checkSchema(schema) {
    const types = parse(text(schema.data), { ros2: true });
    for (const [index, type] of types.entries()) {
      const name = index === 0 ? schema.name.replace("/msg/", "/") : type.name.replace("/msg/", "/");
      const known = ros2humble[name];
      assert.ok(known, `${name} is a type of ROS 2`);
      const plain = (field) => field.map((v) => (typeof v === "string" ? v.replace("/msg/", "/") : v));
      assert.deepEqual(layout(type).map(plain), layout(known).map(plain), name);
    }
    return types;
  }

  class Decoders {
    #known = new Map();
    #ajv = new Ajv({ strict: true, allowUnionTypes: true });
    decode(channel, schema, data) {
      if (!this.#known.has(channel.id)) this.#known.set(channel.id, this.#make(channel, schema));
      return this.#known.get(channel.id)(data);
    }
    #make(channel, schema) {
      if (channel.messageEncoding === "cdr") {
        assert.equal(schema.encoding, "ros2msg");
        const reader = new MessageReader(checkSchema(schema));
        return (data) => reader.readMessage(data);
      }
      assert.equal(channel.messageEncoding, "json");
      assert.equal(schema.encoding, "jsonschema");
      const validate = this.#ajv.compile(JSON.parse(text(schema.data)));
      return (data) => {
        const message = JSON.parse(text(data));
        assert.ok(validate(message), `${channel.topic}: ${JSON.stringify(validate.errors)}`);
        return message;
      };
    }
  }
  return new Decoders();
}
