// The last minutes as lines, one small chart a thing.
import { Canvas, card, colour, el, put } from "./dom.js";

export const charts = [
  { title: "Speed", unit: "m/s", least: 0, most: 0.7, lines: [["wished", "quiet"], ["sent", "way"], ["measured", "accent"]] },
  { title: "Free ahead", unit: "m", least: 0, most: 4, lines: [["clear_laser", "quiet"], ["clear_seen", "accent"]] },
  { title: "Age of the image", unit: "s", least: 0, most: 0.3, lines: [["image_age", "accent"]] },
  { title: "Between cycles, here", unit: "ms", least: 0, most: 200, lines: [["cycle_ms", "accent"]] },
  { title: "Sure of its place to", unit: "m", least: 0, most: 0.3, lines: [["sigma", "accent"]] },
];
const names = { wished: "wished", sent: "sent", measured: "driven", clear_laser: "laser", clear_seen: "seen" };
const kShown_s = 60;

export class ChartsView {
  constructor() {
    this.parts = charts.map((chart) => {
      const canvas = new Canvas(`Chart: ${chart.title}`);
      const now = el("output", {}, "\u2013");
      const key = chart.lines.length > 1 ? el("span.key", {}, chart.lines.map(([name, of]) => [el(`i.${of}`), names[name]])) : null;
      return { chart, canvas, now, element: el("figure.chart", {}, el("figcaption", {}, el("span", {}, chart.title), key, now), canvas.box) };
    });
    this.element = card("The last minute", el("div.charts", {}, this.parts.map(({ element }) => element)));
    this.element.classList.add("chartcard");
  }
  render(store) {
    for (const { chart, canvas, now } of this.parts) {
      const newest = store.series.get(chart.lines[chart.lines.length - 1][0]);
      const value = newest?.[newest.length - 1]?.v ?? null;
      put(now, value === null ? "not known" : `${value.toFixed(chart.unit === "ms" ? 0 : 2)} ${chart.unit}`);
      canvas.draw((context, width, height) => drawChart(context, width, height, chart, store));
    }
  }
}

export function drawChart(context, width, height, chart, store, { from = null, to = null, mark = null } = {}) {
  const lists = chart.lines.map(([name]) => store.series.get(name) ?? []);
  const end = to ?? Math.max(0, ...lists.map((list) => list[list.length - 1]?.t ?? 0));
  const begin = from ?? end - kShown_s;
  let most = chart.most;
  let least = chart.least;
  for (const list of lists) {
    for (const { t, v } of list) {
      if (v === null || t < begin || t > end) continue;
      if (v < least) least = v;
      if (v > most) most = v;
    }
  }
  const room = 26;
  const x = (t) => room + ((t - begin) / Math.max(end - begin, 1e-6)) * (width - room - 2);
  const y = (v) => 4 + (1 - (v - least) / (most - least)) * (height - 8);
  context.font = "9px system-ui, sans-serif";
  context.fillStyle = colour("quiet");
  context.strokeStyle = colour("line");
  context.lineWidth = 1;
  for (const v of least < 0 ? [least, 0, most] : [least, (least + most) / 2, most]) {
    context.beginPath();
    context.moveTo(room, y(v));
    context.lineTo(width - 2, y(v));
    context.stroke();
    context.textAlign = "right";
    context.fillText(most >= 20 ? v.toFixed(0) : v.toFixed(most < 1 ? 2 : 1), room - 4, Math.min(Math.max(y(v) + 3, 8), height - 1));
  }
  context.textAlign = "left";
  for (const [k, [, of]] of chart.lines.entries()) {
    context.strokeStyle = colour(of);
    context.lineWidth = k === chart.lines.length - 1 ? 1.8 : 1.2;
    context.beginPath();
    let down = false;
    for (const { t, v } of lists[k]) {
      if (t < begin || t > end) continue;
      if (v === null) down = false;
      else {
        if (down) context.lineTo(x(t), y(v));
        else context.moveTo(x(t), y(v));
        down = true;
      }
    }
    context.stroke();
  }
  if (mark !== null) {
    context.strokeStyle = colour("bad");
    context.beginPath();
    context.moveTo(x(mark), 0);
    context.lineTo(x(mark), height);
    context.stroke();
  }
}
