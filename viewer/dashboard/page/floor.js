// The floor from above, round the robot: the map of short-term memory and what stands on it.
import { Canvas, card, colour, el, metres, show } from "./dom.js";
import { heading } from "./store.js";

const kFront_m = 0.21, kRear_m = 0.3, kHalfWidth_m = 0.2125; // of a Pioneer 3-DX

export class FloorView {
  constructor() {
    this.canvas = new Canvas("Map from above");
    this.scale = 46; // pixels a metre
    this.shift = { x: 0, y: 0 };
    const zoom = (factor) => () => {
      this.scale = Math.min(Math.max(this.scale * factor, 6), 300);
      this.dirty = true;
    };
    this.follow = el("button.small", { title: "Back to the robot", onclick: () => { this.shift = { x: 0, y: 0 }; this.dirty = true; } }, "Centre");
    this.scanOn = el("input", { type: "checkbox", "data-layer": "scan", onchange: () => (this.dirty = true) });
    this.element = card("Map from above", this.canvas.box, el("div.switches", {},
      el("button.small", { title: "Nearer", onclick: zoom(1.3) }, "+"), el("button.small", { title: "Farther", onclick: zoom(1 / 1.3) }, "\u2212"),
      this.follow, el("label", {}, this.scanOn, "Laser and sonar"),
      el("span.key", {}, el("i.free"), "free", el("i.taken"), "in the way", el("i.unknown"), "unknown", el("i.way"), "driven")));
    this.element.classList.add("floor");
    this.#listen();
  }

  topics() {
    return this.scanOn.checked ? ["/scan", "/sonar"] : [];
  }

  #listen() {
    const canvas = this.canvas.element;
    let drag = null;
    canvas.addEventListener("pointerdown", (event) => {
      drag = { x: event.clientX - this.shift.x, y: event.clientY - this.shift.y };
      canvas.setPointerCapture(event.pointerId);
    });
    canvas.addEventListener("pointermove", (event) => {
      if (!drag) return;
      this.shift = { x: event.clientX - drag.x, y: event.clientY - drag.y };
      this.dirty = true;
    });
    canvas.addEventListener("pointerup", () => (drag = null));
    canvas.addEventListener("wheel", (event) => {
      event.preventDefault();
      this.scale = Math.min(Math.max(this.scale * Math.exp(-event.deltaY / 500), 6), 300);
      this.dirty = true;
    }, { passive: false });
  }

  render(store) {
    this.dirty = false;
    this.canvas.draw((context, width, height) => this.#paint(context, width, height, store));
  }

  #paint(context, width, height, store) {
    context.fillStyle = colour("sunken");
    context.fillRect(0, 0, width, height);
    const pose = store.pose();
    if (!pose) {
      context.fillStyle = colour("quiet");
      context.font = "13px system-ui, sans-serif";
      context.fillText("No odometry yet.", 12, 22);
      return;
    }
    // Odometry frame: x up on the screen, y to the left.
    const centre = { x: width / 2 + this.shift.x, y: height * 0.62 + this.shift.y };
    this.at = (x, y) => [centre.x - (y - pose.y) * this.scale, centre.y - (x - pose.x) * this.scale];
    this.#grid(context, store.get("/map/local"));
    this.#rings(context, pose, width, height);
    this.#corridor(context, store, pose);
    this.#line(context, store.get("/trajectory")?.poses.map(({ pose: p }) => [p.position.x, p.position.y]) ?? [], pose);
    this.#seen(context, store);
    if (this.scanOn.checked) this.#scans(context, store, pose);
    this.#boxes(context, store);
    this.#landmarks(context, store);
    this.#robot(context, pose);
  }

  #grid(context, grid) {
    if (!grid) return;
    const { width, height, resolution, origin } = grid.info;
    const theme = colour("free");
    if (grid !== this.gridOf || theme !== this.theme) {
      this.gridOf = grid;
      this.theme = theme;
      this.grid = new OffscreenCanvas(Math.max(width, 1), Math.max(height, 1));
      const paint = this.grid.getContext("2d");
      const image = paint.createImageData(this.grid.width, this.grid.height);
      const [free, taken] = [rgb(theme), rgb(colour("taken"))];
      for (let k = 0; k < width * height; ++k) {
        const value = grid.data[k];
        if (value < 0) continue;
        const of = value >= 50 ? taken : free;
        // x of the grid goes up on the screen, y to the left.
        const [column, row] = [k % width, Math.floor(k / width)];
        const to = 4 * ((width - 1 - column) * height + (height - 1 - row));
        image.data.set([...of, 255], to);
      }
      this.grid.width = height;
      this.grid.height = width;
      paint.putImageData(new ImageData(image.data, height, width), 0, 0);
    }
    const [left, top] = this.at(origin.position.x + width * resolution, origin.position.y + height * resolution);
    context.imageSmoothingEnabled = false;
    context.drawImage(this.grid, left, top, height * resolution * this.scale, width * resolution * this.scale);
    context.imageSmoothingEnabled = true;
  }

  #rings(context, pose, width, height) {
    const step = this.scale > 90 ? 0.5 : this.scale > 26 ? 1 : this.scale > 12 ? 2 : 5;
    const reach = Math.hypot(width, height) / this.scale / 1.5;
    context.strokeStyle = colour("line");
    context.fillStyle = colour("quiet");
    context.lineWidth = 1;
    context.font = "10px system-ui, sans-serif";
    for (let r = step; r < reach; r += step) {
      const [x, y] = this.at(pose.x, pose.y);
      context.beginPath();
      context.arc(x, y, r * this.scale, 0, 7);
      context.stroke();
      context.fillText(`${r} m`, x + 3, y - r * this.scale - 2);
    }
  }

  #corridor(context, store, pose) {
    const memory = store.get("/striate/memory/short_term");
    const corridor = memory?.corridor;
    if (!corridor) return;
    const axis = corridor.axis_rad + (memory.pose?.heading_rad ?? pose.heading);
    const from = memory.pose ? { x: memory.pose.x_m, y: memory.pose.y_m } : pose;
    context.setLineDash([6, 5]);
    context.strokeStyle = colour("accent");
    context.lineWidth = 1.5;
    for (const side of [corridor.left_wall_m, corridor.right_wall_m === null ? null : -corridor.right_wall_m]) {
      if (side === null) continue;
      const [nx, ny] = [-Math.sin(axis) * side, Math.cos(axis) * side];
      context.beginPath();
      context.moveTo(...this.at(from.x + nx - 4 * Math.cos(axis), from.y + ny - 4 * Math.sin(axis)));
      context.lineTo(...this.at(from.x + nx + 8 * Math.cos(axis), from.y + ny + 8 * Math.sin(axis)));
      context.stroke();
    }
    context.setLineDash([]);
  }

  #line(context, points, pose) {
    if (points.length === 0) return;
    context.strokeStyle = colour("way");
    context.lineWidth = 2;
    context.beginPath();
    for (const [k, [x, y]] of points.entries()) {
      if (k === 0) context.moveTo(...this.at(x, y));
      else context.lineTo(...this.at(x, y));
    }
    context.lineTo(...this.at(pose.x, pose.y));
    context.stroke();
  }

  // What the newest image says about the floor: the field of view as far as it is free.
  #seen(context, store) {
    const seen = store.get("/striate/seen");
    const from = seen ? store.poseAt(seen.stamp_s) : null;
    if (!from || seen.columns.length < 2) return;
    const place = (bearing, r) => this.at(from.x + r * Math.cos(from.heading + bearing), from.y + r * Math.sin(from.heading + bearing));
    context.fillStyle = colour("view");
    context.beginPath();
    context.moveTo(...this.at(from.x, from.y));
    for (const { bearing_rad, free_from_m, free_to_m } of seen.columns) {
      context.lineTo(...place(bearing_rad, free_to_m > free_from_m ? free_to_m : 0));
    }
    context.closePath();
    context.fill();
    context.fillStyle = "#ff8a1f";
    for (const { bearing_rad, obstacle_m } of seen.columns) {
      if (obstacle_m === null || obstacle_m > 12) continue;
      const [x, y] = place(bearing_rad, obstacle_m);
      context.fillRect(x - 1.5, y - 1.5, 3, 3);
    }
    for (const one of seen.people) {
      const [x, y] = place(one.bearing_rad, one.distance_m);
      context.fillStyle = "#b04be0";
      context.beginPath();
      context.arc(x, y, Math.max(5, 0.25 * this.scale), 0, 7);
      context.fill();
      if (one.forward_m_s === null) continue;
      context.strokeStyle = "#b04be0";
      context.lineWidth = 2;
      context.beginPath();
      context.moveTo(x, y);
      const angle = from.heading + Math.atan2(one.left_m_s, one.forward_m_s);
      const speed = Math.hypot(one.left_m_s, one.forward_m_s);
      context.lineTo(x - Math.sin(angle) * speed * this.scale, y - Math.cos(angle) * speed * this.scale);
      context.stroke();
    }
  }

  #boxes(context, store) {
    const from = store.pose();
    for (const { header, ns, type, pose, scale } of store.get("/obstacles")?.markers ?? []) {
      if (type !== 1) continue;
      const at = store.poseAt(header.stamp.sec + header.stamp.nanosec * 1e-9) ?? from;
      const [c, s] = [Math.cos(at.heading), Math.sin(at.heading)];
      const [x, y] = [at.x + c * pose.position.x - s * pose.position.y, at.y + s * pose.position.x + c * pose.position.y];
      const [px, py] = this.at(x, y);
      context.save();
      context.translate(px, py);
      context.rotate(-(at.heading + heading(pose.orientation)));
      context.strokeStyle = ns === "moving" ? "#b04be0" : "#e06c00";
      context.lineWidth = 2;
      context.strokeRect((-scale.y * this.scale) / 2, -3, scale.y * this.scale, 6);
      context.restore();
    }
  }

  #scans(context, store, pose) {
    context.fillStyle = colour("bad");
    const dot = (x, y) => {
      const [c, s] = [Math.cos(pose.heading), Math.sin(pose.heading)];
      const [px, py] = this.at(pose.x + c * x - s * y, pose.y + s * x + c * y);
      context.fillRect(px - 1, py - 1, 2, 2);
    };
    const scan = store.get("/scan");
    for (const [k, range] of (scan?.ranges ?? []).entries()) {
      if (!Number.isFinite(range)) continue;
      const angle = scan.angle_min + k * scan.angle_increment;
      dot(range * Math.cos(angle), range * Math.sin(angle));
    }
    const sonar = store.get("/sonar");
    if (!sonar) return;
    const view = new DataView(sonar.data.buffer, sonar.data.byteOffset, sonar.data.byteLength);
    context.fillStyle = colour("accent");
    for (let k = 0; k < sonar.width; ++k) dot(view.getFloat32(12 * k, true), view.getFloat32(12 * k + 4, true));
  }

  #landmarks(context, store) {
    context.font = "600 12px system-ui, sans-serif";
    for (const { type, pose, scale, text, color } of store.get("/landmarks")?.markers ?? []) {
      const [x, y] = this.at(pose.position.x, pose.position.y);
      const seen = color.g > 0.65;
      if (type === 2) {
        context.fillStyle = seen ? "rgba(38,162,105,0.35)" : "rgba(128,128,128,0.3)";
        context.beginPath();
        context.arc(x, y, Math.max((scale.x / 2) * this.scale, 4), 0, 7);
        context.fill();
      } else if (type === 9) {
        context.fillStyle = seen ? colour("good") : colour("quiet");
        context.fillText(show(text), x + 7, y + 4);
      }
    }
  }

  #robot(context, pose) {
    const [x, y] = this.at(pose.x, pose.y);
    context.save();
    context.translate(x, y);
    context.rotate(-pose.heading);
    const [front, rear, half] = [kFront_m, kRear_m, kHalfWidth_m].map((m) => Math.max(m * this.scale, 4));
    context.fillStyle = colour("accent");
    context.strokeStyle = colour("card");
    context.lineWidth = 1.5;
    context.beginPath();
    context.moveTo(0, -front * 1.3);
    context.lineTo(half, -front * 0.5);
    context.lineTo(half, rear);
    context.lineTo(-half, rear);
    context.lineTo(-half, -front * 0.5);
    context.closePath();
    context.fill();
    context.stroke();
    context.restore();
  }
}

export function rgb(text) {
  const hex = /^#(..)(..)(..)$/.exec(text);
  return hex ? hex.slice(1).map((part) => parseInt(part, 16)) : [128, 128, 128];
}
export { metres };
