"use strict";
// The mesh: unpacked, given normals, hit by rays, cut by planes. Nothing here knows the page.

// Numbers of variable length, seven bits to a byte, the lowest first; see packed_mesh.h.
class NumberReader {
  constructor(text) {
    const characters = atob(text);
    this.bytes = new Uint8Array(characters.length);
    for (let i = 0; i < characters.length; ++i) {
      this.bytes[i] = characters.charCodeAt(i);
    }
    this.at = 0;
  }

  unsigned() {
    let value = 0, shift = 1;
    for (;;) {
      const byte = this.bytes[this.at++];
      value += (byte & 127) * shift;
      if (byte < 128) {
        return value;
      }
      shift *= 128;
    }
  }

  signed() {
    const value = this.unsigned();
    return value % 2 === 0 ? value / 2 : -(value + 1) / 2;
  }
}

class Mesh {
  // `header` as packed_mesh.h has it. Coordinates are relative to `center`, so that binary32 holds them.
  constructor(header, text) {
    const reader = new NumberReader(text);
    this.pointCount = header.points;
    this.triangleCount = header.triangles;
    this.center = header.center;
    this.points = new Float32Array(3 * header.points);
    const last = [0, 0, 0];
    for (let i = 0; i < this.points.length; ++i) {
      last[i % 3] += reader.signed();
      this.points[i] = last[i % 3] * header.step;
    }
    this.triangles = new Uint32Array(3 * header.triangles);
    for (let i = 0, next = 0; i < this.triangles.length; ++i) {
      const back = reader.unsigned();
      this.triangles[i] = next - back;
      next += back === 0 ? 1 : 0;
    }
    this.labels = new Uint32Array(header.triangles);
    let first = 0;
    for (const [label, count] of header.runs) {
      this.labels.fill(label, first, first + count);
      first += count;
    }
    this.findBounds();
    this.findFaceNormals();
    this.findCorners();
    this.makeChunks();
  }

  findBounds() {
    this.low = [Infinity, Infinity, Infinity];
    this.high = [-Infinity, -Infinity, -Infinity];
    for (let i = 0; i < this.points.length; ++i) {
      this.low[i % 3] = Math.min(this.low[i % 3], this.points[i]);
      this.high[i % 3] = Math.max(this.high[i % 3], this.points[i]);
    }
    if (this.pointCount === 0) {
      this.low = [-1, -1, -1];
      this.high = [1, 1, 1];
    }
    this.size = Math.hypot(...this.high.map((x, i) => x - this.low[i])) || 1;
  }

  findFaceNormals() {
    const {points, triangles} = this;
    this.faceNormals = new Float32Array(triangles.length);
    for (let f = 0; f < triangles.length; f += 3) {
      const a = 3 * triangles[f], b = 3 * triangles[f + 1], c = 3 * triangles[f + 2];
      const ux = points[b] - points[a], uy = points[b + 1] - points[a + 1], uz = points[b + 2] - points[a + 2];
      const vx = points[c] - points[a], vy = points[c + 1] - points[a + 1], vz = points[c + 2] - points[a + 2];
      const x = uy * vz - uz * vy, y = uz * vx - ux * vz, z = ux * vy - uy * vx;
      const length = Math.hypot(x, y, z) || 1;
      this.faceNormals[f] = x / length;
      this.faceNormals[f + 1] = y / length;
      this.faceNormals[f + 2] = z / length;
    }
  }

  // corners[cornerStart[p] ...] are the places in `triangles` where the point p stands.
  findCorners() {
    this.cornerStart = new Uint32Array(this.pointCount + 1);
    for (const p of this.triangles) {
      ++this.cornerStart[p + 1];
    }
    for (let p = 0; p < this.pointCount; ++p) {
      this.cornerStart[p + 1] += this.cornerStart[p];
    }
    const next = this.cornerStart.slice();
    this.corners = new Uint32Array(this.triangles.length);
    for (let i = 0; i < this.triangles.length; ++i) {
      this.corners[next[this.triangles[i]]++] = i;
    }
  }

  // Within a patch the surface is smooth unless it turns much; patches may meet smoothly, too.
  smooth(f, g) {
    const n = this.faceNormals;
    const cosine = n[3 * f] * n[3 * g] + n[3 * f + 1] * n[3 * g + 1] + n[3 * f + 2] * n[3 * g + 2];
    return cosine > (this.labels[f] === this.labels[g] ? 0.76 : 0.94);
  }

  cornerAngle(corner) {
    const f = corner - corner % 3, p = this.points;
    const a = 3 * this.triangles[corner];
    const b = 3 * this.triangles[f + (corner + 1 - f) % 3], c = 3 * this.triangles[f + (corner + 2 - f) % 3];
    const ux = p[b] - p[a], uy = p[b + 1] - p[a + 1], uz = p[b + 2] - p[a + 2];
    const vx = p[c] - p[a], vy = p[c + 1] - p[a + 1], vz = p[c + 2] - p[a + 2];
    return Math.atan2(Math.hypot(uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx), ux * vx + uy * vy + uz * vz);
  }

  // Points once for every normal and label: {position, normal, label, index}.
  shaded() {
    const {points, triangles, corners, cornerStart, faceNormals, labels} = this;
    const angles = new Float32Array(triangles.length);
    for (let i = 0; i < angles.length; ++i) {
      angles[i] = this.cornerAngle(i);
    }
    const index = new Uint32Array(triangles.length);
    let position = new Float32Array(points.length + 1024), normal = new Float32Array(position.length);
    let label = new Float32Array(position.length / 3 + 1);
    let count = 0;
    const sums = new Float32Array(3), known = [];
    const add = (p, faceLabel) => {
      if (3 * count + 3 > position.length) {
        const grown = size => array => { const larger = new Float32Array(size); larger.set(array); return larger; };
        const size = Math.ceil(position.length * 1.5 / 3) * 3;
        [position, normal] = [position, normal].map(grown(size));
        label = grown(size / 3 + 1)(label);
      }
      position.set(points.subarray(3 * p, 3 * p + 3), 3 * count);
      normal.set(sums, 3 * count);
      label[count] = faceLabel;
      return count++;
    };
    for (let p = 0; p < this.pointCount; ++p) {
      known.length = 0;
      for (let i = cornerStart[p]; i < cornerStart[p + 1]; ++i) {
        const corner = corners[i], f = (corner - corner % 3) / 3;
        sums.fill(0);
        for (let k = cornerStart[p]; k < cornerStart[p + 1]; ++k) {
          const other = corners[k], g = (other - other % 3) / 3;
          if (f === g || this.smooth(f, g)) {
            sums[0] += angles[other] * faceNormals[3 * g];
            sums[1] += angles[other] * faceNormals[3 * g + 1];
            sums[2] += angles[other] * faceNormals[3 * g + 2];
          }
        }
        let vertex = known.find(v => label[v] === labels[f] && normal[3 * v] === sums[0] &&
                                     normal[3 * v + 1] === sums[1] && normal[3 * v + 2] === sums[2]);
        if (vertex === undefined) {
          vertex = add(p, labels[f]);
          known.push(vertex);
        }
        index[corner] = vertex;
      }
    }
    return {position: position.slice(0, 3 * count), normal: normal.slice(0, 3 * count), label: label.slice(0, count), index};
  }

  // The triangle beside f that has its edge from point a to b, or -1.
  across(a, b) {
    for (let i = this.cornerStart[b]; i < this.cornerStart[b + 1]; ++i) {
      const corner = this.corners[i], f = corner - corner % 3;
      if (this.triangles[f + (corner + 1 - f) % 3] === a) {
        return f / 3;
      }
    }
    return -1;
  }

  // Where the surface is not smooth, or ends: {position, label}, two points a line, once for each label.
  sharpEdges() {
    const position = [], label = [];
    for (let i = 0; i < this.triangles.length; ++i) {
      const f = (i - i % 3) / 3, a = this.triangles[i], b = this.triangles[3 * f + (i + 1) % 3];
      const g = this.across(a, b);
      if (g >= 0 && (this.smooth(f, g) || (a > b && this.labels[f] === this.labels[g]))) {
        continue;
      }
      for (const p of [a, b]) {
        position.push(this.points[3 * p], this.points[3 * p + 1], this.points[3 * p + 2]);
        label.push(this.labels[f]);
      }
    }
    return {position: new Float32Array(position), label: new Float32Array(label)};
  }

  // An index of fewer triangles: all points of a patch in one of `cells` to the size are one.
  coarse(geometry, cells) {
    const position = geometry.getAttribute("position").array, label = geometry.getAttribute("label").array;
    const index = geometry.getIndex().array, first = new Map(), same = new Uint32Array(label.length);
    for (let v = 0; v < label.length; ++v) {
      const [x, y, z] = [0, 1, 2].map(k => Math.floor((position[3 * v + k] - this.low[k]) / this.size * cells));
      const key = ((label[v] * (cells + 1) + x) * (cells + 1) + y) * (cells + 1) + z;
      const known = first.get(key);
      same[v] = known === undefined ? v : known;
      if (known === undefined) {
        first.set(key, v);
      }
    }
    const kept = new Uint32Array(index.length);
    let count = 0;
    for (let i = 0; i < index.length; i += 3) {
      const a = same[index[i]], b = same[index[i + 1]], c = same[index[i + 2]];
      if (a !== b && b !== c && c !== a) {
        kept.set([a, b, c], count);
        count += 3;
      }
    }
    return kept.slice(0, count);
  }

  // Every edge once, as an index into points of `shaded`.
  edges(shadedIndex) {
    const edges = new Uint32Array(2 * this.triangles.length);
    let count = 0;
    for (let i = 0; i < this.triangles.length; ++i) {
      const next = i % 3 === 2 ? i - 2 : i + 1;
      if (this.triangles[i] < this.triangles[next]) {
        edges[count++] = shadedIndex[i];
        edges[count++] = shadedIndex[next];
      }
    }
    return edges.slice(0, count);
  }

  // Boxes of so many triangles that follow each other, which are near each other in any usual mesh.
  makeChunks() {
    this.perChunk = 64;
    this.chunkCount = Math.ceil(this.triangleCount / this.perChunk);
    this.boxes = new Float32Array(6 * this.chunkCount);
    for (let chunk = 0; chunk < this.chunkCount; ++chunk) {
      const box = [Infinity, Infinity, Infinity, -Infinity, -Infinity, -Infinity];
      const end = 3 * Math.min(this.triangleCount, (chunk + 1) * this.perChunk);
      for (let i = 3 * chunk * this.perChunk; i < end; ++i) {
        for (let k = 0; k < 3; ++k) {
          const x = this.points[3 * this.triangles[i] + k];
          box[k] = Math.min(box[k], x);
          box[k + 3] = Math.max(box[k + 3], x);
        }
      }
      this.boxes.set(box, 6 * chunk);
    }
  }

  meetsBox(chunk, from, inverse) {
    let enter = -Infinity, leave = Infinity;
    for (let k = 0; k < 3; ++k) {
      const s = (this.boxes[6 * chunk + k] - from[k]) * inverse[k];
      const t = (this.boxes[6 * chunk + k + 3] - from[k]) * inverse[k];
      enter = Math.max(enter, Math.min(s, t));
      leave = Math.min(leave, Math.max(s, t));
    }
    return enter <= leave * (1 + 1e-6) + 1e-6;
  }

  cornersOf(f) {
    return [0, 1, 2].map(i => [...this.points.slice(3 * this.triangles[3 * f + i], 3 * this.triangles[3 * f + i] + 3)]);
  }

  // The nearest triangle that a ray meets, {triangle, way, point}, or null; accepts(triangle, point) may refuse one.
  hit(from, direction, accepts) {
    const inverse = direction.map(x => 1 / (x === 0 ? 1e-30 : x));
    const p = this.points;
    let best = null;
    for (let chunk = 0; chunk < this.chunkCount; ++chunk) {
      if (!this.meetsBox(chunk, from, inverse)) {
        continue;
      }
      const end = Math.min(this.triangleCount, (chunk + 1) * this.perChunk);
      for (let f = chunk * this.perChunk; f < end; ++f) {
        const way = this.wayTo(f, from, direction);
        if (way === null || (best !== null && way >= best.way)) {
          continue;
        }
        const point = from.map((x, k) => x + way * direction[k]);
        if (accepts(f, point)) {
          best = {triangle: f, way, point};
        }
      }
    }
    return best;
  }

  wayTo(f, from, d) {
    const p = this.points, a = 3 * this.triangles[3 * f], b = 3 * this.triangles[3 * f + 1], c = 3 * this.triangles[3 * f + 2];
    const ux = p[b] - p[a], uy = p[b + 1] - p[a + 1], uz = p[b + 2] - p[a + 2];
    const vx = p[c] - p[a], vy = p[c + 1] - p[a + 1], vz = p[c + 2] - p[a + 2];
    const qx = d[1] * vz - d[2] * vy, qy = d[2] * vx - d[0] * vz, qz = d[0] * vy - d[1] * vx;
    const determinant = ux * qx + uy * qy + uz * qz;
    if (determinant === 0) {
      return null;
    }
    const wx = from[0] - p[a], wy = from[1] - p[a + 1], wz = from[2] - p[a + 2];
    const s = (wx * qx + wy * qy + wz * qz) / determinant;
    const rx = wy * uz - wz * uy, ry = wz * ux - wx * uz, rz = wx * uy - wy * ux;
    const t = (d[0] * rx + d[1] * ry + d[2] * rz) / determinant;
    return s >= 0 && t >= 0 && s + t <= 1 ? (vx * rx + vy * ry + vz * rz) / determinant : null;
  }

  // What a plane across an axis cuts: {points, 6 numbers a segment, the solid to their left; edges, 2 a segment, on
  // which they end; labels}.
  cut(axis, place) {
    const cut = {points: [], edges: [], labels: []};
    for (let chunk = 0; chunk < this.chunkCount; ++chunk) {
      if (this.boxes[6 * chunk + axis] >= place || this.boxes[6 * chunk + axis + 3] < place) {
        continue;
      }
      const end = Math.min(this.triangleCount, (chunk + 1) * this.perChunk);
      for (let f = chunk * this.perChunk; f < end; ++f) {
        this.cutTriangle(f, axis, place, cut);
      }
    }
    return cut;
  }

  cutTriangle(f, axis, place, cut) {
    let leaving = null, entering = null;
    for (let i = 0; i < 3; ++i) {
      const a = this.triangles[3 * f + i], b = this.triangles[3 * f + (i + 1) % 3];
      const above = this.points[3 * a + axis] >= place, next = this.points[3 * b + axis] >= place;
      if (above && !next) {
        leaving = [a, b];
      } else if (!above && next) {
        entering = [a, b];
      }
    }
    if (leaving !== null && entering !== null) {
      for (const [a, b] of [leaving, entering]) {
        cut.points.push(...this.crossing(a, b, axis, place));
        cut.edges.push(Math.min(a, b) * this.pointCount + Math.max(a, b));
      }
      cut.labels.push(this.labels[f]);
    }
  }

  // The same for both triangles at an edge, bit by bit.
  crossing(a, b, axis, place) {
    const [low, high] = a < b ? [3 * a, 3 * b] : [3 * b, 3 * a];
    const p = this.points, share = (place - p[low + axis]) / (p[high + axis] - p[low + axis]);
    const point = [0, 1, 2].map(k => p[low + k] + share * (p[high + k] - p[low + k]));
    point[axis] = place;
    return point;
  }
}
