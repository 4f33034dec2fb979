// The Live page: a store as it is now. The Recording page shows another store with it.
import { CameraView } from "./camera.js";
import { ChartsView } from "./charts.js";
import { card, el, fill, metres, put, seconds } from "./dom.js";
import { FloorView } from "./floor.js";
import { TreeView } from "./tree.js";

const always = ["/odom", "/pose", "/trajectory", "/camera/left/image/compressed", "/map/local", "/obstacles", "/landmarks",
  "/battery", "/log", "/striate/task", "/striate/task/nodes", "/striate/wish", "/striate/memory/short_term",
  "/striate/memory/events", "/striate/cycle", "/striate/seen", "/scan"];

// What the limiter's reasons mean, for who reads them the first time.
const limits = {
  "gathers speed": "it may not speed up faster",
  "battery low": "the battery is low: it drives slowly, or stands",
  "near something": "something is near: it drives slowly there",
  "something remembered is in the way": "memory holds something in the way",
  "the newest image is old": "it does not drive blind: the newest image is too old",
  "the wish is old": "nothing has been wished lately",
  "motors stalled": "the motors were blocked: it does not push on",
  "sonar or laser": "sonar or laser feels something near: the emergency layer holds it",
  "bumper": "something touches the bumper",
};

class NowView {
  constructor() {
    this.speed = el("output.big", {}, "\u2013");
    this.bar = { measured: el("i.measured"), sent: el("i.sent"), wished: el("i.wished") };
    this.why = el("p.whyline", {});
    this.limit = el("p.limit", {});
    this.facts = el("dl.facts", {});
    this.element = card("Now", el("div.nowrow", {}, this.speed, el("div.bar", { title: "wished (outline), sent and driven (filled)" },
      this.bar.wished, this.bar.sent, this.bar.measured)), this.why, this.limit, this.facts);
    this.element.classList.add("now");
  }
  render(store) {
    const wish = store.get("/striate/wish");
    const odom = store.get("/odom");
    const cycle = store.get("/striate/cycle");
    const v = odom?.twist.twist.linear.x;
    put(this.speed, v === undefined ? "\u2013" : `${v.toFixed(2)} m/s`);
    const width = (element, value) => (element.style.width = `${Math.min(Math.abs(value ?? 0) / 0.75, 1) * 100}%`);
    width(this.bar.measured, v);
    width(this.bar.sent, wish?.sent.forward_m_s);
    width(this.bar.wished, wish?.wish.forward_m_s);
    if (wish) {
      const who = { pilot: "A person drives", guard: "A guard holds it", emergency: "The emergency layer holds it", nobody: "Nobody drives" }[wish.driver];
      put(this.why, [who, wish.why].filter(Boolean).join(": ") || "No wish.");
      const held = wish.limited_by;
      put(this.limit, held
        ? `${wish.wish.forward_m_s.toFixed(2)} m/s wished, ${wish.sent.forward_m_s.toFixed(2)} sent: ${limits[held] ?? held}`
        : "Nothing holds it back.");
      this.limit.dataset.held = String(Boolean(held) && held !== "gathers speed");
    }
    const battery = store.get("/battery");
    const memory = store.get("/striate/memory/short_term");
    const pose = store.pose();
    const rows = [
      ["Time", cycle ? `${seconds(cycle.time_s)}, cycle ${cycle.number}` : "?"],
      ["Image", cycle ? (cycle.image_age_s === null ? "none yet" : `${seconds(cycle.image_age_s, 2)} old`) + (cycle.refused ? `; refused: ${cycle.refused}` : "") : "?"],
      ["Way", memory ? `${metres(memory.corridor.progress_m)} along the corridor` : "?"],
      ["Place", pose ? `${metres(pose.x)}, ${metres(pose.y)}, ${((pose.heading * 180) / Math.PI).toFixed(0)}\u00b0` : "?"],
      ["Battery", battery ? `${battery.voltage.toFixed(1)} V` : "?"],
    ];
    if (cycle && (cycle.bumper || cycle.stalled)) rows.unshift(["Touch", cycle.bumper ? "the bumper is pressed" : "the motors are stalled"]);
    const key = JSON.stringify(rows);
    if (key !== this.rows) {
      this.rows = key;
      fill(this.facts, rows.map(([name, text]) => [el("dt", {}, name), el("dd", {}, text)]));
    }
  }
}

class LogView {
  constructor() {
    this.search = el("input", { type: "search", placeholder: "Filter", "aria-label": "Filter the log", oninput: () => (this.key = "") });
    this.list = el("ol.log", { tabindex: "0", "aria-label": "Log of decisions" });
    this.element = card("Decisions", this.search, this.list);
    this.element.classList.add("logcard");
  }
  render(store) {
    const last = store.log[store.log.length - 1];
    const key = `${store.log.length} ${last?.t} ${this.search.value}`;
    if (key === this.key) return;
    this.key = key;
    const wanted = this.search.value.toLowerCase();
    const lines = store.log.filter(({ name, text }) => `${name} ${text}`.toLowerCase().includes(wanted)).slice(-300).reverse();
    fill(this.list, lines.map(({ t, level, name, text }) => el("li", { "data-level": level >= 40 ? "error" : level >= 30 ? "warn" : "info", "data-t": t },
      el("time", {}, seconds(t)), el("b", {}, name), el("span", {}, text))));
    if (lines.length === 0) fill(this.list, el("li.none", {}, "Nothing decided yet."));
  }
}

class RegionsView {
  constructor() {
    this.list = el("table.regions", {});
    this.element = card("What it has in mind", this.list);
    this.element.classList.add("mind");
  }
  render(store) {
    const memory = store.get("/striate/memory/short_term");
    if (!memory || memory === this.shown) return;
    this.shown = memory;
    const degrees = (rad) => `${((rad * 180) / Math.PI).toFixed(0)}\u00b0`;
    fill(this.list, el("thead", {}, el("tr", {}, ["what", "where", "seen", "state"].map((name) => el("th", {}, name)))), el("tbody", {},
      memory.landmarks.map((one) => el("tr.landmark", {}, el("td", {}, one.name), el("td", {}, `${metres(one.distance_m)} at ${degrees(one.bearing_rad)}`),
        el("td", {}, one.seen_s_ago === null ? "not in this run" : `${seconds(one.seen_s_ago)} ago`),
        el("td", {}, one.confirmed ? "confirmed" : one.sightings > 0 ? `${one.sightings} looks` : "recalled"))),
      memory.salient_regions.map((one) => el("tr", {}, el("td", {}, `region ${one.id}`), el("td", {}, `${metres(one.distance_m)} at ${degrees(one.bearing_rad)}`),
        el("td", {}, `${seconds(one.seen_s_ago)} ago`), el("td", {}, one.inhibited ? "looked at lately" : `activation ${one.activation.toFixed(2)}`)))));
  }
}

export class LiveView {
  constructor({ onTopics = () => {}, onPick = null, store }) {
    this.store = store;
    this.camera = new CameraView({ onLayers: () => { this.store.changed = true; onTopics(); }, onPick });
    this.floor = new FloorView();
    this.charts = new ChartsView();
    this.tree = new TreeView();
    this.log = new LogView();
    this.now = new NowView();
    this.mind = new RegionsView();
    this.floor.scanOn.addEventListener("change", onTopics);
    this.element = el("div.live", {}, el("div.left", {}, this.camera.element, this.charts.element),
      el("div.middle", {}, this.now.element, this.floor.element), el("div.right", {}, this.tree.element, this.log.element, this.mind.element));
    this.parts = [this.camera, this.floor, this.charts, this.tree, this.log, this.now, this.mind];
    new ResizeObserver(() => (this.store.changed = true)).observe(this.element);
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => (this.store.changed = true));
  }
  topics() {
    return [...always, ...this.camera.topics(), ...this.floor.topics()];
  }
  // Once a frame of the screen at most.
  run() {
    const frame = () => {
      if (!this.element.isConnected) return (this.running = false);
      if (this.store.changed || this.floor.dirty) {
        this.store.changed = false;
        for (const part of this.parts) part.render(this.store);
      }
      requestAnimationFrame(frame);
    };
    if (this.running) return;
    this.running = true;
    this.store.changed = true;
    requestAnimationFrame(frame);
  }
}
