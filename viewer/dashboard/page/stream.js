// The robot as it runs: a client of the Foxglove WebSocket protocol, at the address of the page itself.
import { makeDecoder } from "./cdr.js";

const utf8 = new TextDecoder();
const kRetry_ms = [500, 1000, 2000, 3000];

export function decoderOf({ encoding, schema }) {
  return encoding === "json" ? (bytes) => JSON.parse(utf8.decode(bytes)) : makeDecoder(schema);
}

export class Stream {
  #wanted = new Set();
  #channels = new Map(); // by topic
  #topics = new Map();   // by subscription: its channel's id
  #services = new Map();
  #calls = new Map();
  #call = 0;
  #tries = 0;

  // on: {message(topic, timeNs, value), state(state, why), status(level, text), session()}
  constructor(on) {
    this.on = on;
    this.state = "begins";
    this.capabilities = [];
    this.#connect();
  }

  // These topics and no others: what nobody looks at is not made.
  want(topics) {
    this.#wanted = new Set(topics);
    this.#subscribe();
  }

  call(name) {
    const service = this.#services.get(name);
    if (!service || this.state !== "open") return Promise.reject(new Error("the robot does not hear"));
    const id = ++this.#call;
    const encoding = new TextEncoder().encode("json");
    const bytes = new Uint8Array(13 + encoding.length + 2);
    const view = new DataView(bytes.buffer);
    view.setUint8(0, 2);
    view.setUint32(1, service.id, true);
    view.setUint32(5, id, true);
    view.setUint32(9, encoding.length, true);
    bytes.set(encoding, 13);
    bytes.set(new TextEncoder().encode("{}"), 13 + encoding.length);
    this.socket.send(bytes);
    return new Promise((resolve, reject) => this.#calls.set(id, { resolve, reject }));
  }

  get drives() {
    return this.capabilities.includes("clientPublish");
  }
  beginDriving() {
    this.#say({ op: "advertise", channels: [{ id: 1, topic: "/cmd_vel", encoding: "json", schemaName: "geometry_msgs/msg/Twist" }] });
  }
  endDriving() {
    this.#say({ op: "unadvertise", channelIds: [1] });
  }
  drive(forward_m_s, turn_rad_s) {
    if (this.state !== "open") return;
    const text = JSON.stringify({ linear: { x: forward_m_s, y: 0, z: 0 }, angular: { x: 0, y: 0, z: turn_rad_s } });
    const payload = new TextEncoder().encode(text);
    const bytes = new Uint8Array(5 + payload.length);
    bytes[0] = 1;
    new DataView(bytes.buffer).setUint32(1, 1, true);
    bytes.set(payload, 5);
    this.socket.send(bytes);
  }

  #connect() {
    const scheme = location.protocol === "https:" ? "wss" : "ws";
    const socket = new WebSocket(`${scheme}://${location.host}/`, ["foxglove.sdk.v1"]);
    socket.binaryType = "arraybuffer";
    this.socket = socket;
    let opened = false;
    socket.onopen = () => {
      opened = true;
      this.#tries = 0;
      this.#topics.clear();
      this.#channels.clear();
      this.#turn("open");
    };
    socket.onmessage = ({ data }) => {
      try {
        if (typeof data === "string") this.#hear(JSON.parse(data));
        else this.#hearBytes(new Uint8Array(data));
      } catch (error) {
        this.on.status(2, `a message cannot be read: ${error.message}`);
      }
    };
    socket.onclose = ({ code }) => {
      for (const { reject } of this.#calls.values()) reject(new Error("the connection is gone"));
      this.#calls.clear();
      // A server that ends says so (1001, and a browser may see 1000 or 1005); one that is killed says nothing.
      if (opened) this.#turn("gone", code === 1006 ? "broke" : "ended");
      else if (this.state !== "gone") this.#turn("gone", "broke");
      const wait = kRetry_ms[Math.min(this.#tries++, kRetry_ms.length - 1)];
      setTimeout(() => this.#connect(), wait);
    };
  }

  #turn(state, why = "") {
    this.state = state;
    this.on.state(state, why);
  }
  #say(json) {
    if (this.state === "open") this.socket.send(JSON.stringify(json));
  }

  #hear(message) {
    switch (message.op) {
      case "serverInfo":
        this.capabilities = message.capabilities;
        this.on.session(message);
        break;
      case "advertise":
        for (const channel of message.channels) this.#channels.set(channel.topic, { ...channel, decode: decoderOf(channel) });
        this.#subscribe();
        break;
      case "advertiseServices":
        for (const service of message.services) this.#services.set(service.name, service);
        break;
      case "status":
        this.on.status(message.level, message.message);
        break;
      case "serviceCallFailure":
        this.#calls.get(message.callId)?.reject(new Error(message.message));
        this.#calls.delete(message.callId);
        break;
    }
  }

  #hearBytes(bytes) {
    const view = new DataView(bytes.buffer);
    if (bytes[0] === 1) {
      const channel = this.#topics.get(view.getUint32(1, true));
      if (channel) this.on.message(channel.topic, Number(view.getBigUint64(5, true)), channel.decode(bytes.subarray(13)));
    } else if (bytes[0] === 3) {
      const id = view.getUint32(5, true);
      const answer = JSON.parse(utf8.decode(bytes.subarray(13 + view.getUint32(9, true))));
      this.#calls.get(id)?.resolve(answer);
      this.#calls.delete(id);
    }
  }

  #subscribe() {
    if (this.state !== "open") return;
    const subscriptions = [];
    for (const topic of this.#wanted) {
      const channel = this.#channels.get(topic);
      if (!channel || this.#topics.has(channel.id)) continue;
      this.#topics.set(channel.id, channel);
      subscriptions.push({ id: channel.id, channelId: channel.id });
    }
    const no_more = [...this.#topics.values()].filter(({ topic }) => !this.#wanted.has(topic)).map(({ id }) => id);
    for (const id of no_more) this.#topics.delete(id);
    if (subscriptions.length > 0) this.#say({ op: "subscribe", subscriptions });
    if (no_more.length > 0) this.#say({ op: "unsubscribe", subscriptionIds: no_more });
  }
}
