// The page: what the program shows, as tabs; what it says of itself, above all of them.
import { add, el, fill, getJson, put } from "./dom.js";
import { LiveView } from "./live.js";
import { Store } from "./store.js";
import { Stream } from "./stream.js";

const names = { live: "Live", memory: "Memory", recording: "Recording", trials: "Trials", task: "Task" };
const modules = {
  memory: () => import("./memory.js"), recording: () => import("./recording.js"),
  trials: () => import("./trials.js"), task: () => import("./task.js"),
};
const at = (id) => document.getElementById(id);

class App {
  pages = new Map();

  async begin() {
    // The token has done its work: it need not stay where others can read it.
    if (location.search) history.replaceState(null, "", location.pathname + location.hash);
    try {
      this.what = await getJson("api/what");
    } catch (error) {
      this.say(`The program does not answer: ${error.message}`, "bad");
      setTimeout(() => location.reload(), 2000);
      return;
    }
    document.title = `${this.what.title} \u2013 Striate`;
    put(at("title"), this.what.title);
    fill(at("tabs"), this.what.pages.map((page) => el("a", { role: "tab", href: `#${page}`, "data-page": page }, names[page] ?? page)));
    if (this.what.pages.includes("live")) this.beginLive();
    window.addEventListener("hashchange", () => this.open());
    await this.open();
  }

  beginLive() {
    this.store = new Store();
    this.live = new LiveView({
      store: this.store,
      onTopics: () => this.want(),
      onPick: this.what.teaches ? (region, seen) => this.name(region, seen) : null,
    });
    this.controls();
    this.stream = new Stream({
      message: (topic, time_ns, value) => this.store.put(topic, time_ns, value),
      state: (state, why) => this.connection(state, why),
      status: (level, text) => this.say(text, level >= 2 ? "bad" : "warn", 4000),
      session: () => this.stateButtons(),
    });
    this.want();
    setInterval(() => this.mission(), 250);
  }

  want() {
    this.stream?.want(this.page === "live" ? this.live.topics() : ["/striate/task", "/striate/cycle", "/striate/wish"]);
  }

  async open() {
    const asked = location.hash.slice(1).split("?")[0];
    const page = this.what.pages.includes(asked) ? asked : this.what.pages[0];
    this.page = page;
    for (const tab of at("tabs").children) tab.setAttribute("aria-selected", String(tab.dataset.page === page));
    if (page === "live") {
      at("page").replaceChildren(this.live.element);
      this.live.run();
    } else {
      if (!this.pages.has(page)) {
        const { begin } = await modules[page]();
        this.pages.set(page, begin(this));
      }
      const view = this.pages.get(page);
      at("page").replaceChildren(view.element);
      view.shown?.();
    }
    this.want();
  }

  controls() {
    const button = (id, text, title, act) => el(`button.control`, { id, title, onclick: act }, text);
    const ask = (service) => async () => {
      try {
        const { success, message } = await this.stream.call(service);
        this.say(message, success ? "good" : "bad", 3000);
        if (service === "/striate/pause") this.paused = true;
        if (service === "/striate/resume") this.paused = false;
        this.stateButtons();
      } catch (error) {
        this.say(error.message, "bad", 4000);
      }
    };
    this.buttons = {
      pause: button("pause", "Pause", "The robot stands until somebody resumes (P)", ask("/striate/pause")),
      resume: button("resume", "Resume", "The task goes on (P)", ask("/striate/resume")),
      stop: button("stop", "Stop", "Ends the mission: its 'finally', then it stands (Esc)", ask("/striate/stop")),
    };
    at("controls").append(...Object.values(this.buttons));
    if (this.what.drives) {
      this.buttons.drive = button("drive", "Drive by keys", "W A S D or the arrow keys drive while this is on", () => this.driveByKeys());
      at("controls").prepend(this.buttons.drive);
    }
    this.keys = new Set();
    window.addEventListener("keydown", (event) => this.key(event, true));
    window.addEventListener("keyup", (event) => this.key(event, false));
    window.addEventListener("blur", () => this.keys.clear());
    this.stateButtons();
  }

  stateButtons() {
    const open = this.stream?.state === "open" && !this.ended;
    const { pause, resume, stop, drive } = this.buttons;
    pause.hidden = Boolean(this.paused);
    resume.hidden = !this.paused;
    for (const one of [pause, resume, stop]) one.disabled = !open;
    if (drive) drive.disabled = !open;
  }

  key(event, down) {
    if (event.target.closest?.("input, textarea, select, dialog")) return;
    const name = event.key.toLowerCase();
    const wheel = { w: "up", arrowup: "up", s: "down", arrowdown: "down", a: "left", arrowleft: "left", d: "right", arrowright: "right" }[name];
    if (wheel && this.driving) {
      event.preventDefault();
      if (down) this.keys.add(wheel);
      else this.keys.delete(wheel);
      return;
    }
    if (!down || event.repeat || event.ctrlKey || event.metaKey || event.altKey) return;
    if (name === "p") (this.paused ? this.buttons.resume : this.buttons.pause).click();
    if (name === "escape" && this.page === "live") this.buttons.stop.click();
  }

  driveByKeys() {
    if (this.driving) {
      clearInterval(this.driving);
      this.driving = null;
      this.stream.drive(0, 0);
      this.stream.endDriving();
    } else {
      this.stream.beginDriving();
      this.driving = setInterval(() => this.steer(), 100);
    }
    this.buttons.drive.setAttribute("aria-pressed", String(Boolean(this.driving)));
  }
  steer() {
    const has = (key) => this.keys.has(key);
    const forward = (has("up") ? 0.35 : 0) - (has("down") ? 0.2 : 0);
    const turn = (has("left") ? 0.6 : 0) - (has("right") ? 0.6 : 0);
    // Nothing pressed: once more zero, then nothing, and the task drives again.
    if (forward !== 0 || turn !== 0) this.steered = 3;
    else if (!this.steered) return;
    else --this.steered;
    this.stream.drive(forward, turn);
  }

  connection(state, why) {
    if (state === "open") {
      this.store.clear();
      this.ended = false;
      this.paused = false;
      if (this.gone) this.say("The robot is there again.", "good", 3000);
      this.gone = null;
    } else if (!this.gone) {
      const task = this.store.get("/striate/task");
      this.gone = task && task.state !== "running"
        ? `The mission has ended: ${task.state}${task.reason ? `, ${task.reason}` : ""}.`
        : why === "ended" ? "The program has ended the connection." : "The program is gone: it was killed, or the line to it is cut.";
      this.ended = Boolean(task && task.state !== "running");
      if (this.driving) this.driveByKeys();
      this.say(`${this.gone} What is shown is the last that it said. This page asks for it again and again.`, this.ended ? "good" : "bad");
    }
    this.stateButtons();
    this.mission();
  }

  mission() {
    const task = this.store.get("/striate/task");
    const wish = this.store.get("/striate/wish");
    const connected = this.stream.state === "open";
    document.body.dataset.connection = connected ? "open" : "gone";
    let text = "waits for the first cycle";
    let tone = "warn";
    if (!connected) [text, tone] = [this.ended ? `ended: ${this.store.get("/striate/task").state}` : "not connected", this.ended ? "good" : "bad"];
    else if (task && task.state !== "running") [text, tone] = [task.state, task.state === "succeeded" ? "good" : "bad"];
    else if (this.paused) [text, tone] = ["paused", "warn"];
    else if (wish) [text, tone] = [task?.action ? `runs: ${task.action}` : "runs", "good"];
    put(at("state"), text);
    at("state").dataset.tone = tone;
  }

  // A line across the page; for_ms: how long it stays, else until the next.
  say(text, tone = "warn", for_ms = 0) {
    const notice = at("notice");
    clearTimeout(this.noticeEnds);
    notice.hidden = false;
    notice.dataset.tone = tone;
    fill(notice, text);
    if (for_ms > 0) this.noticeEnds = setTimeout(() => {
      notice.hidden = true;
      if (this.gone) this.say(this.gone, this.ended ? "good" : "bad");
    }, for_ms);
  }
}

export { add };
window.striate = new App();
window.striate.begin();
