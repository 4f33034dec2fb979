// Elements of the page. All that comes from outside goes through show(): it is text, never HTML.

// Control characters and marks that turn the direction of text, or are not seen, as their names.
const hidden = /[\u0000-\u001f\u007f-\u009f\u00ad\u061c\u200b-\u200f\u2028-\u202f\u2060-\u206f\ufeff\ufff9-\ufffb]/g;

export function show(value) {
  return String(value ?? "").replace(hidden, (c) =>
    `\u27e8U+${c.codePointAt(0).toString(16).toUpperCase().padStart(4, "0")}\u27e9`);
}

// el("p.quiet", {title: "..."}, "text", child): strings become text nodes.
export function el(what, attributes = {}, ...children) {
  const [tag, ...classes] = what.split(".");
  const element = document.createElement(tag);
  if (classes.length > 0) element.className = classes.join(" ");
  for (const [name, value] of Object.entries(attributes)) {
    if (value === null || value === undefined || value === false) continue;
    if (name.startsWith("on")) element.addEventListener(name.slice(2), value);
    else if (name === "title" || name === "placeholder" || name.startsWith("aria-")) element.setAttribute(name, show(value));
    else element.setAttribute(name, value === true ? "" : value);
  }
  add(element, children);
  return element;
}

export function add(element, children) {
  for (const child of children.flat(Infinity)) {
    if (child === null || child === undefined || child === false) continue;
    element.append(child instanceof Node ? child : document.createTextNode(show(child)));
  }
  return element;
}

export function fill(element, ...children) {
  element.replaceChildren();
  return add(element, children);
}

// Changes nothing where it is the same: what is selected stays so.
export function put(element, text) {
  const shown = show(text);
  if (element.textContent !== shown) element.textContent = shown;
}

export const metres = (m, digits = 2) => (m === null || m === undefined || !Number.isFinite(m) ? "?" : `${m.toFixed(digits)} m`);
export const seconds = (s, digits = 1) => {
  if (s === null || s === undefined || !Number.isFinite(s)) return "?";
  if (s >= 120) return `${Math.floor(s / 60)} min ${String(Math.floor(s % 60)).padStart(2, "0")} s`;
  return `${s.toFixed(digits)} s`;
};

// A canvas that is as sharp as the screen; draw(context, width, height) in CSS pixels.
export class Canvas {
  constructor(label) {
    this.element = el("canvas", { role: "img", "aria-label": label });
    this.box = el("div.canvas", {}, this.element);
  }
  draw(paint) {
    const ratio = Math.min(window.devicePixelRatio || 1, 2);
    const { clientWidth: width, clientHeight: height } = this.box;
    if (width === 0 || height === 0) return;
    const [columns, rows] = [Math.round(width * ratio), Math.round(height * ratio)];
    if (this.element.width !== columns || this.element.height !== rows) {
      this.element.width = columns;
      this.element.height = rows;
    }
    const context = this.element.getContext("2d");
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.clearRect(0, 0, width, height);
    paint(context, width, height);
  }
}

let colours = null;
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => (colours = null));
// The style sheet's colours, for canvases.
export function colour(name) {
  colours ??= new Map();
  if (!colours.has(name)) colours.set(name, getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim());
  return colours.get(name);
}

export async function getJson(path) {
  return answerOf(await fetch(path, { cache: "no-store" }));
}

export async function postJson(path, body) {
  return answerOf(await fetch(path, {
    method: "POST", headers: { "Content-Type": "application/json" }, body: JSON.stringify(body),
  }));
}

async function answerOf(response) {
  const text = await response.text();
  let json = null;
  try {
    json = JSON.parse(text);
  } catch {
    throw new Error(text || `the program answers ${response.status}`);
  }
  if (!response.ok) throw new Error(json.error ?? `the program answers ${response.status}`);
  return json;
}

// A card with a heading.
export function card(title, ...children) {
  return el(`section.card`, { "aria-label": title }, el("h2", {}, title), ...children);
}
