"use strict";
// What is drawn over the picture, in pixels: axes, the scale, marks of places, the measure.

// Of 1, 2, 5 times powers of ten, the largest that is not above `most`.
function roundLength(most) {
  const power = 10 ** Math.floor(Math.log10(most));
  return [5, 2, 1].map(x => x * power).find(x => x <= most) || power;
}

function numberText(value) {
  const text = Math.abs(value) >= 1e6 || (value !== 0 && Math.abs(value) < 1e-4) ? value.toExponential(3)
                                                                                : String(Number(value.toPrecision(6)));
  return text.replace("-", "\u2212");
}

class Overlay {
  constructor(view, unit) {
    this.view = view;
    this.unit = unit;
    this.canvas = view.stage.querySelector("#overlay");
    this.places = [];  // {at, isFinding, isChosen, section}, relative to the mesh's centre
    this.openSection = 0;
    this.measured = [];  // points
    view.painters.push(() => this.paint());
  }

  paint() {
    const {width, height} = this.view, ratio = window.devicePixelRatio || 1;
    if (this.canvas.width !== Math.round(width * ratio) || this.canvas.height !== Math.round(height * ratio)) {
      this.canvas.width = Math.round(width * ratio);
      this.canvas.height = Math.round(height * ratio);
    }
    this.context = this.canvas.getContext("2d");
    this.context.setTransform(ratio, 0, 0, ratio, 0, 0);
    this.context.clearRect(0, 0, width, height);
    this.context.font = "12px system-ui, 'DejaVu Sans', sans-serif";
    this.paintPlaces();
    this.paintMeasure();
    this.paintAxes();
    this.paintScale();
  }

  line(points, colour, width) {
    const c = this.context;
    c.strokeStyle = colour;
    c.lineWidth = width;
    c.beginPath();
    points.forEach(([x, y], i) => i === 0 ? c.moveTo(x, y) : c.lineTo(x, y));
    c.stroke();
  }

  text(text, x, y, colour, align = "center") {
    const c = this.context;
    c.textAlign = align;
    c.textBaseline = "middle";
    c.lineWidth = 3;
    c.lineJoin = "round";
    c.strokeStyle = "#fffc";
    c.strokeText(text, x, y);
    c.fillStyle = colour;
    c.fillText(text, x, y);
  }

  paintAxes() {
    const {right, up, towards} = this.view.frame(), length = 34, x = 52, y = this.view.height - 52;
    const axes = [["x", "#c0392b"], ["y", "#1e8449"], ["z", "#1f5fbf"]].map(([name, colour], k) => ({name, colour,
      at: [length * right[k], -length * up[k]], depth: towards[k]}));
    for (const {name, colour, at} of axes.sort((a, b) => a.depth - b.depth)) {
      this.line([[x, y], [x + at[0], y + at[1]]], colour, 2.5);
      const reach = Math.hypot(...at);
      if (reach > 6) {
        this.text(name, x + at[0] * (reach + 9) / reach, y + at[1] * (reach + 9) / reach, colour);
      } else {
        this.text(name, x + 10, y - 10, colour);
      }
    }
  }

  // True in the plane of the target; everywhere where there is no perspective.
  paintScale() {
    const perPixel = this.view.pose.height / this.view.height, length = roundLength(150 * perPixel);
    const x = 110, y = this.view.height - 26, pixels = length / perPixel;
    this.line([[x, y - 5], [x, y], [x + pixels, y], [x + pixels, y - 5]], "#1f2933", 1.5);
    this.text(numberText(length) + (this.unit ? " " + this.unit : ""), x + pixels / 2, y - 11, "#1f2933");
  }

  // Findings always, else what the open table is about.
  shownPlaces() { return this.places.filter(place => place.isFinding || place.isChosen || place.section === this.openSection); }

  paintPlaces() {
    const c = this.context;
    for (const place of this.shownPlaces().sort((a, b) => Number(a.isChosen) - Number(b.isChosen))) {
      const [x, y] = this.view.project(place.at), colour = place.isFinding ? "#c62828" : "#0b69c7";
      c.beginPath();
      c.arc(x, y, place.isChosen ? 7 : 4, 0, 2 * Math.PI);
      c.fillStyle = place.isChosen ? colour + "33" : colour;
      c.fill();
      c.lineWidth = place.isChosen ? 2.5 : 1.5;
      c.strokeStyle = place.isChosen ? colour : "#fff";
      c.stroke();
    }
  }

  // The nearest that is near, or undefined.
  placeAt(x, y) {
    const way = place => {
      const [px, py] = this.view.project(place.at);
      return Math.hypot(px - x, py - y);
    };
    return this.shownPlaces().filter(place => way(place) < 8).sort((a, b) => way(a) - way(b))[0];
  }

  paintMeasure() {
    const points = this.measured.map(point => this.view.project(point));
    if (points.length === 2) {
      this.line(points, "#fff", 5);
      this.line(points, "#8e24aa", 2);
      const [a, b] = this.measured, d = a.map((x, k) => b[k] - x);
      const unit = this.unit ? " " + this.unit : "";
      const [x, y] = [(points[0][0] + points[1][0]) / 2, (points[0][1] + points[1][1]) / 2];
      this.context.font = "bold 13px system-ui, 'DejaVu Sans', sans-serif";
      this.text(numberText(Math.hypot(...d)) + unit, x, y - 16, "#6a1b9a");
      this.context.font = "12px system-ui, 'DejaVu Sans', sans-serif";
      this.text("\u0394 " + d.map(numberText).join(", "), x, y + 16, "#6a1b9a");
    }
    for (const [x, y] of points) {
      this.context.beginPath();
      this.context.arc(x, y, 4, 0, 2 * Math.PI);
      this.context.fillStyle = "#8e24aa";
      this.context.fill();
    }
  }
}
