"use strict";
// A plane that cuts the solid open: what is cut is filled, measured, and hit by rays.

const kCapVertex = `void main() { gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }`;

// Hatched as in a drawing.
const kCapFragment = `
  uniform float unit;
  void main() {
    float across = mod(gl_FragCoord.x + gl_FragCoord.y, 10.0 * unit);
    gl_FragColor = vec4(across < 1.3 * unit ? vec3(0.52, 0.43, 0.33) : vec3(0.95, 0.91, 0.84), 1.0);
  }`;

const kNoPlane = [0, 0, 0, 1];
const kTrials = 41;  // places that are looked at for a cut

class Section {
  constructor(view) {
    this.view = view;
    this.mesh = view.mesh;
    this.plane = {value: new THREE.Vector4(...kNoPlane)};
    this.at = null;  // {axis, place, flipped}
    this.cut = {points: [], edges: [], labels: []};
    this.onMeasured = () => {};
    this.makeObjects();
  }

  // What the plane cuts is filled by parity: triangles from one point of the plane to every segment.
  makeObjects() {
    const material = extra => new THREE.ShaderMaterial({uniforms: {unit: {value: 1}}, vertexShader: kCapVertex,
      fragmentShader: kCapFragment, side: THREE.DoubleSide, stencilWrite: true, ...extra});
    this.parity = new THREE.Mesh(new THREE.BufferGeometry(), material({colorWrite: false, depthWrite: false,
      depthTest: false, stencilFunc: THREE.AlwaysStencilFunc, stencilZPass: THREE.InvertStencilOp}));
    this.cap = new THREE.Mesh(new THREE.BufferGeometry(), material({stencilFunc: THREE.NotEqualStencilFunc,
      stencilRef: 0, stencilFuncMask: 1, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1}));
    this.lines = new THREE.LineSegments(new THREE.BufferGeometry(), new THREE.LineBasicMaterial({color: 0x3b2f24}));
    [this.parity, this.cap, this.lines].forEach(object => object.visible = false);
  }

  // With the order in which they are drawn.
  objects() { return [[this.parity, 1], [this.cap, 2], [this.lines, 4]]; }

  setPixelRatio(ratio) { this.cap.material.uniforms.unit.value = ratio; }

  // null, or {axis, place, flipped}.
  set(at) {
    this.at = at;
    this.plane.value.set(...kNoPlane);
    this.objects().forEach(([object]) => object.visible = at !== null);
    if (at !== null) {
      const sign = at.flipped ? -1 : 1;
      this.plane.value.set(...[0, 1, 2].map(k => k === at.axis ? sign : 0), sign * at.place);
    }
    this.isStale = true;
    this.view.request();
  }

  // Before a picture: what is hidden is not cut.
  refresh() {
    if (!this.isStale || this.at === null) {
      return;
    }
    this.isStale = false;
    this.cut = this.shown(this.mesh.cut(this.at.axis, this.at.place));
    this.fill();
    this.onMeasured(this.at, this.measure(this.cut));
  }

  // Of every segment an edge that all of its outline have in common: a union of sets.
  outlines(cut) {
    const next = new Map(cut.edges.map(edge => [edge, edge]));
    const root = edge => {
      while (next.get(edge) !== edge) {
        next.set(edge, next.get(next.get(edge)));
        edge = next.get(edge);
      }
      return edge;
    };
    cut.labels.forEach((_, i) => next.set(root(cut.edges[2 * i]), root(cut.edges[2 * i + 1])));
    return cut.labels.map((_, i) => root(cut.edges[2 * i]));
  }

  // Without the outlines all of which is hidden.
  shown(cut) {
    const isShown = cut.labels.map(label => this.view.isShown(label));
    if (isShown.every(x => x)) {
      return cut;
    }
    const outlines = this.outlines(cut), seen = new Set(outlines.filter((_, i) => isShown[i]));
    const kept = {points: [], edges: [], labels: []};
    outlines.forEach((outline, i) => {
      if (seen.has(outline)) {
        kept.points.push(...cut.points.slice(6 * i, 6 * i + 6));
        kept.edges.push(...cut.edges.slice(2 * i, 2 * i + 2));
        kept.labels.push(cut.labels[i]);
      }
    });
    return kept;
  }

  fill() {
    const {axis, place} = this.at, {low, high} = this.mesh, segments = new Float32Array(this.cut.points);
    const anchor = [0, 1, 2].map(k => k === axis ? place : low[k]);
    const fans = new Float32Array(segments.length / 6 * 9);
    for (let i = 0, k = 0; i < segments.length; i += 6, k += 9) {
      fans.set(anchor, k);
      fans.set(segments.subarray(i, i + 6), k + 3);
    }
    const [u, v] = this.across(axis);
    const quad = [];
    for (const [s, t] of [[0, 0], [1, 0], [1, 1], [0, 0], [1, 1], [0, 1]]) {
      const corner = anchor.slice();
      corner[u] = s ? high[u] : low[u];
      corner[v] = t ? high[v] : low[v];
      quad.push(...corner);
    }
    [fans, new Float32Array(quad), segments].forEach((positions, i) => {
      const [object] = this.objects()[i];
      object.geometry.dispose();
      object.geometry = new THREE.BufferGeometry();
      object.geometry.setAttribute("position", new THREE.BufferAttribute(positions, 3));
    });
  }

  measure({points}, axis = this.at.axis) {
    const [u, v] = this.across(axis);
    let area = 0, length = 0;
    for (let i = 0; i < points.length; i += 6) {
      area += points[i + u] * points[i + 3 + v] - points[i + v] * points[i + 3 + u];
      length += Math.hypot(points[i + 3 + u] - points[i + u], points[i + 3 + v] - points[i + v]);
    }
    return {area: Math.abs(area) / 2, length};
  }

  across(axis) { return [(axis + 1) % 3, (axis + 2) % 3]; }

  // In the middle of the places around where the outline is longest, of what is shown: there bores are open.
  best(axis) {
    const {low, high} = this.mesh, step = (high[axis] - low[axis]) / kTrials;
    const places = Array.from({length: kTrials}, (_, i) => low[axis] + (i + 0.5) * step);
    const lengths = places.map(place => this.measure(this.shown(this.mesh.cut(axis, place)), axis).length);
    const longest = Math.max(...lengths), isLong = i => lengths[i] >= 0.75 * longest;
    let first = lengths.indexOf(longest), last = first;
    while (first > 0 && isLong(first - 1)) {
      --first;
    }
    while (last + 1 < kTrials && isLong(last + 1)) {
      ++last;
    }
    return (places[first] + places[last]) / 2;
  }

  isCutAway(point) {
    const plane = this.plane.value;
    return plane.x * point[0] + plane.y * point[1] + plane.z * point[2] - plane.w > 0;
  }

  // Where a ray from what is cut away meets the cut, or comes by at most `reach` away from it: {label, point, corners,
  // outline: the nearest point}; else null.
  hit(from, direction, reach) {
    if (this.at === null || !this.isCutAway(from)) {
      return null;
    }
    const {axis, place} = this.at, way = (place - from[axis]) / direction[axis];
    if (!(way > 0 && way < Infinity)) {
      return null;
    }
    const point = from.map((x, k) => k === axis ? place : x + way * direction[k]), nearest = this.nearest(point);
    if (!nearest.isInside && nearest.distance > reach) {
      return null;
    }
    const first = 6 * nearest.segment, [a, b] = [first, first + 3].map(i => this.cut.points.slice(i, i + 3));
    return {label: this.cut.labels[nearest.segment], point, corners: [a, b],
      outline: a.map((x, k) => x + nearest.share * (b[k] - x))};
  }

  // Of a point of the plane: whether the solid is there, by parity, and the nearest segment of the outline.
  nearest(point) {
    const p = this.cut.points, [u, v] = this.across(this.at.axis), x = point[u], y = point[v];
    const nearest = {isInside: false, segment: -1, share: 0, distance: Infinity};
    for (let i = 0; i < p.length; i += 6) {
      const ax = p[i + u] - x, ay = p[i + v] - y, bx = p[i + 3 + u] - x, by = p[i + 3 + v] - y;
      if (ay > 0 !== by > 0 && (ax * by - bx * ay) / (by - ay) > 0) {
        nearest.isInside = !nearest.isInside;
      }
      const dx = bx - ax, dy = by - ay, square = dx * dx + dy * dy;
      const share = square > 0 ? Math.max(0, Math.min(1, -(ax * dx + ay * dy) / square)) : 0;
      const distance = Math.hypot(ax + share * dx, ay + share * dy);
      if (distance < nearest.distance) {
        Object.assign(nearest, {segment: i / 6, share, distance});
      }
    }
    return nearest;
  }
}
