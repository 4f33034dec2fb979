// What is known of the robot now, and of its last minutes: the newest message of each channel, series for
// charts, the log. The Live page shows a store, whether a robot or a recording fills it.

const kKept_s = 180;
const kMostLog = 1000;
const kPoses = 100;

export class Store {
  constructor() {
    this.clear();
  }
  clear() {
    this.latest = new Map(); // by topic: {time_s, value}
    this.series = new Map(); // by name: [{t, v}], oldest first
    this.log = [];
    this.poses = [];
    this.nodes = [];         // of the task: {state, since_s, reason}
    this.changed = true;
    this.version = 0;
  }
  get(topic) {
    return this.latest.get(topic)?.value ?? null;
  }
  time(topic) {
    return this.latest.get(topic)?.time_s ?? null;
  }
  put(topic, time_ns, value) {
    const time_s = time_ns / 1e9;
    this.latest.set(topic, { time_s, value });
    this.changed = true;
    this.version++;
    const take = takers[topic];
    if (take) take(this, time_s, value);
  }
  add(name, t, v) {
    if (!this.series.has(name)) this.series.set(name, []);
    const list = this.series.get(name);
    if (list.length > 0 && t < list[list.length - 1].t) list.length = 0; // it began anew
    list.push({ t, v: Number.isFinite(v) ? v : null });
    while (list[0].t < t - kKept_s) list.shift();
  }
  // Where the robot was at that time, in the odometry frame.
  poseAt(time_s) {
    let best = this.poses[this.poses.length - 1] ?? null;
    for (let k = this.poses.length - 1; k >= 0; --k) {
      if (Math.abs(this.poses[k].t - time_s) > Math.abs(best.t - time_s)) break;
      best = this.poses[k];
    }
    return best;
  }
  pose() {
    return this.poses[this.poses.length - 1] ?? null;
  }
}

export const heading = ({ z, w }) => 2 * Math.atan2(z, w);
const stamp = ({ sec, nanosec }) => sec + nanosec * 1e-9;

const takers = {
  "/odom": (store, t, { header, pose, twist }) => {
    const { position, orientation } = pose.pose;
    store.poses.push({ t: stamp(header.stamp), x: position.x, y: position.y, heading: heading(orientation) });
    if (store.poses.length > kPoses) store.poses.shift();
    store.add("measured", t, twist.twist.linear.x);
  },
  "/striate/wish": (store, t, { wish, sent }) => {
    store.add("wished", t, wish.forward_m_s);
    store.add("sent", t, sent.forward_m_s);
  },
  "/striate/cycle": (store, t, { image_age_s }) => {
    store.add("image_age", t, image_age_s ?? NaN);
    const now = performance.now();
    if (store.lastCycle) store.add("cycle_ms", t, Math.min(now - store.lastCycle, 500));
    store.lastCycle = now;
  },
  "/pose": (store, t, { pose }) => store.add("sigma", t, Math.sqrt(Math.max(pose.covariance[0], pose.covariance[7], 0))),
  "/striate/seen": (store, t, { columns }) => {
    let nearest = Infinity;
    for (const { bearing_rad, obstacle_m } of columns) {
      if (obstacle_m !== null && Math.abs(bearing_rad) < 0.35) nearest = Math.min(nearest, obstacle_m);
    }
    store.add("clear_seen", t, nearest);
  },
  "/scan": (store, t, { ranges, angle_min, angle_increment }) => {
    let nearest = Infinity;
    for (const [k, range] of ranges.entries()) {
      if (Math.abs(angle_min + k * angle_increment) < Math.PI / 2 && range > 0) nearest = Math.min(nearest, range);
    }
    store.add("clear_laser", t, nearest);
  },
  "/log": (store, t, { stamp: at, level, name, msg }) => {
    const line = { t: stamp(at), level, name, text: msg };
    const last = store.log[store.log.length - 1];
    if (last && last.t > line.t + 1) store.log.length = 0;
    store.log.push(line);
    if (store.log.length > kMostLog) store.log.shift();
  },
  "/striate/task/nodes": (store, t, { states, reason }) => {
    store.nodes.length = states.length;
    for (const [k, state] of [...states].entries()) {
      const before = store.nodes[k];
      if (before && before.state === state) continue;
      store.nodes[k] = { state, since_s: t, reason: state === "f" ? reason : "" };
    }
  },
};
