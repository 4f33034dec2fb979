// A simulated TurtleBot that speaks rosbridge through other people's client, roslib, is driven by `striate run`:
// rosbridge.mjs PACKAGES STRIATE TURTLEBOT WORK [WAY]
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { once } from "node:events";
import { writeFile } from "node:fs/promises";
import { createRequire } from "node:module";
import { createInterface } from "node:readline";
import { setTimeout as sleep } from "node:timers/promises";
import { Relay } from "./rosbridge_relay.mjs";

const [packages, striate, program, work, way] = process.argv.slice(2);
const require = createRequire(`${packages}/`);
const ROSLIB = require("roslib");
const { WebSocketServer } = require("ws");
const world = "config/worlds/short.yaml";

// What the two versions of ROS call the same, and how images come.
const dialects = {
  1: { type: (name) => name, stamp: (ns) => ({ secs: Number(ns / 10n ** 9n), nsecs: Number(ns % 10n ** 9n) }), p: "P" },
  2: {
    type: (name) => name.replace("/", "/msg/"),
    stamp: (ns) => ({ sec: Number(ns / 10n ** 9n), nanosec: Number(ns % 10n ** 9n) }),
    p: "p",
  },
};

async function until(what, wanted, patience_ms = 30_000) {
  const end = performance.now() + patience_ms;
  while (!wanted()) {
    assert.ok(performance.now() < end, `${what} did not come`);
    await sleep(10);
  }
}

// The robot: a program that drives in a world, and roslib to speak for it.
class TurtleBot {
  sees = true;
  #topics = {};
  constructor(ros, { raw, stamped, robot }) {
    this.ros = ros;
    this.raw = raw;
    this.stamped = stamped;
    this.body = spawn(program, [world, robot, raw ? "raw" : "jpeg"], { stdio: ["pipe", "pipe", "inherit"] });
    this.body.stdin.on("error", () => {});
    createInterface({ input: this.body.stdout }).on("line", (line) => this.#tell(JSON.parse(line)));
  }
  async join(url) {
    const line = new ROSLIB.Ros({ url });
    line.on("error", () => {});
    const joined = once(line, "connection");
    await joined;
    const { type } = dialects[this.ros];
    const image = this.raw ? ["", "sensor_msgs/Image"] : ["/compressed", "sensor_msgs/CompressedImage"];
    const topic = (name, kind) => new ROSLIB.Topic({ ros: line, name, messageType: type(kind) });
    for (const eye of ["left", "right"]) {
      this.#topics[eye] = topic(`/stereo/${eye}/image${image[0]}`, image[1]);
      this.#topics[`${eye}_info`] = topic(`/stereo/${eye}/camera_info`, "sensor_msgs/CameraInfo");
    }
    this.#topics.odom = topic("/odom", "nav_msgs/Odometry");
    this.#topics.scan = topic("/scan", "sensor_msgs/LaserScan");
    this.cmd_vel = topic("/cmd_vel", this.stamped ? "geometry_msgs/TwistStamped" : "geometry_msgs/Twist");
    this.cmd_vel.subscribe((message) => {
      const { linear, angular } = this.stamped ? message.twist : message;
      if (this.stamped) this.stamp = message.header.stamp;
      this.body.stdin.write(`${linear.x} ${angular.z}\n`);
    });
    this.line = line;
  }
  leave() {
    this.line?.close();
    this.line = undefined;
  }
  async end() {
    this.leave();
    this.body.stdin.end();
    await once(this.body, "exit");
  }
  #tell(felt) {
    this.felt = felt;
    if (!this.line?.isConnected) return;
    const { stamp, p } = dialects[this.ros];
    const header = (ns, frame_id) => ({ stamp: stamp(BigInt(ns)), frame_id });
    const say = (topic, message) => this.#topics[topic].publish(new ROSLIB.Message(message));
    const half = felt.heading / 2;
    say("odom", {
      header: header(felt.now, "odom"),
      child_frame_id: "base_link",
      pose: {
        pose: {
          position: { x: felt.x, y: felt.y, z: 0 },
          orientation: { x: 0, y: 0, z: Math.sin(half), w: Math.cos(half) },
        },
      },
      twist: { twist: { linear: { x: felt.forward, y: 0, z: 0 }, angular: { x: 0, y: 0, z: felt.turn } } },
    });
    say("scan", {
      header: header(felt.now, "base_link"),
      angle_min: -Math.PI,
      angle_increment: Math.PI / 180,
      range_min: 0.05,
      range_max: 30,
      ranges: felt.ranges,
    });
    if (!felt.seen || !this.sees) return;
    const { at, width, height, focal, u, v, baseline, left, right } = felt.seen;
    for (const [eye, data, place] of [["left", left, 0], ["right", right, baseline]]) {
      const projection = [focal, 0, u, -focal * place, 0, focal, v, 0, 0, 0, 1, 0];
      say(`${eye}_info`, { header: header(at, "eye"), width, height, [p]: projection });
      const raw = { height, width, encoding: "rgb8", is_bigendian: 0, step: 3 * width, data };
      say(eye, { header: header(at, "eye"), ...(this.raw ? raw : { format: "jpeg", data }) });
    }
  }
}

// The robot's settings for striate: the shipped ones, and where it is.
async function settings(name, url, { ros, raw, stamped, more = "" }) {
  const file = `${work}/${name.replace(/\W+/g, "_")}.yaml`;
  const end = raw ? "" : "/compressed";
  await writeFile(file, `
robot:
  outline: {front: 0.18 m, rear: 0.18 m, half_width: 0.18 m, corner: 0.15 m}
  max_forward: 0.5 m/s
  max_turn: 1.8 rad/s
  max_pan: 0 deg
  max_tilt: 0 deg
camera: {height: 0.9 m, resting_tilt: -6 deg}
rosbridge:
  url: ${url}
  ros: ${ros}
  stamped: ${stamped}
  topics:
    left_image: /stereo/left/image${end}
    right_image: /stereo/right/image${end}
    scan: /scan
  ${more}
`);
  return file;
}

// All that a story needs: server, robot and the program that drives it.
async function begin(name, kind, metres) {
  const relay = new Relay(WebSocketServer, 0);
  await relay.ready;
  const robot_file = await settings(name, relay.url, kind);
  const robot = new TurtleBot(kind.ros, { ...kind, robot: robot_file });
  await robot.join(relay.url);
  const words = ["run", "config/tasks/corridor.yaml", "--robot", robot_file, "--var", `way=${metres}`, "--json"];
  const mind = spawn(striate, words, { stdio: ["ignore", "pipe", "pipe"] });
  let said = "";
  let told = "";
  mind.stdout.on("data", (piece) => (said += piece));
  mind.stderr.on("data", (piece) => (told += piece));
  const ended = once(mind, "close").then(([code, signal]) => ({
    code,
    signal,
    told,
    result: said ? JSON.parse(said) : undefined,
  }));
  return { relay, robot, mind, ended };
}

const moves = ({ twists }) => twists.at(-1)?.x > 0.1;
const ros2 = { ros: 2, raw: false, stamped: true };
const ros1 = { ros: 1, raw: true, stamped: false };

async function drives(name, kind, metres, most_s) {
  const { relay, robot, ended } = await begin(name, kind, metres);
  const began = performance.now();
  const { code, told, result } = await ended;
  const took_s = (performance.now() - began) / 1000;
  assert.equal(code, 0, `${told} ${JSON.stringify(result)}`);
  assert.equal(result.outcome, "success");
  assert.ok(took_s < most_s, `${took_s} s`);
  const { driven, collisions, beyond } = robot.felt;
  assert.ok(driven > parseFloat(metres) - 0.3, `driven ${driven} m`);
  assert.equal(collisions, 0);
  assert.equal(relay.twists.at(-1).x, 0, "the last twist is zero");
  assert.deepEqual(relay.statuses, []);
  if (kind.stamped) {
    // In the robot's own time, as well as we can know it.
    const late_s = Number(BigInt(robot.felt.now) / 10n ** 6n) / 1e3 - (robot.stamp.sec + robot.stamp.nanosec / 1e9);
    assert.ok(Math.abs(late_s) < 5, `stamped ${late_s} s ago`);
  }
  await robot.end();
  await relay.kill();
  console.log(`${name}: drove ${driven.toFixed(2)} m in ${took_s.toFixed(1)} s${beyond ? ", beyond the goal line" : ""}`);
}

async function isLookedAt() {
  const relay = new Relay(WebSocketServer, 0);
  await relay.ready;
  const robot_file = await settings("looked", relay.url, ros1);
  const robot = new TurtleBot(1, { ...ros1, robot: robot_file });
  await robot.join(relay.url);
  const doctor = spawn(striate, ["doctor", "--robot", robot_file], { stdio: ["ignore", "pipe", "inherit"] });
  let said = "";
  doctor.stdout.on("data", (piece) => (said += piece));
  await once(doctor, "close"); // its code tells of the whole machine
  assert.match(said, /good {3}ws:.*images of \d+ x \d+ and odometry come/);
  assert.deepEqual(relay.twists, [], "nothing was told to move");
  await robot.end();
  await relay.kill();
  console.log("the doctor finds it good");
}

async function standsWithoutImages() {
  const { relay, robot, ended } = await begin("blind", { ...ros2, more: "lost: 2 s" }, "8 m");
  await until("motion", () => moves(relay));
  robot.sees = false;
  const blind = performance.now();
  await until("a stand", () => relay.twists.at(-1).x === 0);
  const moved = relay.twists.filter(({ x }) => x !== 0).at(-1).at - blind;
  assert.ok(moved < 1200, `moved for ${moved} ms without images`);
  const { code, result } = await ended;
  assert.equal(code, 1);
  assert.equal(result.outcome, "lost");
  assert.match(result.reason, /the robot is lost: no images on \/stereo\/left\/image\/compressed/);
  assert.equal(relay.twists.at(-1).x, 0);
  await robot.end();
  await relay.kill();
  console.log(`images stop: it was told to stand after ${moved.toFixed(0)} ms, and lost after 2 s`);
}

async function losesAServerThatDies() {
  const { relay, robot, ended } = await begin("dies", { ...ros2, more: "lost: 2 s" }, "8 m");
  await until("motion", () => moves(relay));
  await relay.kill();
  const { code, result } = await ended;
  assert.equal(code, 1);
  assert.equal(result.outcome, "lost");
  assert.match(result.reason, /the robot is lost: no line to ws:/);
  await robot.end();
  console.log("a server that dies: the robot is lost");
}

async function holdsWhenAServerIsBack() {
  const { relay, robot, mind, ended } = await begin("back", { ...ros2, more: "lost: 20 s" }, "8 m");
  await until("motion", () => moves(relay));
  const { port } = relay;
  robot.leave();
  await relay.kill();
  const again = new Relay(WebSocketServer, port);
  await again.ready;
  await robot.join(again.url);
  await until("it comes back", () => again.twists.length > 0);
  await sleep(1500);
  assert.ok(again.twists.every(({ x }) => x === 0), "nothing resumes by itself");
  mind.kill("SIGUSR1"); // somebody has looked at the robot
  await until("it goes on", () => moves(again));
  mind.kill("SIGINT");
  const { code } = await ended;
  assert.equal(code, 130);
  assert.equal(again.twists.at(-1).x, 0);
  await robot.end();
  await again.kill();
  console.log("a server that is back: it holds until it is reset, and Ctrl-C ends with zero");
}

async function isStoppedWhenTheMindDies() {
  const { relay, robot, mind, ended } = await begin("killed", ros1, "8 m");
  await until("motion", () => moves(relay));
  mind.kill("SIGKILL");
  const killed = performance.now();
  await until("the keeper's zero", () => relay.twists.at(-1).x === 0, 3000);
  const took = relay.twists.find(({ at, x }) => at > killed && x === 0).at - killed;
  await ended;
  await robot.end();
  await relay.kill();
  console.log(`a mind that is killed: its keeper says zero after ${took.toFixed(0)} ms`);
}

if (way) {
  await drives("the whole corridor", ros2, way, 300);
} else {
  await drives("ROS 2, JPEG and TwistStamped", ros2, "3 m", 120);
  await drives("ROS 1, raw images and Twist", ros1, "2 m", 120);
  await isLookedAt();
  await standsWithoutImages();
  await losesAServerThatDies();
  await holdsWhenAServerIsBack();
  await isStoppedWhenTheMindDies();
}
process.exit(0);
