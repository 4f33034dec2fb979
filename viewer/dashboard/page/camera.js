// The left camera's image, and what vision found in it, in layers.
import { Canvas, card, colour, el, metres, show } from "./dom.js";

export const layers = [
  ["floor", "Free floor", true], ["obstacles", "Obstacles", true], ["people", "Moving", true],
  ["regions", "Salient regions", true], ["landmarks", "Landmarks", true], ["keypoints", "Keypoints", false],
  ["disparity", "Disparity", false], ["saliency", "Saliency", false],
];
const topicOf = { disparity: "/stereo/disparity", saliency: "/saliency" };

export class CameraView {
  // onLayers(): topics() may have changed. onPick(region): somebody has clicked one; may be null.
  constructor({ onLayers, onPick = null }) {
    this.on = new Set(layers.filter(([, , on]) => on).map(([name]) => name));
    this.canvas = new Canvas("Image of the left camera with what was found in it");
    this.note = el("p.note", {}, "No image has come yet.");
    const switches = el("div.switches", { role: "group", "aria-label": "Layers" }, layers.map(([name, label, on]) =>
      el("label", {}, el("input", {
        type: "checkbox", "data-layer": name, checked: on,
        onchange: ({ target }) => {
          if (target.checked) this.on.add(name);
          else this.on.delete(name);
          onLayers();
        },
      }), label)));
    this.element = card("Left camera", this.canvas.box, switches, this.note);
    this.element.classList.add("camera");
    if (onPick) {
      this.canvas.element.classList.add("pickable");
      this.canvas.element.addEventListener("click", (event) => this.#pick(event, onPick));
    }
  }
  topics() {
    return Object.entries(topicOf).filter(([layer]) => this.on.has(layer)).map(([, topic]) => topic);
  }

  render(store) {
    const message = store.get("/camera/left/image/compressed");
    if (message && message !== this.shown) {
      this.shown = message;
      const type = /jpe?g/i.test(message.format) ? "image/jpeg" : "image/png";
      createImageBitmap(new Blob([message.data], { type })).then((bitmap) => {
        this.bitmap?.close();
        this.bitmap = bitmap;
        store.changed = true;
      }, () => {});
    }
    if (!message) this.bitmap = null;
    this.seen = store.get("/striate/seen");
    this.canvas.draw((context, width, height) => this.#paint(context, width, height, store));
    const seen = this.seen;
    if (seen) {
      this.note.textContent = show(`${seen.regions.length} salient regions, ${seen.keypoints.length / 3} keypoints` +
        (seen.landmarks.length > 0 ? `, recognised: ${seen.landmarks.map(({ name }) => name).join(", ")}` : ""));
    }
  }

  #paint(context, width, height, store) {
    const size = this.bitmap ?? this.seen ?? { width: 4, height: 3, width_px: 4, height_px: 3 };
    const [w, h] = [size.width ?? size.width_px, size.height ?? size.height_px];
    const scale = Math.min(width / w, height / h);
    const box = (this.box = { x: (width - w * scale) / 2, y: (height - h * scale) / 2, w: w * scale, h: h * scale });
    context.fillStyle = colour("sunken");
    context.fillRect(0, 0, width, height);
    if (this.bitmap) context.drawImage(this.bitmap, box.x, box.y, box.w, box.h);
    context.save();
    context.beginPath();
    context.rect(box.x, box.y, box.w, box.h);
    context.clip();
    if (this.on.has("disparity")) this.#paintDisparity(context, store.get("/stereo/disparity"));
    if (this.on.has("saliency")) this.#paintSaliency(context, store.get("/saliency"));
    if (this.seen && this.seen.width_px > 0) this.#paintSeen(context, this.seen);
    context.restore();
  }

  #paintSeen(context, seen) {
    const s = this.box.w / seen.width_px;
    const x = (u) => this.box.x + (u + 0.5) * s;
    const y = (v) => this.box.y + (v + 0.5) * s;
    const row = (bearing, distance) => rowOf(seen, bearing, distance);
    if (this.on.has("floor")) {
      context.fillStyle = "rgba(46, 184, 92, 0.32)";
      const step = seen.columns.length > 1 ? (seen.columns[1].u_px - seen.columns[0].u_px) * s : s;
      for (const { u_px, bearing_rad, free_from_m, free_to_m } of seen.columns) {
        if (!(free_to_m > free_from_m)) continue;
        const [top, bottom] = [row(bearing_rad, free_to_m), row(bearing_rad, Math.max(free_from_m, 0.3))];
        if (top === null) continue;
        const lower = bottom === null ? this.box.y + this.box.h : y(bottom);
        context.fillRect(x(u_px) - s / 2, y(top), step + 0.5, Math.max(0, lower - y(top)));
      }
    }
    if (this.on.has("obstacles")) {
      const step = seen.columns.length > 1 ? (seen.columns[1].u_px - seen.columns[0].u_px) * s : s;
      context.fillStyle = "#ff8a1f";
      for (const { u_px, bearing_rad, obstacle_m } of seen.columns) {
        const foot = obstacle_m === null ? null : row(bearing_rad, obstacle_m);
        if (foot !== null) context.fillRect(x(u_px) - s / 2, y(foot) - 1.5, step + 0.5, 3);
      }
    }
    if (this.on.has("keypoints")) {
      context.strokeStyle = "rgba(90, 220, 255, 0.9)";
      context.lineWidth = 1;
      for (let k = 0; k + 2 < seen.keypoints.length; k += 3) {
        context.beginPath();
        context.arc(x(seen.keypoints[k]), y(seen.keypoints[k + 1]), Math.max(1.5, seen.keypoints[k + 2] * s / 2), 0, 7);
        context.stroke();
      }
    }
    const frame = (one, text, stroke) => {
      const [w, h] = [one.width_px * s, one.height_px * s];
      const [left, top] = [x(one.u_px) - w / 2, y(one.v_px) - h / 2];
      context.strokeStyle = stroke;
      context.lineWidth = 2;
      context.strokeRect(left, top, w, h);
      tag(context, show(text), left, Math.max(top, this.box.y + 15), stroke);
    };
    if (this.on.has("people")) {
      for (const one of seen.people) {
        const [left, right] = [x(one.from_u_px), x(one.to_u_px)];
        context.strokeStyle = "#d26bff";
        context.lineWidth = 2;
        context.strokeRect(left, this.box.y + 2, right - left, this.box.h - 4);
        tag(context, `moves, ${metres(one.distance_m, 1)}`, left, this.box.y + 18, "#d26bff");
      }
    }
    if (this.on.has("regions")) {
      for (const [k, one] of seen.regions.slice(0, 7).entries()) frame(one, `${k + 1}`, "#ffd84a");
    }
    if (this.on.has("landmarks")) {
      for (const one of seen.landmarks) frame(one, `${one.name} ${Math.round(one.score * 100)} %`, "#57e389");
    }
  }

  #paintDisparity(context, message) {
    if (!message || message.image.encoding !== "32FC1") return;
    const { width, height, data } = message.image;
    if (message !== this.disparityOf) {
      this.disparityOf = message;
      const values = new Float32Array(data.buffer.slice(data.byteOffset, data.byteOffset + 4 * width * height));
      this.disparity = pictureOf(width, height, (k, to) => {
        const share = values[k] / Math.max(message.max_disparity, 1);
        if (values[k] < 0) return;
        const [r, g, b] = warm(share);
        to(r, g, b, 200);
      });
    }
    context.drawImage(this.disparity, this.box.x, this.box.y, this.box.w, this.box.h);
  }

  #paintSaliency(context, message) {
    if (!message || message.encoding !== "mono8") return;
    const { width, height, data } = message;
    if (message !== this.saliencyOf) {
      this.saliencyOf = message;
      this.saliency = pictureOf(width, height, (k, to) => to(255, 216, 74, data[k] * 0.8));
    }
    context.drawImage(this.saliency, this.box.x, this.box.y, this.box.w, this.box.h);
  }

  #pick({ offsetX, offsetY }, onPick) {
    if (!this.seen || !this.box) return;
    const s = this.box.w / this.seen.width_px;
    const [u, v] = [(offsetX - this.box.x) / s - 0.5, (offsetY - this.box.y) / s - 0.5];
    const hits = this.seen.regions.slice(0, 7).filter((one) =>
      Math.abs(u - one.u_px) <= one.width_px / 2 && Math.abs(v - one.v_px) <= one.height_px / 2);
    hits.sort((a, b) => a.width_px * a.height_px - b.width_px * b.height_px);
    if (hits.length > 0) onPick(hits[0], this.seen);
  }
}

// The row of the image in which the floor stands at that distance; null: it is not before the camera.
function rowOf({ camera }, bearing_rad, distance_m) {
  const ahead = distance_m * Math.cos(bearing_rad - camera.pan_rad) - camera.forward_m * Math.cos(camera.pan_rad);
  const [c, s] = [Math.cos(camera.tilt_rad), Math.sin(camera.tilt_rad)];
  const depth = ahead * c - camera.height_m * s;
  if (depth < 0.05 || !(camera.focal_px > 0)) return null;
  return camera.centre_v_px + (camera.focal_px * (ahead * s + camera.height_m * c)) / depth;
}

function tag(context, text, left, top, fill) {
  context.font = "600 11px system-ui, sans-serif";
  const wide = context.measureText(text).width + 8;
  const at = Math.max(top - 15, 0);
  context.fillStyle = fill;
  context.fillRect(left - 1, at, wide, 15);
  context.fillStyle = "#111";
  context.fillText(text, left + 3, at + 11.5);
}

function pictureOf(width, height, each) {
  const canvas = new OffscreenCanvas(Math.max(width, 1), Math.max(height, 1));
  const context = canvas.getContext("2d");
  const image = context.createImageData(canvas.width, canvas.height);
  for (let k = 0; k < width * height; ++k) {
    each(k, (r, g, b, a) => {
      image.data[4 * k] = r;
      image.data[4 * k + 1] = g;
      image.data[4 * k + 2] = b;
      image.data[4 * k + 3] = a;
    });
  }
  context.putImageData(image, 0, 0);
  return canvas;
}

// Far is blue, near is yellow.
function warm(share) {
  const t = Math.min(Math.max(share, 0), 1);
  return [255 * Math.min(1, 1.6 * t), 255 * (0.15 + 0.75 * t), 255 * (0.75 - 0.7 * t)];
}
