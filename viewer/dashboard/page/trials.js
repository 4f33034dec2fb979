// The Trials page: the table, where runs failed, and how each is driven again.
import { Canvas, card, colour, el, fill, getJson, metres, put, seconds, show } from "./dom.js";

export function begin(app) {
  return new TrialsPage(app);
}

class TrialsPage {
  constructor(app) {
    this.app = app;
    this.table = el("div.markdown", {});
    this.map = new Canvas("Where runs failed");
    this.map.element.addEventListener("click", (event) => this.pick(event));
    this.world = el("select", { "aria-label": "World", onchange: () => this.show() }, el("option", { value: "" }, "all worlds"));
    this.only = el("input", { type: "checkbox", id: "failed", onchange: () => this.show() });
    this.rows = el("tbody");
    this.detail = card("The run", el("p.note", {}, "Choose a run."));
    this.element = el("div.trials", {}, el("div.left", {}, card("The table", this.table), card("Where runs touched something", this.map.box, el("p.note", {}, "Along the corridor to the right, left of its middle up. Choose a run by a click."))),
      el("div.right", {}, card("Runs", el("div.switches", {}, this.world, el("label", {}, this.only, "only those that failed")),
        el("div.scroll", {}, el("table.runs", {}, el("thead", {}, el("tr", {}, ["world", "seed", "what came of it", "way", "time", "nearest"].map((t) => el("th", {}, t)))), this.rows))), this.detail));
    new ResizeObserver(() => this.paint()).observe(this.map.box);
  }
  async shown() {
    clearTimeout(this.timer);
    if (!this.element.isConnected) return;
    try {
      const json = await getJson("api/trials");
      const key = JSON.stringify(json);
      if (key !== this.key) {
        this.key = key;
        this.runs = json.runs;
        const chosen = this.world.value;
        fill(this.world, el("option", { value: "" }, "all worlds"), [...new Set(json.runs.map(({ name }) => name))].map((name) => el("option", { value: name, selected: name === chosen }, name)));
        this.showTable(json.table);
        this.show();
      }
    } catch (error) {
      this.app.say(error.message, "bad");
    }
    this.timer = setTimeout(() => this.shown(), 5000);
  }
  // The table is the one that 'striate trial' prints.
  showTable(text) {
    const lines = text.split("\n");
    const rows = lines.filter((line) => line.startsWith("|") && !/^\|[\s|-]+$/.test(line)).map((line) => line.split("|").slice(1, -1).map((cell) => cell.trim()));
    fill(this.table, el("div.scroll", {}, el("table", {}, rows.map((cells, k) => el("tr", {}, cells.map((cell) => el(k === 0 ? "th" : "td", {}, cell)))))),
      lines.filter((line) => line && !line.startsWith("|")).map((line) => el(line.startsWith("- ") ? "p.item" : "p", {}, line)));
  }
  shownRuns() {
    return this.runs.filter((one) => (!this.world.value || one.name === this.world.value) && (!this.only.checked || one.outcome !== "success"));
  }
  show() {
    if (!this.runs) return;
    const runs = this.shownRuns();
    fill(this.rows, runs.map((one) => el("tr", { "data-outcome": one.outcome, "aria-selected": one === this.chosen ? "true" : null, tabindex: "0",
      onclick: () => this.choose(one), onkeydown: (event) => event.key === "Enter" && this.choose(one) },
    el("td", {}, one.name), el("td", {}, `${one.seed ?? ""}`), el("td", {}, one.in_words), el("td", {}, metres(one.distance_m, 1)), el("td", {}, seconds(one.duration_s, 0)), el("td", {}, metres(one.nearest_pass_m)))));
    if (runs.length === 0) fill(this.rows, el("tr", {}, el("td", { colspan: 6 }, "No run.")));
    this.paint();
  }
  choose(one) {
    this.chosen = one;
    this.show();
    const copy = el("button.small", { onclick: async () => {
      try {
        await navigator.clipboard.writeText(one.command);
        put(copy, "Copied");
      } catch {
        put(copy, "Mark it and copy it");
      }
    } }, "Copy");
    fill(this.detail, el("h2", {}, "The run"), el("h3", {}, `${one.name}, seed ${one.seed}`), el("p", {}, one.in_words),
      el("p", {}, `${metres(one.distance_m)} in ${seconds(one.duration_s)}, nearest pass ${metres(one.nearest_pass_m)}, ${one.emergency_stops} emergency stops, longest stand ${seconds(one.longest_stand_s)}${one.longest_stand_why ? ` (${one.longest_stand_why})` : ""}.`),
      (one.collisions ?? []).map((hit) => el("p", {}, `Touched ${hit.hit} after ${seconds(hit.time_s)} at ${metres(hit.along_m)} along, ${metres(hit.left_m)} left.`)),
      el("p.note", {}, "This drives it again, the same bit for bit; add --record run.rec, and 'striate view run.rec' shows each cycle:"), el("pre.command", {}, one.command), copy);
  }
  paint() {
    if (!this.runs) return;
    this.map.draw((context, width, height) => {
      context.fillStyle = colour("sunken");
      context.fillRect(0, 0, width, height);
      const hits = this.shownRuns().flatMap((one) => (one.collisions ?? []).map((hit) => ({ one, hit })));
      const long = Math.max(10, ...this.shownRuns().map(({ distance_m }) => distance_m), ...hits.map(({ hit }) => hit.along_m));
      const x = (along) => 20 + (along / long) * (width - 40);
      const y = (left) => height / 2 - (left / 1.5) * (height / 2 - 18);
      context.strokeStyle = colour("line");
      context.fillStyle = colour("quiet");
      context.font = "10px system-ui, sans-serif";
      for (let along = 0; along <= long; along += long > 30 ? 10 : 2) {
        context.beginPath();
        context.moveTo(x(along), 4);
        context.lineTo(x(along), height - 14);
        context.stroke();
        context.fillText(`${along} m`, x(along) - 8, height - 3);
      }
      this.dots = hits.map(({ one, hit }) => ({ one, x: x(hit.along_m), y: y(hit.left_m) }));
      for (const dot of this.dots) {
        context.fillStyle = dot.one === this.chosen ? colour("accent") : colour("bad");
        context.beginPath();
        context.arc(dot.x, dot.y, dot.one === this.chosen ? 7 : 5, 0, 7);
        context.fill();
      }
      if (hits.length === 0) {
        context.fillStyle = colour("good");
        context.font = "13px system-ui, sans-serif";
        context.fillText("Nothing was touched.", 24, height / 2);
      }
    });
  }
  pick({ offsetX, offsetY }) {
    const near = (this.dots ?? []).map((dot) => ({ dot, d: Math.hypot(dot.x - offsetX, dot.y - offsetY) })).sort((a, b) => a.d - b.d)[0];
    if (near && near.d < 20) this.choose(near.dot.one);
  }
}
export { show };
