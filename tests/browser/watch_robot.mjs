// Robots that run, seen and led by other people's client: watch_robot.mjs PACKAGES STRIATE WORK
// Ten viewers under both subprotocols, one that never reads and one that floods, change no bit of a run.
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { once } from "node:events";
import { readFile } from "node:fs/promises";
import { createRequire } from "node:module";
import { makeDecoders } from "./decoders.mjs";

const [packages, striate, work] = process.argv.slice(2);
const require = createRequire(`${packages}/`);
const { FoxgloveClient } = require("@foxglove/ws-protocol");
const { WebSocket } = require("ws");
const { MessageWriter } = require("@foxglove/rosmsg2-serialization");
const { ros2humble } = require("@foxglove/rosmsg-msgs-common");

const corridor = ["run", "config/tasks/corridor.yaml", "--world", "config/worlds/short.yaml", "--seed", "3"];

// A program that tells its address; `ended` is its exit code.
async function start(words) {
  const child = spawn(striate, [...words, "--foxglove", "0"], { stdio: ["ignore", "ignore", "pipe"] });
  const ended = once(child, "exit").then(([code]) => code);
  let said = "";
  const url = await new Promise((resolve, reject) => {
    child.stderr.on("data", (piece) => {
      said += piece;
      const found = /ws:\S+/.exec(said);
      if (found) resolve(found[0]);
    });
    child.on("exit", () => reject(new Error(`no address: ${said}`)));
  });
  return { url, ended };
}

const decoders = makeDecoders(require);
const heavy = /image|disparity|saliency/;

// Subscribes to all channels, or to all but pictures, and decodes all that comes.
class Viewer {
  topics = new Map();
  times = [];
  statuses = [];
  #channels = new Map();
  #waiting = [];
  constructor(url, protocol, { pictures = true } = {}) {
    this.socket = new WebSocket(url, [protocol]);
    this.client = new FoxgloveClient({ ws: this.socket });
    this.client.on("serverInfo", (info) => (this.info = info));
    this.client.on("advertiseServices", (services) => (this.services = services));
    this.client.on("advertise", (channels) => {
      assert.equal(this.socket.protocol, protocol);
      for (const channel of channels) {
        if (heavy.test(channel.topic) && !pictures) continue;
        this.#channels.set(this.client.subscribe(channel.id), channel);
      }
    });
    this.client.on("time", ({ timestamp }) => this.times.push(timestamp));
    this.client.on("status", (status) => this.statuses.push(status));
    this.client.on("message", (message) => this.#take(message));
    this.ended = new Promise((resolve, reject) => {
      this.client.on("close", resolve);
      // Who still has much to read when the robot ends is not waited for.
      this.client.on("error", (error) => (error.code === "ECONNRESET" ? resolve() : reject(error)));
    });
  }
  #take({ subscriptionId, timestamp, data }) {
    const { topic, encoding, schemaName, schema, schemaEncoding } = this.#channels.get(subscriptionId);
    if (heavy.test(topic) && this.all(topic).length >= 3) return; // seen enough; this machine may be busy
    const value = decoders.decode(
      { id: topic, topic, messageEncoding: encoding },
      { name: schemaName, encoding: schemaEncoding, data: new TextEncoder().encode(schema) },
      new Uint8Array(data.buffer, data.byteOffset, data.byteLength),
    );
    if (!this.topics.has(topic)) this.topics.set(topic, []);
    this.topics.get(topic).push({ value, timestamp });
    this.#waiting = this.#waiting.filter(({ wanted, resolve }) => !wanted() || resolve());
  }
  all(topic) {
    return this.topics.get(topic)?.map(({ value }) => value) ?? [];
  }
  // Until messages have made it true.
  until(what, wanted) {
    const late = this.ended.then(() => assert.ok(wanted(), `${what}, before the end`));
    return Promise.race([late, new Promise((resolve) => this.#waiting.push({ wanted, resolve }))]);
  }
  call(name, encoding) {
    const service = this.services.find((one) => one.name === name);
    const answer = new Promise((resolve) => this.client.on("serviceCallResponse", resolve));
    const data = new TextEncoder().encode(encoding === "json" ? "{}" : "\0\u0001\0\0\0");
    this.client.sendServiceCallRequest({ serviceId: service.id, callId: 5, encoding, data });
    return answer;
  }
}

function checkValues(viewer) {
  const { topics, times, info } = viewer;
  assert.ok(info.capabilities.includes("time"));
  const cycles = viewer.all("/striate/cycle");
  assert.ok(cycles.length > 5, `${cycles.length} cycles`);
  assert.ok(times.at(-1) >= topics.get("/striate/cycle").at(-1).timestamp, "the time is that of the messages");
  for (const [k, cycle] of cycles.entries()) assert.ok(k === 0 || cycle.number > cycles[k - 1].number);
  const last = topics.get("/odom").at(-1);
  const { x } = last.value.pose.pose.position;
  assert.ok(x > 1.0 && x < 5.5, `driven to x = ${x} m`);
  const { sec, nanosec } = last.value.header.stamp;
  assert.ok(last.timestamp - (BigInt(sec) * 1_000_000_000n + BigInt(nanosec)) < 1_000_000_000n);
  assert.equal(viewer.all("/striate/task").at(-1).tree.title, "task corridor");
  for (const topic of ["/tf", "/cmd_vel", "/scan", "/sonar", "/map/local", "/trajectory", "/battery", "/diagnostics",
    "/obstacles", "/striate/wish", "/striate/memory/short_term"]) {
    assert.ok(viewer.all(topic).length > 0, topic);
  }
}

function checkPictures(viewer) {
  for (const side of ["left", "right"]) {
    const { format, data } = viewer.all(`/camera/${side}/image/compressed`).at(-1);
    const { width, height } = viewer.all(`/camera/${side}/camera_info`).at(-1);
    assert.equal(format, "png");
    const view = new DataView(data.buffer, data.byteOffset);
    assert.deepEqual([view.getUint32(16), view.getUint32(20)], [width, height]);
  }
  const { image } = viewer.all("/stereo/disparity").at(-1);
  assert.equal(image.data.length, image.step * image.height);
  assert.ok(viewer.all("/saliency").length > 0);
}

// Without what the clock on the wall says.
async function result(file) {
  const { mean_cycle_ms, realtime_factor, ...rest } = JSON.parse(await readFile(file, "utf8"));
  return rest;
}

async function tenViewersChangeNothing() {
  const drive = [...corridor, "--var", "way=4 m"];
  const alone = spawn(striate, [...drive, "--quiet", "--result", `${work}/alone.json`, "--record", `${work}/alone.rec`]);
  assert.deepEqual(await once(alone, "exit"), [0, null]);
  const robot = await start(
    [...drive, "--quiet", "--real-time", "--result", `${work}/seen.json`, "--record", `${work}/seen.rec`]);
  // One subscribes to all and never reads; one floods.
  const deaf = new WebSocket(robot.url, ["foxglove.sdk.v1"]);
  const flood = new WebSocket(robot.url, ["foxglove.sdk.v1"]);
  for (const socket of [deaf, flood]) socket.on("error", () => {}); // both are let go without a word
  await Promise.all([once(deaf, "open"), once(flood, "open")]);
  deaf.pause();
  const subscriptions = Array.from({ length: 26 }, (_, id) => ({ id, channelId: id }));
  deaf.send(JSON.stringify({ op: "subscribe", subscriptions }));
  for (let k = 0; k < 5000; ++k) flood.send('{"op":"subscribe","subscriptions":[{"id":1,"channelId":4}]}');
  const viewers = Array.from({ length: 8 }, (_, k) =>
    new Viewer(robot.url, k % 2 ? "foxglove.websocket.v1" : "foxglove.sdk.v1", { pictures: k < 2 }));
  const [code] = await Promise.all([robot.ended, ...viewers.map(({ ended }) => ended), once(flood, "close")]);
  assert.equal(code, 0);
  for (const viewer of viewers) checkValues(viewer);
  for (const viewer of viewers.slice(0, 2)) checkPictures(viewer);
  assert.equal(viewers.at(-1).all("/striate/task").at(-1).state, "succeeded");
  assert.deepEqual(await result(`${work}/seen.json`), await result(`${work}/alone.json`));
  assert.ok((await readFile(`${work}/seen.rec`)).equals(await readFile(`${work}/alone.rec`)), "the recordings are the same");
  deaf.terminate();
  console.log("ten viewers, one of them deaf and one flooding: the run is the same, bit for bit");
}

async function aViewerLeads() {
  const robot = await start([...corridor, "--quiet", "--real-time", "--foxglove-drive"]);
  const viewer = new Viewer(robot.url, "foxglove.websocket.v1", { pictures: false });
  await viewer.until("it moves", () => viewer.all("/odom").at(-1)?.twist.twist.linear.x > 0.2);
  const drivers = () => viewer.all("/striate/wish").at(-1)?.driver;

  const cdr = new MessageWriter([ros2humble["geometry_msgs/Twist"], ros2humble["geometry_msgs/Vector3"]].map((type) => ({ ...type })));
  const zero = { x: 0, y: 0, z: 0 };
  const twist = cdr.writeMessage({ linear: { ...zero, x: -0.1 }, angular: zero });
  const channel = viewer.client.advertise({ topic: "/cmd_vel", encoding: "cdr", schemaName: "geometry_msgs/msg/Twist" });
  const steering = setInterval(() => viewer.client.sendMessage(channel, twist), 100);
  await viewer.until("the pilot drives", () => drivers() === "pilot");
  await viewer.until("it goes back", () => viewer.all("/odom").at(-1).twist.twist.linear.x < -0.05);
  clearInterval(steering);
  await viewer.until("the task drives again", () => drivers() === "behaviour");

  const paused = await viewer.call("/striate/pause", "json");
  assert.equal(JSON.parse(new TextDecoder().decode(paused.data)).success, true);
  await viewer.until("it stands", () => Math.abs(viewer.all("/odom").at(-1).twist.twist.linear.x) < 0.001);
  assert.equal(drivers(), "pilot");
  await viewer.call("/striate/resume", "cdr");
  await viewer.until("it goes on", () => viewer.all("/odom").at(-1).twist.twist.linear.x > 0.1);

  viewer.client.getParameters([], "all");
  const { parameters } = await new Promise((resolve) => viewer.client.on("parameterValues", resolve));
  assert.ok(parameters.length > 50, `${parameters.length} settings`);
  await viewer.call("/striate/stop", "cdr");
  assert.equal(await robot.ended, 130);
  await viewer.ended;
  assert.equal(viewer.all("/striate/task").at(-1).state, "interrupted");
  assert.deepEqual(viewer.statuses.filter(({ level }) => level === 2), []);
  console.log("a viewer drives, pauses, resumes and stops");
}

async function aRecordingIsHeldAndGoesOn() {
  const robot = await start(["replay", `${work}/alone.rec`, "--speed", "2"]);
  const viewer = new Viewer(robot.url, "foxglove.sdk.v1", { pictures: false });
  const number = () => viewer.all("/striate/cycle").at(-1)?.number;
  await viewer.until("it runs", () => number() > 3);
  assert.ok(!viewer.info.capabilities.includes("clientPublish"), "nobody drives a recording");
  await viewer.call("/striate/pause", "cdr");
  await new Promise((resolve) => setTimeout(resolve, 300)); // what is under way arrives
  const held = number();
  await new Promise((resolve) => setTimeout(resolve, 500)); // ten cycles at this speed
  assert.equal(number(), held);
  await viewer.call("/striate/resume", "cdr");
  assert.equal(await robot.ended, 0, "the decisions are the same");
  await viewer.ended;
  assert.equal(viewer.all("/striate/task").at(-1).state, "succeeded");
  console.log("a recording is shown, held and goes on");
}

await tenViewersChangeNothing();
await aRecordingIsHeldAndGoesOn();
await aViewerLeads();
process.exit(0);
