// The Memory page: landmarks, the map, what happened. Read anew while a mission writes it.
import { Canvas, card, colour, el, fill, getJson, metres, postJson, put, seconds, show } from "./dom.js";
import { rgb } from "./floor.js";

const kAgain_ms = 5000;

export function begin(app) {
  return new MemoryPage(app);
}

class MemoryPage {
  constructor(app) {
    this.app = app;
    this.undo = [];
    this.search = el("input", { type: "search", placeholder: "Filter by name", "aria-label": "Filter landmarks", oninput: () => this.showList() });
    this.forgotten = el("input", { type: "checkbox", onchange: () => this.showList() });
    this.rows = el("tbody");
    this.count = el("span.note");
    this.list = card("Landmarks", el("div.switches", {}, this.search), el("div.switches", {}, el("label", {}, this.forgotten, "forgotten ones, too"), this.count),
      el("div.scroll", {}, el("table.landmarks", {}, el("thead", {}, el("tr", {}, ["", "name", "views", "strength", "activation", "place"].map((t) => el("th", {}, t)))), this.rows)));
    this.detail = card("About it", el("p.note", {}, "Choose a landmark."));
    this.detail.id = "about";
    this.map = new Canvas("Map of the memory: landmarks, routes, obstacles");
    this.mapCard = card("Map", this.map.box, el("p.note", {}, "Ellipses: how sure the place is (2 \u03c3). Lines: routes that were driven. Choose a landmark by a click."));
    this.map.element.addEventListener("click", (event) => this.pick(event));
    this.kind = el("select", { "aria-label": "Kind of episode", onchange: () => this.showEpisodes() }, el("option", { value: "" }, "all kinds"));
    this.episodeSearch = el("input", { type: "search", placeholder: "Filter what happened", "aria-label": "Filter episodes", oninput: () => this.showEpisodes() });
    this.episodeList = el("ol.log.episodes", { tabindex: "0" });
    this.undoButton = el("button", { id: "undo", hidden: true, onclick: () => this.takeBack() }, "Undo");
    this.element = el("div.memory", {}, el("div.left", {}, this.list), el("div.middle", {}, this.detail, this.mapCard),
      el("div.right", {}, (this.episodeCard = card("What happened", el("div.switches", {}, this.kind), this.episodeSearch, this.episodeList))));
    new ResizeObserver(() => this.paint()).observe(this.map.box);
  }

  async shown() {
    clearTimeout(this.timer);
    if (!this.element.isConnected) return;
    try {
      await this.read();
    } catch (error) {
      this.app.say(error.message, "bad");
    }
    this.timer = setTimeout(() => this.shown(), kAgain_ms);
  }

  async read() {
    const [memory, episodes] = await Promise.all([getJson("api/memory"), getJson("api/memory/episodes")]);
    const key = JSON.stringify([memory, episodes.length, episodes[0]?.id]);
    if (key === this.key) return;
    this.key = key;
    this.memory = memory;
    this.episodes = episodes;
    memory.landmarks.sort((a, b) => (b.activation ?? -1e9) - (a.activation ?? -1e9));
    this.byId = new Map(memory.landmarks.map((one) => [one.id, one]));
    const kinds = [...new Set(episodes.map(({ kind }) => kind))].sort();
    const chosen = this.kind.value;
    fill(this.kind, el("option", { value: "" }, "all kinds"), kinds.map((kind) => el("option", { value: kind, selected: kind === chosen }, kind)));
    const asked = new URLSearchParams(location.hash.split("?")[1] ?? "").get("name");
    if (!this.chosen && asked) this.chosen = memory.landmarks.find(({ name }) => name === asked)?.id;
    this.showList();
    this.showDetail();
    this.showEpisodes();
    this.paint();
  }

  showList() {
    if (!this.memory) return;
    const wanted = this.search.value.toLowerCase();
    const shown = this.memory.landmarks.filter((one) => (this.forgotten.checked || one.retired_s === null) && one.name.toLowerCase().includes(wanted));
    put(this.count, `${shown.length} of ${this.memory.landmarks.length}`);
    fill(this.rows, shown.map((one) => el("tr", {
      "data-name": one.name, "aria-selected": one.id === this.chosen ? "true" : null, class: one.retired_s === null ? null : "retired",
      tabindex: "0", onclick: () => this.choose(one.id), onkeydown: (event) => event.key === "Enter" && this.choose(one.id),
    }, el("td.thumb", {}, this.picture(one, one.looks.find(({ picture_bytes }) => picture_bytes > 0), "")),
    el("td.name", {}, one.name, one.pinned ? el("span.note", {}, " pinned") : null), el("td", {}, `${one.views}`),
    el("td", {}, el("meter", { min: 0, max: 1, value: one.strength, title: one.strength.toFixed(2) })),
    el("td", {}, one.activation === null ? "never used" : one.activation.toFixed(2)),
    el("td", {}, one.position ? `${metres(one.position.x_m, 1)}, ${metres(one.position.y_m, 1)}` : "unknown"))));
    if (shown.length === 0) fill(this.rows, el("tr", {}, el("td", { colspan: 6 }, this.memory.landmarks.length === 0 ? "It knows no landmark yet: teach one with 'striate teach'." : "None of that name.")));
  }

  picture(landmark, look, alt) {
    if (!look) return null;
    return el("img", { alt, loading: "lazy", src: `api/memory/picture?name=${encodeURIComponent(landmark.name)}&view=${look.id}` });
  }

  choose(id) {
    this.chosen = id;
    this.showList();
    this.showDetail();
    this.showEpisodes();
    this.paint();
  }

  showDetail() {
    const one = this.byId?.get(this.chosen);
    if (!one) return;
    const sigma = one.position ? Math.sqrt(one.position.var_x_m2 + one.position.var_y_m2) : null;
    const change = (what, label) => el("button", { onclick: () => this.change({ what, name: one.name }) }, label);
    const to = el("input", { type: "text", value: one.name, "aria-label": "New name", maxlength: 63 });
    fill(this.detail, el("h2", {}, "About it"), el("h3", {}, one.name),
      el("p.fate", {}, `It is ${one.kind}. ${one.fate[0].toUpperCase()}${one.fate.slice(1)}.`),
      el("ul.why", {}, one.why.map((line) => el("li", {}, line))),
      el("p", {}, one.position ? `On the map at ${metres(one.position.x_m)}, ${metres(one.position.y_m)}, sure to ${metres(sigma)}.` : "Its place is not known."),
      el("div.views", {}, one.looks.map((look) => el("figure", {}, this.view(one, look), el("figcaption", {},
        `${look.keypoints} keypoints${look.range_m === null ? "" : `, from ${metres(look.range_m)}`}${look.damaged ? ", damaged: not used" : ""}`)))),
      this.memory.changes ? el("div.changes", {},
        el("form", { onsubmit: (event) => { event.preventDefault(); this.change({ what: "rename", name: one.name, to: to.value }); } }, to, el("button", {}, "Rename")),
        one.retired_s === null ? change("forget", "Forget") : change("restore", "Restore"), this.undoButton) : el("p.note", {}, "It cannot be changed here."));
    this.undoButton.hidden = this.undo.length === 0;
  }

  // The view with its keypoints over it.
  view(landmark, look) {
    const canvas = el("canvas.view", { width: Math.round(look.width_px), height: Math.round(look.height_px), role: "img", "aria-label": "a view with its keypoints" });
    const context = canvas.getContext("2d");
    const points = () => getJson(`api/memory/keypoints?name=${encodeURIComponent(landmark.name)}&view=${look.id}`).then((list) => {
      context.strokeStyle = "#35d0ff";
      for (const [x, y] of list) {
        context.beginPath();
        context.arc(x, y, 2.5, 0, 7);
        context.stroke();
      }
    }, () => {});
    const image = this.picture(landmark, look.picture_bytes > 0 ? look : null, "");
    if (image) {
      image.removeAttribute("loading");
      image.onload = () => {
        context.drawImage(image, 0, 0, canvas.width, canvas.height);
        points();
      };
    } else {
      context.fillStyle = colour("sunken");
      context.fillRect(0, 0, canvas.width, canvas.height);
      points();
    }
    return canvas;
  }

  async change(asked) {
    try {
      const { done } = await postJson("api/memory/change", asked);
      const back = { rename: { what: "rename", name: asked.to, to: asked.name }, forget: { what: "restore", name: asked.name }, restore: { what: "forget", name: asked.name } }[asked.what];
      if (!this.takingBack) this.undo.push(back);
      this.app.say(done, "good", 4000);
      await this.read();
    } catch (error) {
      this.app.say(error.message, "bad");
    }
    this.undoButton.hidden = this.undo.length === 0;
  }
  async takeBack() {
    const last = this.undo.pop();
    if (!last) return;
    this.takingBack = true;
    await this.change(last);
    this.takingBack = false;
  }

  showEpisodes() {
    if (!this.episodes) return;
    const wanted = this.episodeSearch.value.toLowerCase();
    const about = this.byId.get(this.chosen)?.name;
    const list = this.episodes.filter((one) => (!this.kind.value || one.kind === this.kind.value) &&
      `${one.kind} ${one.landmark} ${one.text}`.toLowerCase().includes(wanted)).slice(0, 500);
    fill(this.episodeList, list.map((one) => el("li", { class: about && one.landmark === about ? "about" : null },
      el("time", { title: `session ${one.session ?? "by hand"}` }, `${one.session === null ? "" : `#${one.session} `}${seconds(one.time_s, 0)}`), el("b", {}, one.kind),
      el("span", {}, [one.landmark, one.text, one.x_m === null ? "" : `at ${metres(one.x_m, 1)}, ${metres(one.y_m ?? 0, 1)}`].filter(Boolean).join(" \u2013 ")))));
    if (list.length === 0) fill(this.episodeList, el("li.none", {}, "Nothing of that kind."));
  }

  paint() {
    if (!this.memory) return;
    this.map.draw((context, width, height) => {
      context.fillStyle = colour("sunken");
      context.fillRect(0, 0, width, height);
      const { cells, cell_m } = this.memory;
      const placed = this.memory.landmarks.filter((one) => one.position && one.retired_s === null);
      const xs = [...cells.map(([column]) => column * cell_m), ...placed.map(({ position }) => position.x_m)];
      const ys = [...cells.map(([, row]) => row * cell_m), ...placed.map(({ position }) => position.y_m)];
      if (xs.length === 0) {
        context.fillStyle = colour("quiet");
        context.font = "13px system-ui, sans-serif";
        context.fillText("No place is known yet.", 12, 22);
        this.at = null;
        return;
      }
      const ends = (list) => list.reduce(([a, b], v) => [Math.min(a, v), Math.max(b, v)], [Infinity, -Infinity]);
      const [[x0, x1], [y0, y1]] = [ends(xs), ends(ys)];
      const scale = Math.min((width - 60) / Math.max(x1 - x0, 1), (height - 40) / Math.max(y1 - y0, 1), 80);
      const at = (this.at = (x, y) => [width / 2 + (x - (x0 + x1) / 2) * scale, height / 2 - (y - (y0 + y1) / 2) * scale]);
      const [free, taken] = [rgb(colour("free")), rgb(colour("taken"))];
      for (const [column, row, odds] of cells) {
        const share = 1 / (1 + Math.exp(-odds));
        context.fillStyle = `rgb(${[0, 1, 2].map((k) => Math.round(free[k] + (taken[k] - free[k]) * share)).join(",")})`;
        const [x, y] = at(column * cell_m, (row + 1) * cell_m);
        context.fillRect(x, y, cell_m * scale + 0.5, cell_m * scale + 0.5);
      }
      context.strokeStyle = colour("way");
      for (const { from, to, successes, failures } of this.memory.routes) {
        const [a, b] = [this.byId.get(from)?.position, this.byId.get(to)?.position];
        if (!a || !b) continue;
        context.lineWidth = 1 + Math.min(successes, 5) / 2;
        context.setLineDash(failures > successes ? [4, 4] : []);
        context.beginPath();
        context.moveTo(...at(a.x_m, a.y_m));
        context.lineTo(...at(b.x_m, b.y_m));
        context.stroke();
      }
      context.setLineDash([]);
      context.font = "600 12px system-ui, sans-serif";
      for (const one of placed) {
        const { x_m, y_m, var_x_m2, cov_xy_m2, var_y_m2 } = one.position;
        const [x, y] = at(x_m, y_m);
        // Axes of the covariance.
        const mean = (var_x_m2 + var_y_m2) / 2;
        const half = Math.hypot((var_x_m2 - var_y_m2) / 2, cov_xy_m2);
        const angle = 0.5 * Math.atan2(2 * cov_xy_m2, var_x_m2 - var_y_m2);
        context.fillStyle = one.id === this.chosen ? colour("accent") : colour("good");
        context.globalAlpha = 0.25;
        context.beginPath();
        context.ellipse(x, y, Math.max(2 * Math.sqrt(mean + half) * scale, 3), Math.max(2 * Math.sqrt(Math.max(mean - half, 0)) * scale, 3), -angle, 0, 7);
        context.fill();
        context.globalAlpha = 1;
        context.beginPath();
        context.arc(x, y, 4, 0, 7);
        context.fill();
        context.fillText(show(one.name), x + 7, y + 4);
      }
      this.placed = placed;
    });
  }
  pick({ offsetX, offsetY }) {
    if (!this.at || !this.placed) return;
    const near = this.placed.map((one) => {
      const [x, y] = this.at(one.position.x_m, one.position.y_m);
      return { one, d: Math.hypot(x - offsetX, y - offsetY) };
    }).sort((a, b) => a.d - b.d)[0];
    if (near && near.d < 25) this.choose(near.one.id);
  }
}
