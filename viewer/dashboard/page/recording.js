// The Recording page: the Live page at any cycle of a run, and the run as a whole above it.
import { drawChart } from "./charts.js";
import { Canvas, card, colour, el, fill, getJson, put, seconds, show } from "./dom.js";
import { LiveView } from "./live.js";
import { Store } from "./store.js";
import { decoderOf } from "./stream.js";

const whole = ["/odom", "/striate/wish", "/striate/cycle", "/log", "/striate/task", "/striate/task/nodes", "/pose"];
const kAgain_ms = 1000;

export function begin(app) {
  return new RecordingPage(app);
}

// Topic, time, length, bytes, one after the other; topics by the number of their channel.
function* framesOf(buffer, channels) {
  const view = new DataView(buffer);
  for (let at = 0; at + 16 <= buffer.byteLength;) {
    const channel = channels[view.getUint32(at, true)];
    const time_ns = Number(view.getBigUint64(at + 4, true));
    const length = view.getUint32(at + 12, true);
    yield { topic: channel.topic, time_ns, value: channel.decode(new Uint8Array(buffer, at + 16, length)) };
    at += 16 + length;
  }
}

// A whole run as it was read so far.
class Run {
  constructor(number, channels) {
    this.number = number;
    this.channels = channels;
    this.cycles = [];     // {t, number}
    this.store = new Store();
    this.events = [];     // {t, cycle, name, text, level}
    this.nodes = [];      // {t, states, reason}
    this.wishes = [];
    this.read = 0;
  }
  async more(about) {
    if (about.cycles <= this.read) return false;
    const response = await fetch(`api/recording/span?run=${this.number}&from=${this.read}&to=${about.cycles - 1}&topics=${whole.join(",")}`);
    if (!response.ok) throw new Error((await response.json()).error);
    for (const { topic, time_ns, value } of framesOf(await response.arrayBuffer(), this.channels)) {
      const t = time_ns / 1e9;
      if (topic === "/odom") this.add("measured", t, value.twist.twist.linear.x);
      else if (topic === "/pose") this.add("sigma", t, Math.sqrt(Math.max(value.pose.covariance[0], value.pose.covariance[7], 0)));
      else if (topic === "/striate/wish") {
        this.add("sent", t, value.sent.forward_m_s);
        this.add("wished", t, value.wish.forward_m_s);
        this.wishes.push({ t, ...value });
      } else if (topic === "/striate/cycle") {
        this.cycles.push({ t, number: value.number });
        this.add("image_age", t, value.image_age_s ?? NaN);
      } else if (topic === "/log") this.events.push({ t, name: value.name, text: value.msg, level: value.level });
      else if (topic === "/striate/task/nodes") this.nodes.push({ t, ...value });
    }
    this.read = about.cycles;
    return true;
  }
  add(name, t, v) {
    if (!this.store.series.has(name)) this.store.series.set(name, []);
    this.store.series.get(name).push({ t, v: Number.isFinite(v) ? v : null });
  }
  cycleAt(t) {
    let [low, high] = [0, Math.max(this.cycles.length - 1, 0)];
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.cycles[middle].t < t) low = middle + 1;
      else high = middle;
    }
    return low;
  }
  get end_s() {
    return this.cycles[this.cycles.length - 1]?.t ?? 0;
  }
}

class RecordingPage {
  constructor(app) {
    this.app = app;
    this.at = 0;
    this.shownRun = 0;
    this.store = new Store();
    this.live = new LiveView({ store: this.store, onTopics: () => this.go(this.at) });
    this.slider = el("input", { type: "range", min: 0, max: 0, value: 0, id: "scrub", "aria-label": "Cycle", oninput: () => this.go(Number(this.slider.value)) });
    this.place = el("output", { id: "place" }, "");
    this.speed = el("select", { "aria-label": "Speed" }, [0.25, 0.5, 1, 2, 5, 10].map((v) => el("option", { value: v, selected: v === 1 }, `${v}\u00d7`)));
    this.playButton = el("button", { id: "play", title: "Play or hold (space)", onclick: () => this.play() }, "Play");
    const step = (by, label, title) => el("button", { title, onclick: () => { this.hold(); this.go(this.at + by); } }, label);
    this.chart = new Canvas("Speed over the whole run");
    this.chart.element.addEventListener("click", ({ offsetX }) => this.pickTime(offsetX));
    this.about = el("p.note", {});
    this.jumps = el("div.switches.jumps", { role: "group", "aria-label": "Jump to" });
    this.difference = el("div.difference", {});
    this.bar = card("The run", this.about, el("div.transport", {}, step(-1, "\u25c0", "One cycle back (left arrow)"), this.playButton,
      step(1, "\u25b6", "One cycle on (right arrow)"), this.speed, this.slider, this.place), this.chart.box, this.jumps, this.difference);
    this.bar.classList.add("runbar");
    this.element = el("div.recording", {}, this.bar, this.live.element);
    this.live.log.list.addEventListener("click", (event) => {
      const t = event.target.closest("li")?.dataset.t;
      if (t) this.goTime(Number(t));
    });
    window.addEventListener("keydown", (event) => this.key(event));
    new ResizeObserver(() => this.paint()).observe(this.chart.box);
  }

  async shown() {
    this.live.run();
    clearTimeout(this.timer);
    if (!this.element.isConnected) return;
    try {
      await this.read();
    } catch (error) {
      this.app.say(error.message, "bad");
    }
    if (!this.done) this.timer = setTimeout(() => this.shown(), kAgain_ms);
  }

  async read() {
    this.channels ??= (await getJson("api/recording/channels")).channels.map((channel) => ({ ...channel, decode: decoderOf(channel) }));
    const { runs } = await getJson("api/recording");
    this.runs ??= runs.map((_, k) => new Run(k, this.channels));
    let news = false;
    for (const [k, about] of runs.entries()) news = (await this.runs[k].more(about)) || news;
    this.done = runs.every(({ done }) => done);
    const about = runs[this.shownRun];
    const run = this.runs[this.shownRun];
    put(this.about, `${about.task || about.name}${about.world ? ` in ${about.world}` : ""}${about.seed === undefined ? "" : `, seed ${about.seed}`}: ${about.cycles} cycles, ${seconds(run.end_s)}` +
      `${about.done ? "" : ", being read\u2026"}${about.done && !about.whole ? ", cut off: the run was killed or the disk was full" : ""}` +
      `${about.differs_in_cycle ? `; today's program decides otherwise from cycle ${about.differs_in_cycle} on` : ""}${about.error ? `; ${about.error}` : ""}`);
    if (!news && this.painted) return;
    this.slider.max = String(Math.max(0, run.cycles.length - 1));
    this.showJumps(run);
    await this.showDifference();
    if (!this.painted) await this.go(0);
    this.paint();
  }

  // What a person looks for first: where it stood, what failed, where it was held back.
  showJumps(run) {
    const jumps = [];
    let since = null;
    for (const [k, { t, v }] of (run.store.series.get("measured") ?? []).entries()) {
      const stands = Math.abs(v ?? 0) < 0.02;
      if (stands && since === null) since = { t, k };
      if (!stands && since !== null) {
        if (t - since.t > 1 && since.k > 0) jumps.push({ t: since.t + 0.2, text: `stood ${seconds(t - since.t)}`, kind: "stood" });
        since = null;
      }
    }
    for (const { t, name, text, level } of run.events) {
      if (level >= 30 || name === "mission") jumps.push({ t, text: name === "limiter" ? text : `${name}: ${text}`, kind: name });
    }
    jumps.sort((a, b) => a.t - b.t);
    fill(this.jumps, el("span.note", {}, "Jump to"), jumps.slice(0, 40).map(({ t, text, kind }) =>
      el("button.small", { "data-kind": kind, onclick: () => { this.hold(); this.goTime(t); } }, `${seconds(t)} ${text}`)));
    this.marks = jumps;
  }

  async showDifference() {
    if (this.runs.length < 2) return;
    const { compared, decided, moved } = await getJson("api/recording/difference");
    const jump = (cycle, label) => el("button.small", { onclick: () => this.go(cycle) }, label);
    const names = this.runs.map((_, k) => el("button.small", { "aria-pressed": String(k === this.shownRun), onclick: () => { this.shownRun = k; this.painted = false; this.shown(); } }, `run ${k + 1}`));
    fill(this.difference, el("span", {}, decided === null ? `Both decide the same in all ${compared} cycles that both have.` : `They decide otherwise from cycle ${decided + 1} on (${seconds(this.runs[0].cycles[decided]?.t)}).`),
      decided === null ? null : jump(decided, "Show it"), moved === null ? null : jump(moved, `They move otherwise from cycle ${moved + 1} on`), el("span.note", {}, "shown:"), names,
      decided === null ? null : el("table", {}, el("tr", {}, el("th", {}, ""), el("th", {}, "run 1"), el("th", {}, "run 2")),
        [["wanted", (w) => `${w.wish.forward_m_s.toFixed(3)} m/s, ${w.wish.turn_rad_s.toFixed(3)} rad/s`], ["sent", (w) => `${w.sent.forward_m_s.toFixed(3)} m/s, ${w.sent.turn_rad_s.toFixed(3)} rad/s`], ["because", (w) => w.why], ["held back by", (w) => w.limited_by || "nothing"]]
          .map(([name, of]) => el("tr", {}, el("th", {}, name), this.runs.map((run) => el("td", {}, run.wishes[decided] ? of(run.wishes[decided]) : "?"))))));
  }

  goTime(t) {
    return this.go(this.runs[this.shownRun].cycleAt(t));
  }
  async go(cycle) {
    const run = this.runs?.[this.shownRun];
    if (!run || run.cycles.length === 0) return;
    this.painted = true;
    this.at = Math.min(Math.max(cycle, 0), run.cycles.length - 1);
    this.slider.value = String(this.at);
    const { t, number } = run.cycles[this.at];
    put(this.place, `cycle ${number}, ${seconds(t)}`);
    this.paint();
    // One question at a time; the newest wish counts.
    if (this.asking) return;
    this.asking = true;
    try {
      for (let shown = -1; shown !== this.at;) {
        shown = this.at;
        const response = await fetch(`api/recording/cycle?run=${this.shownRun}&n=${shown}&topics=${this.live.topics().join(",")}`);
        if (!response.ok) throw new Error((await response.json()).error);
        this.fill(await response.arrayBuffer(), run, run.cycles[shown].t);
      }
    } catch (error) {
      this.app.say(`This cycle cannot be shown: ${error.message}`, "bad", 5000);
    } finally {
      this.asking = false;
    }
  }

  fill(buffer, run, t) {
    this.store.clear();
    for (const [name, list] of run.store.series) this.store.series.set(name, list.filter((one) => one.t <= t + 1e-6 && one.t > t - 61));
    this.store.log = run.events.filter((one) => one.t <= t + 1e-6);
    for (const { t: at, states, reason } of run.nodes) {
      if (at > t + 1e-6) break;
      for (const [k, state] of [...states].entries()) {
        if (this.store.nodes[k]?.state !== state) this.store.nodes[k] = { state, since_s: at, reason: state === "f" ? reason : "" };
      }
    }
    const log = this.store.log;
    const nodes = this.store.nodes;
    for (const { topic, time_ns, value } of framesOf(buffer, this.channels)) {
      if (topic !== "/log" && topic !== "/striate/task/nodes") this.store.put(topic, time_ns, value);
    }
    this.store.log = log;
    this.store.nodes = nodes;
    this.store.changed = true;
  }

  play() {
    if (this.playing) return this.hold();
    const run = this.runs?.[this.shownRun];
    if (!run) return;
    if (this.at >= run.cycles.length - 1) this.go(0);
    let [from_s, began] = [run.cycles[this.at].t, performance.now()];
    const speed = Number(this.speed.value);
    this.playing = setInterval(() => {
      const next = run.cycleAt(from_s + ((performance.now() - began) / 1000) * speed);
      this.go(next);
      if (next >= run.cycles.length - 1 && this.done) this.hold();
    }, 50);
    put(this.playButton, "Hold");
  }
  hold() {
    clearInterval(this.playing);
    this.playing = null;
    put(this.playButton, "Play");
  }
  key(event) {
    if (!this.element.isConnected || event.target.closest?.("input, select, textarea, button")) return;
    if (event.key === "ArrowLeft") this.go(this.at - 1);
    else if (event.key === "ArrowRight") this.go(this.at + 1);
    else if (event.key === " ") this.play();
    else return;
    event.preventDefault();
  }

  pickTime(x) {
    const run = this.runs?.[this.shownRun];
    if (!run) return;
    this.hold();
    this.goTime(((x - 26) / (this.chart.box.clientWidth - 28)) * run.end_s);
  }
  paint() {
    const run = this.runs?.[this.shownRun];
    if (!run || run.cycles.length === 0) return;
    this.chart.draw((context, width, height) => {
      drawChart(context, width, height, { least: 0, most: 0.7, lines: [["wished", "quiet"], ["sent", "way"], ["measured", "accent"]] }, run.store,
        { from: 0, to: run.end_s, mark: run.cycles[this.at].t });
      context.fillStyle = colour("bad");
      for (const { t } of this.marks ?? []) context.fillRect(26 + (t / Math.max(run.end_s, 1e-6)) * (width - 28) - 1, 0, 2, 5);
    });
  }
}
export { show };
