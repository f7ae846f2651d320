"use strict";
// Puts the page together.

class Page {
  constructor(data, geometry) {
    this.data = data;
    document.getElementById("title").textContent = data.title;
    document.getElementById("summary").textContent = data.summary;
    this.tables = new Tables(data, row => this.go(row));
    const stage = document.getElementById("stage");
    this.mesh = new Mesh(data.mesh, geometry);
    try {
      this.view = new View(stage, this.mesh, data.labels.length);
    } catch (error) {
      const failure = document.getElementById("failure");
      failure.textContent = "There is no picture, as this browser has no WebGL (" + error.message + "). The tables are complete.";
      failure.hidden = false;
      return;
    }
    this.overlay = new Overlay(this.view, data.unit);
    this.overlay.openSection = this.tables.opened;
    this.tables.onOpen = index => {
      this.overlay.openSection = index;
      this.view.request();
    };
    this.view.section.onMeasured = (at, measured) => this.tellCut(at, measured);
    this.tree = new Tree(data, this.view, part => this.chose(part));
    this.makePlaces();
    this.controls = new Controls(this.view, {
      click: (x, y) => this.click(x, y),
      hover: (x, y) => this.hoverSoon(x, y),
      leave: () => this.leave(),
      doubleClick: (x, y) => this.doubleClick(x, y),
    });
    this.connectTools();
    window.addEventListener("keydown", event => this.key(event));
  }

  // Of a coordinate relative to the centre: as many digits as the size of the solid asks for.
  coordinateText(value, axis) {
    const digits = Math.max(0, Math.min(20, 5 - Math.floor(Math.log10(this.mesh.size))));
    return String(Number((value + this.mesh.center[axis]).toFixed(digits))).replace("-", "\u2212");
  }

  local(point) { return point.map((x, k) => x - this.mesh.center[k]); }

  makePlaces() {
    this.data.sections.forEach((section, index) => section.rows.forEach(row => {
      if (row.place && row.place.marked) {
        this.overlay.places.push({at: this.local(row.place.at), isFinding: Boolean(row.finding), row, section: index});
      }
    }));
  }

  go(row) {
    if (!this.view) {
      return;
    }
    this.choosePlace(row);
    if (row.part !== undefined) {
      this.tree.choose(this.tree.parts[row.part]);
    }
    if (!row.place) {
      this.showPart(this.tree.parts[row.part]);
      return;
    }
    const at = this.local(row.place.at), lines = (row.place.lines || []).map(line => line.map(point => this.local(point)));
    if (!this.overlay.places.some(place => place.row === row)) {
      this.overlay.places.push({at, isFinding: Boolean(row.finding), isChosen: true, isPassing: true, row});
    }
    this.view.setMarkLines(lines);
    if (!document.getElementById("cut").hidden) {
      this.cutAtBest();
    }
    const height = row.place.size > 0 ? Math.max(3.2 * row.place.size, this.mesh.size * 1e-4) : 0.15 * this.mesh.size;
    this.view.fly({target: at, height, ...this.view.poseToSee([at, ...lines.flat()], 1e-3 * height)});
  }

  // What is marked; nothing for null.
  choosePlace(row) {
    this.overlay.places = this.overlay.places.filter(place => !place.isPassing);
    this.overlay.places.forEach(place => place.isChosen = place.row === row);
    this.chosenPlace = row && row.place ? this.local(row.place.at) : null;
  }

  showPart(part) {
    const isOfPart = new Set(part.labels), isCorner = new Uint8Array(this.mesh.pointCount);
    for (let f = 0; f < this.mesh.triangleCount; ++f) {
      if (isOfPart.has(this.mesh.labels[f])) {
        [0, 1, 2].forEach(i => isCorner[this.mesh.triangles[3 * f + i]] = 1);
      }
    }
    if (isCorner.includes(1)) {
      const pose = this.view.poseOf(point => isCorner[point] === 1);
      this.view.setMarkLines([]);
      this.view.fly({...pose, height: 1.3 * pose.height});
    }
  }

  chose(part) {
    document.getElementById("status").textContent = part ? part.name + (part.kind ? ", " + part.kind : "") : "";
  }

  click(x, y) {
    const place = this.overlay.placeAt(x, y);
    if (this.isMeasuring) {
      const point = this.snapped(x, y);
      if (point) {
        this.overlay.measured = this.overlay.measured.length === 2 ? [point] : [...this.overlay.measured, point];
        this.view.request();
      }
    } else if (place) {
      this.tables.goTo(place.row);
    } else {
      const hit = this.view.hit(x, y);
      this.tree.choose(hit ? this.tree.partOfLabel[hit.label] : null);
    }
  }

  doubleClick(x, y) {
    const hit = this.isMeasuring ? null : this.view.hit(x, y);
    if (hit) {
      this.view.fly({target: hit.point});
    }
  }

  // A corner, or a place on the outline of a cut, if it is near.
  snapped(x, y) {
    const hit = this.view.hit(x, y, 6);
    if (!hit) {
      return null;
    }
    const way = point => {
      const [px, py] = this.view.project(point);
      return Math.hypot(px - x, py - y);
    };
    const nearest = hit.corners.reduce((best, corner) => way(corner) < way(best) ? corner : best);
    return [nearest, hit.outline].find(point => point && way(point) < 8) || hit.point;
  }

  // Once a frame is enough.
  hoverSoon(x, y) {
    const isWaiting = Boolean(this.hovering);
    this.hovering = [x, y];
    if (!isWaiting) {
      requestAnimationFrame(() => {
        if (this.hovering) {
          this.hover(...this.hovering);
          this.hovering = null;
        }
      });
    }
  }

  hover(x, y) {
    const place = this.overlay.placeAt(x, y), hit = place ? null : this.view.hit(x, y);
    const tip = document.getElementById("tip");
    const part = hit ? this.tree.partOfLabel[hit.label] : null;
    this.tree.hover(part);
    tip.hidden = !hit && !place;
    if (place) {
      tip.textContent = place.row.cells.filter(Boolean).join("\n");
    } else if (hit) {
      const at = hit.point.map((c, k) => this.coordinateText(c, k)).join(", ");
      const patch = this.data.labels[hit.label];
      tip.textContent = [part.name + (part.kind ? ", " + part.kind : ""), ...(patch !== part.name ? [patch] : []), at].join("\n");
    }
    tip.style.left = Math.max(4, Math.min(x + 14, this.view.width - tip.offsetWidth - 4)) + "px";
    tip.style.top = Math.max(4, Math.min(y + 14, this.view.height - tip.offsetHeight - 4)) + "px";
  }

  leave() {
    this.hovering = null;
    document.getElementById("tip").hidden = true;
    this.tree.hover(null);
  }

  connectTools() {
    const toggle = (id, change) => {
      const button = document.getElementById(id);
      button.onclick = () => {
        const isOn = button.getAttribute("aria-pressed") !== "true";
        button.setAttribute("aria-pressed", String(isOn));
        change(isOn);
      };
    };
    document.querySelectorAll("[data-view]").forEach(button => button.onclick = () => this.view.flyToFit(button.dataset.view));
    document.getElementById("fit").onclick = () => this.view.flyToFit();
    toggle("perspective", isOn => this.view.setPerspective(isOn));
    toggle("edges", isOn => this.view.setSharpEdges(isOn));
    toggle("wireframe", isOn => this.view.setWireframe(isOn));
    toggle("measure", isOn => {
      this.isMeasuring = isOn;
      this.overlay.measured = [];
      this.view.stage.classList.toggle("measuring", isOn);
      document.getElementById("status").textContent = isOn ? "Click two points" : "";
      this.view.request();
    });
    toggle("section", isOn => {
      document.getElementById("cut").hidden = !isOn;
      if (isOn) {
        this.cutAtBest();
      } else {
        this.view.section.set(null);
      }
    });
    const [axis, place, flip] = ["cut-axis", "cut-place", "cut-flip"].map(id => document.getElementById(id));
    axis.value = "1";
    axis.onchange = () => this.cutAtBest();
    place.oninput = () => this.cut();
    flip.onclick = () => {
      this.isFlipped = !this.isFlipped;
      this.cut();
    };
  }

  // Through the place that was chosen, else through much; what is nearer to the viewer is cut away.
  cutAtBest() {
    const axis = Number(document.getElementById("cut-axis").value), {low, high} = this.mesh;
    const place = this.chosenPlace ? this.chosenPlace[axis] : this.view.section.best(axis);
    document.getElementById("cut-place").value = 1000 * (place - low[axis]) / (high[axis] - low[axis] || 1);
    this.isFlipped = this.view.frame().towards[axis] < 0;
    this.cut();
  }

  cut() {
    const axis = Number(document.getElementById("cut-axis").value), share = document.getElementById("cut-place").value / 1000;
    const {low, high} = this.mesh;
    this.view.section.set({axis, place: low[axis] + share * (high[axis] - low[axis]), flipped: this.isFlipped});
  }

  tellCut({axis, place}, {area, length}) {
    const unit = this.data.unit ? " " + this.data.unit : "";
    document.getElementById("cut-text").textContent = "xyz"[axis] + " = " + this.coordinateText(place, axis) + unit +
      ", area " + numberText(area) + (unit ? unit + "\u00b2" : "") + ", outline " + numberText(length) + unit;
  }

  key(event) {
    if (event.target.matches("input[type=search], input[type=range], select") || event.ctrlKey || event.metaKey || event.altKey) {
      return;
    }
    const buttons = {f: "#fit", p: "#perspective", e: "#edges", w: "#wireframe", m: "#measure", s: "#section",
      "0": "[data-view=iso]", "1": "[data-view=front]", "2": "[data-view=right]", "3": "[data-view=top]"};
    const selector = buttons[event.key.toLowerCase()];
    if (selector) {
      document.querySelector(selector).click();
    } else if (event.key === "Escape") {
      this.overlay.measured = [];
      this.choosePlace(null);
      this.view.setMarkLines([]);
      this.tree.choose(null);
    }
  }
}

const element = id => document.getElementById(id).textContent;
window.dupinPage = new Page(JSON.parse(element("data")), element("geometry"));
