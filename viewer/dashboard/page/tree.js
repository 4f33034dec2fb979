// A task as a tree that folds. Built once for a tree; then only states change.
import { card, el, put, seconds, show } from "./dom.js";

const words = { w: "waits", r: "runs", s: "succeeded", f: "failed", k: "skipped", h: "halted", "-": "" };
const signs = { w: "\u25cb", r: "\u25b6", s: "\u2713", f: "\u2717", k: "\u21b7", h: "\u25a0", "-": "\u00b7" };

export class TreeView {
  // onLine(line): a node was chosen; may be left out
  constructor({ title = "Task", onLine = null } = {}) {
    this.onLine = onLine;
    this.list = el("ul.tree", { role: "tree", "aria-label": "Steps of the task" });
    this.state = el("p.note", {}, "No task yet.");
    const all = (open) => () => {
      for (const item of this.list.querySelectorAll("li[aria-expanded]")) item.setAttribute("aria-expanded", String(open));
    };
    this.element = card(title, el("div.switches", {}, this.state,
      el("button.small", { onclick: all(true) }, "Unfold"), el("button.small", { onclick: all(false) }, "Fold")), this.list);
    this.element.classList.add("taskcard");
  }

  show(tree) {
    const key = JSON.stringify(tree);
    if (key === this.key) return;
    this.key = key;
    this.nodes = [];
    this.list.replaceChildren(this.#item(tree, 0));
  }

  #item(node, depth) {
    const sign = el("span.sign", {}, signs["-"]);
    const why = el("span.why", {});
    const folds = node.children.length > 0;
    const item = el("li", { role: "treeitem", "data-state": "-", "aria-expanded": folds ? "true" : null });
    this.nodes.push({ item, sign, why });
    const row = el("div.row", {
      onclick: () => this.onLine?.(node.line),
    }, folds ? el("button.fold", {
      "aria-label": `fold or unfold ${node.title}`,
      onclick: (event) => {
        event.stopPropagation();
        item.setAttribute("aria-expanded", String(item.getAttribute("aria-expanded") !== "true"));
      },
    }) : el("span.fold"), sign, el("div.words", {}, el("span.what", { title: `line ${node.line}` }, node.title), " ",
      node.limits ? el("span.limits", {}, node.limits) : null, " ", why));
    item.append(row);
    if (folds) item.append(el("ul", { role: "group" }, node.children.map((child) => this.#item(child, depth + 1))));
    return item;
  }

  // A task of a robot: its message, and the nodes' states.
  render(store) {
    const task = store.get("/striate/task");
    if (!task) return;
    this.show(task.tree);
    const said = task.state === "running" ? (task.action ? `runs: ${task.action}` : "runs") : `${task.state}${task.reason ? `: ${task.reason}` : ""}`;
    put(this.state, `${task.mission || "task"} ${said}`);
    this.state.dataset.state = task.state;
    this.states(store.nodes, store.time("/striate/wish") ?? 0, store.get("/striate/wish")?.why ?? "", task.action);
  }

  states(nodes, now_s, doing, action) {
    for (const [k, { item, sign, why }] of this.nodes.entries()) {
      const node = nodes[k] ?? { state: "-", since_s: 0, reason: "" };
      if (item.dataset.state !== node.state) {
        item.dataset.state = node.state;
        sign.textContent = signs[node.state];
        sign.title = words[node.state];
        sign.setAttribute("aria-label", words[node.state]);
      }
      const leaf = !item.querySelector("ul");
      let text = "";
      if (node.state === "r") text = `${seconds(Math.max(0, now_s - node.since_s))}${leaf && action && doing ? `, ${doing}` : ""}`;
      else if (node.state === "f") text = node.reason || "failed";
      else if (node.state === "h" || node.state === "k") text = words[node.state];
      put(why, text);
    }
  }
}
export { show };
