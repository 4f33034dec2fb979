// The Task page: a script, its tree, its mistakes at their lines, and what scripts can be made of.
import { card, el, fill, getJson, put } from "./dom.js";
import { TreeView } from "./tree.js";

export function begin(app) {
  return new TaskPage(app);
}

class TaskPage {
  constructor(app) {
    this.app = app;
    this.tree = new TreeView({ title: "The tree", onLine: (line) => this.mark(line) });
    this.script = el("ol.script", {});
    this.mistakes = el("ul.mistakes", {});
    this.search = el("input", { type: "search", placeholder: "Filter actions and conditions", "aria-label": "Filter actions", oninput: () => this.showActions() });
    this.actions = el("div.actions", {});
    const scriptCard = card("The script", this.mistakes, el("div.scroll", {}, this.script));
    scriptCard.classList.add("scriptcard");
    const actionCard = card("What a script can be made of", this.search, el("div.scroll", {}, this.actions));
    this.element = el("div.task", {}, el("div.left", {}, scriptCard), el("div.middle", {}, this.tree.element), el("div.right", {}, actionCard));
  }
  async shown() {
    clearTimeout(this.timer);
    if (!this.element.isConnected) return;
    try {
      const json = await getJson("api/task");
      this.list ??= await getJson("api/actions");
      const key = JSON.stringify(json);
      if (key !== this.key) {
        this.key = key;
        this.show(json);
      }
    } catch (error) {
      this.app.say(error.message, "bad");
    }
    this.timer = setTimeout(() => this.shown(), 3000);
  }

  show({ file, text, tree, mistakes, notices }) {
    const found = [];
    for (const line of `${notices}\n${mistakes}`.split("\n")) {
      const match = /^(.*?):(\d+):(\d+): (error|warning|note)(\[\w+\])?: (.*)$/.exec(line);
      if (match) found.push({ file: match[1], line: Number(match[2]), kind: match[4], text: `${match[6]} ${match[5] ?? ""}`, more: [] });
      else if (found.length > 0 && line.trim()) found[found.length - 1].more.push(line);
    }
    const here = found.filter((one) => one.file === file || one.file.endsWith(file) || file.endsWith(one.file));
    fill(this.mistakes, found.map((one) => el("li", { "data-kind": one.kind, onclick: () => this.mark(one.line) }, el("b", {}, here.includes(one) ? `line ${one.line}` : `${one.file}, line ${one.line}`), ` ${one.text}`)));
    if (mistakes && found.length === 0) fill(this.mistakes, el("li", { "data-kind": "error" }, mistakes));
    if (!mistakes) this.mistakes.prepend(el("li", { "data-kind": "good" }, "No mistakes."));
    const lines = text.replace(/\n$/, "").split("\n");
    fill(this.script, lines.map((line, k) => {
      const wrong = here.filter((one) => one.line === k + 1);
      return el("li", { "data-line": k + 1, class: wrong.length > 0 ? "wrong" : null }, el("code", {}, line || " "),
        wrong.map((one) => el("div.mistake", { "data-kind": one.kind }, one.text, one.more.filter((more) => !/^\s*\^|^\s*\d* ?\|/.test(more)).map((more) => el("div", {}, more)))));
    }));
    if (tree) this.tree.show(tree);
    this.tree.state.textContent = "";
    put(this.tree.state, tree ? file : "The tree is drawn once the mistakes are mended.");
    this.showActions();
  }
  mark(line) {
    for (const item of this.script.children) item.classList.toggle("marked", Number(item.dataset.line) === line);
    this.script.querySelector(".marked")?.scrollIntoView({ block: "center" });
  }

  showActions() {
    if (!this.list) return;
    const wanted = this.search.value.toLowerCase();
    const parts = Object.entries(this.list).filter(([, list]) => Array.isArray(list)).map(([kind, list]) => {
      const shown = list.filter((one) => JSON.stringify(one).toLowerCase().includes(wanted));
      return shown.length === 0 ? null : el("section", {}, el("h3", {}, kind), shown.map((one) => this.action(one)));
    });
    fill(this.actions, parts);
  }
  action(one) {
    const parameters = Array.isArray(one.parameters) ? one.parameters : [];
    return el("details", {}, el("summary", {}, el("b", {}, one.name), ` ${one.help ?? one.meaning ?? ""}`),
      one.example ? el("pre", {}, one.example) : null,
      parameters.length > 0 ? el("table", {}, parameters.map((parameter) => el("tr", {}, ["name", "key", "default", "unit", "range", "least", "most", "help", "meaning"].filter((key) => parameter[key] !== undefined && parameter[key] !== "")
        .map((key) => el("td", { title: key }, typeof parameter[key] === "object" ? JSON.stringify(parameter[key]) : parameter[key]))))) : null,
      ["unit", "range", "ends_by_itself", "can_fail", "motors"].filter((key) => one[key] !== undefined).map((key) => el("p.note", {}, `${key.replaceAll("_", " ")}: ${typeof one[key] === "object" ? JSON.stringify(one[key]) : one[key]}`)));
  }
}
