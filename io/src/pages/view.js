"use strict";
// The picture: camera, surfaces, lines. Nothing here knows the tables.

const kSurfaceVertex = `
  attribute float label;
  uniform sampler2D looks;
  uniform vec2 looksSize;
  uniform vec4 plane;
  varying vec3 way;
  varying vec3 colour;
  varying float above;
  void main() {
    vec4 look = texture2D(looks, (vec2(mod(label, looksSize.x), floor(label / looksSize.x)) + 0.5) / looksSize);
    colour = look.rgb;
    above = dot(plane.xyz, position) - plane.w;
    way = normalMatrix * normal;
    gl_Position = look.a < 0.5 ? vec4(2.0, 2.0, 2.0, 1.0) : projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  }`;

const kSurfaceFragment = `
  varying vec3 way;
  varying vec3 colour;
  varying float above;
  void main() {
    if (above > 0.0) discard;
    vec3 n = normalize(way);
    vec3 base = colour;
    if (!gl_FrontFacing) {
      n = -n;
      base = mix(colour, vec3(0.45, 0.42, 0.40), 0.6);
    }
    float key = max(dot(n, normalize(vec3(-0.4, 0.45, 0.85))), 0.0);
    float fill = max(dot(n, normalize(vec3(0.8, -0.35, 0.6))), 0.0);
    float sky = 0.5 + 0.5 * n.y;
    float shine = pow(max(dot(n, normalize(vec3(-0.25, 0.38, 1.0))), 0.0), 40.0);
    gl_FragColor = vec4(base * (0.4 + 0.16 * sky + 0.42 * key + 0.16 * fill) + 0.12 * shine, 1.0);
  }`;

const kLineVertex = `
  attribute float label;
  uniform sampler2D looks;
  uniform vec2 looksSize;
  uniform vec4 plane;
  varying float above;
  void main() {
    vec4 look = texture2D(looks, (vec2(mod(label, looksSize.x), floor(label / looksSize.x)) + 0.5) / looksSize);
    above = dot(plane.xyz, position) - plane.w;
    gl_Position = look.a < 0.5 ? vec4(2.0, 2.0, 2.0, 1.0) : projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  }`;

const kLineFragment = `
  uniform vec4 ink;
  varying float above;
  void main() {
    if (above > 0.0) discard;
    gl_FragColor = ink;
  }`;

const kViews = {
  iso: [-Math.PI / 4, Math.atan(Math.SQRT1_2)],
  front: [-Math.PI / 2, 0],
  right: [0, 0],
  top: [-Math.PI / 2, Math.PI / 2],
};
const kFieldOfView = 0.6;
const kRest = 250, kSlowFrame = 70;  // milliseconds
const kMany = 100000;  // triangles

function frameOf(azimuth, elevation) {
  const [ca, sa, ce, se] = [Math.cos(azimuth), Math.sin(azimuth), Math.cos(elevation), Math.sin(elevation)];
  return {right: [-sa, ca, 0], up: [-se * ca, -se * sa, ce], towards: [ce * ca, ce * sa, se]};
}

class View {
  constructor(stage, mesh, labelCount) {
    this.stage = stage;
    this.canvas = stage.querySelector("#picture");
    this.mesh = mesh;
    this.pose = {target: [0, 0, 0], azimuth: kViews.iso[0], elevation: kViews.iso[1], height: mesh.size};
    this.marks = [];
    this.painters = [];
    this.isPerspective = false;
    this.renderer = new THREE.WebGLRenderer({canvas: this.canvas, antialias: true, alpha: true});
    this.renderer.setClearColor(0, 0);
    this.orthographic = new THREE.OrthographicCamera(-1, 1, 1, -1, 0, 1);
    this.perspective = new THREE.PerspectiveCamera(kFieldOfView * 180 / Math.PI, 1, 0.1, 1);
    this.makeScene(labelCount);
    new ResizeObserver(() => this.resize()).observe(stage);
    this.resize();
    this.fit();
  }

  makeScene(labelCount) {
    const width = 256, height = Math.max(1, Math.ceil(labelCount / width));
    this.looks = new Uint8Array(4 * width * height).fill(255);
    this.texture = new THREE.DataTexture(this.looks, width, height, THREE.RGBAFormat);
    this.section = new Section(this);
    this.shared = {looks: {value: this.texture}, looksSize: {value: new THREE.Vector2(width, height)}, plane: this.section.plane};
    this.scene = new THREE.Scene();
    const shaded = this.mesh.shaded();
    this.shadedIndex = shaded.index;
    this.surfaceGeometry = new THREE.BufferGeometry();
    this.surfaceGeometry.setAttribute("position", new THREE.BufferAttribute(shaded.position, 3));
    this.surfaceGeometry.setAttribute("normal", new THREE.BufferAttribute(shaded.normal, 3));
    this.surfaceGeometry.setAttribute("label", new THREE.BufferAttribute(shaded.label, 1));
    this.surfaceGeometry.setIndex(new THREE.BufferAttribute(shaded.index, 1));
    this.surface = this.add(new THREE.Mesh(this.surfaceGeometry, new THREE.ShaderMaterial({
      uniforms: this.shared, vertexShader: kSurfaceVertex, fragmentShader: kSurfaceFragment,
      side: THREE.DoubleSide, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1})), 0);
    const sharp = this.mesh.sharpEdges();
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.BufferAttribute(sharp.position, 3));
    geometry.setAttribute("label", new THREE.BufferAttribute(sharp.label, 1));
    this.sharpEdges = this.add(new THREE.LineSegments(geometry, this.lineMaterial([0.13, 0.17, 0.22, 1])), 3);
    this.section.objects().forEach(([object, order]) => this.add(object, order));
    this.markLines = this.add(new THREE.LineSegments(new THREE.BufferGeometry(),
      new THREE.LineBasicMaterial({color: 0xd32f2f, depthTest: false, transparent: true})), 5);
    this.markLines.visible = false;
  }

  // Of one thing after the other, nothing culled: everything is in view most of the time.
  add(object, order) {
    object.renderOrder = order;
    object.frustumCulled = false;
    this.scene.add(object);
    return object;
  }

  lineMaterial(ink) {
    return new THREE.ShaderMaterial({uniforms: {...this.shared, ink: {value: new THREE.Vector4(...ink)}},
      vertexShader: kLineVertex, fragmentShader: kLineFragment});
  }

  setLook(label, [red, green, blue], isShown) {
    if (this.isShown(label) !== isShown) {
      this.section.isStale = true;
    }
    this.looks.set([red, green, blue, isShown ? 255 : 0], 4 * label);
    this.texture.needsUpdate = true;
    this.request();
  }

  isShown(label) { return this.looks[4 * label + 3] > 0; }

  setWireframe(isOn) {
    if (isOn && !this.wireframe) {
      const geometry = new THREE.BufferGeometry();
      geometry.setAttribute("position", this.surfaceGeometry.getAttribute("position"));
      geometry.setAttribute("label", this.surfaceGeometry.getAttribute("label"));
      geometry.setIndex(new THREE.BufferAttribute(this.mesh.edges(this.shadedIndex), 1));
      const material = this.lineMaterial([0.1, 0.14, 0.2, 0.35]);
      material.transparent = true;
      this.wireframe = this.add(new THREE.LineSegments(geometry, material), 3);
    }
    if (this.wireframe) {
      this.wireframe.visible = isOn;
    }
    this.request();
  }

  setSharpEdges(isOn) {
    this.sharpEdges.visible = isOn;
    this.request();
  }

  setPerspective(isOn) {
    this.isPerspective = isOn;
    this.request();
  }

  // Polylines that are drawn over everything.
  setMarkLines(lines) {
    const positions = [];
    for (const line of lines) {
      for (let i = 1; i < line.length; ++i) {
        positions.push(...line[i - 1], ...line[i]);
      }
    }
    this.markLines.visible = positions.length > 0;
    this.markLines.geometry.dispose();
    this.markLines.geometry = new THREE.BufferGeometry();
    this.markLines.geometry.setAttribute("position", new THREE.BufferAttribute(new Float32Array(positions), 3));
    this.request();
  }

  resize() {
    const width = Math.max(1, this.stage.clientWidth), height = Math.max(1, this.stage.clientHeight);
    this.width = width;
    this.height = height;
    this.renderer.setPixelRatio(window.devicePixelRatio || 1);
    this.renderer.setSize(width, height, false);
    this.section.setPixelRatio(window.devicePixelRatio || 1);
    this.request();
  }

  // The directions of the picture: to the right, upwards, towards the viewer.
  frame() { return frameOf(this.pose.azimuth, this.pose.elevation); }

  distance() {
    return this.isPerspective ? this.pose.height / 2 / Math.tan(kFieldOfView / 2) : 2 * this.mesh.size;
  }

  place() {
    const {right, up, towards} = this.frame(), {target, height} = this.pose, distance = this.distance();
    const camera = this.isPerspective ? this.perspective : this.orthographic;
    const aspect = this.width / this.height;
    const middle = [0, 1, 2].map(k => (this.mesh.low[k] + this.mesh.high[k]) / 2);
    const reach = 0.51 * this.mesh.size + Math.hypot(...target.map((x, k) => x - middle[k]));
    camera.far = distance + reach;
    if (this.isPerspective) {
      camera.near = Math.max(distance - reach, distance / 200);
      camera.aspect = aspect;
    } else {
      camera.near = distance - reach;
      Object.assign(camera, {left: -height * aspect / 2, right: height * aspect / 2, top: height / 2, bottom: -height / 2});
    }
    camera.updateProjectionMatrix();
    camera.matrix.makeBasis(new THREE.Vector3(...right), new THREE.Vector3(...up), new THREE.Vector3(...towards));
    camera.matrix.setPosition(...target.map((x, k) => x + distance * towards[k]));
    camera.matrixAutoUpdate = false;
    camera.updateMatrixWorld(true);
    this.camera = camera;
  }

  request() {
    if (!this.requested) {
      this.requested = true;
      requestAnimationFrame(now => {
        this.requested = false;
        this.step(now);
        this.chooseDetail(now);
        this.section.refresh();
        this.place();
        this.renderer.render(this.scene, this.camera);
        this.painters.forEach(paint => paint());
      });
    }
  }

  // While the picture moves, and frames take long, fewer triangles do.
  moved() {
    this.isMoving = true;
    clearTimeout(this.resting);
    this.resting = setTimeout(() => this.request(), kRest);
    this.request();
  }

  chooseDetail(now) {
    const isMoving = this.isMoving;
    this.isMoving = false;
    if (isMoving && this.wasMoving && now - this.lastFrame > kSlowFrame) {
      this.slowFrames = (this.slowFrames || 0) + 1;
    }
    this.wasMoving = isMoving;
    this.lastFrame = now;
    const isCoarse = isMoving && this.slowFrames >= 2 && this.mesh.triangleCount > kMany;
    if (isCoarse && !this.coarseGeometry) {
      this.coarseGeometry = new THREE.BufferGeometry();
      for (const name of ["position", "normal", "label"]) {
        this.coarseGeometry.setAttribute(name, this.surfaceGeometry.getAttribute(name));
      }
      this.coarseGeometry.setIndex(new THREE.BufferAttribute(this.mesh.coarse(this.surfaceGeometry, 140), 1));
    }
    this.surface.geometry = isCoarse ? this.coarseGeometry : this.surfaceGeometry;
  }

  step(now) {
    const flight = this.flight;
    if (!flight) {
      return;
    }
    flight.begin = flight.begin === undefined ? now : flight.begin;
    const share = Math.min(1, (now - flight.begin) / flight.duration);
    const s = share * share * (3 - 2 * share), mix = (a, b) => a + s * (b - a);
    this.pose = {
      target: flight.from.target.map((x, k) => mix(x, flight.to.target[k])),
      azimuth: mix(flight.from.azimuth, flight.to.azimuth),
      elevation: mix(flight.from.elevation, flight.to.elevation),
      height: Math.exp(mix(Math.log(flight.from.height), Math.log(flight.to.height))),
    };
    if (share < 1) {
      this.moved();
    } else {
      this.pose = flight.to;
      this.flight = null;
    }
  }

  fly(pose) {
    const to = {...this.pose, ...pose};
    const turn = (to.azimuth - this.pose.azimuth) / (2 * Math.PI);
    const from = {...this.pose, azimuth: this.pose.azimuth + 2 * Math.PI * Math.round(turn)};
    const isCalm = window.matchMedia("(prefers-reduced-motion: reduce)").matches;
    this.flight = {from, to, duration: isCalm ? 1 : 450};
    this.request();
  }

  // The pose that shows points, of which accepts(index) says that they count, from where one looks already.
  poseOf(accepts) {
    const {right, up, towards} = this.frame(), axes = [right, up, towards], p = this.mesh.points;
    const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
    for (let i = 0; i < this.mesh.pointCount; ++i) {
      if (accepts(i)) {
        for (let k = 0; k < 3; ++k) {
          const at = axes[k][0] * p[3 * i] + axes[k][1] * p[3 * i + 1] + axes[k][2] * p[3 * i + 2];
          low[k] = Math.min(low[k], at);
          high[k] = Math.max(high[k], at);
        }
      }
    }
    if (!(low[0] <= high[0])) {
      return {target: [0, 0, 0], height: this.mesh.size};
    }
    const middle = low.map((x, k) => (x + high[k]) / 2);
    const height = 1.25 * Math.max(high[1] - low[1], (high[0] - low[0]) * this.height / this.width) || this.mesh.size;
    return {target: [0, 1, 2].map(k => axes.reduce((sum, axis, i) => sum + axis[k] * middle[i], 0)), height};
  }

  fit() { this.pose = {...this.pose, ...this.poseOf(() => true)}; this.request(); }

  flyToFit(name) {
    const before = this.pose;
    if (name) {
      this.pose = {...before, azimuth: kViews[name][0], elevation: kViews[name][1]};
    }
    const to = {...this.pose, ...this.poseOf(() => true)};
    this.pose = before;
    this.fly(to);
  }

  // Of a point of the stage, in pixels: where a ray of sight begins and where it goes.
  ray(x, y) {
    const {right, up, towards} = this.frame(), {target, height} = this.pose, distance = this.distance();
    const s = (x - this.width / 2) / this.height * height, t = (this.height / 2 - y) / this.height * height;
    const seen = target.map((c, k) => c + s * right[k] + t * up[k]);
    const from = (this.isPerspective ? target : seen).map((c, k) => c + distance * towards[k]);
    const direction = this.isPerspective ? seen.map((c, k) => c - from[k]) : towards.map(c => -c);
    const length = Math.hypot(...direction);
    return {from, direction: direction.map(c => c / length)};
  }

  // Pixels of the stage.
  project(point) {
    const {right, up, towards} = this.frame(), {target, height} = this.pose;
    const [s, t, u] = [right, up, towards].map(axis => axis.reduce((sum, a, k) => sum + a * (point[k] - target[k]), 0));
    const scale = this.height / height * (this.isPerspective ? this.distance() / Math.max(1e-9, this.distance() - u) : 1);
    return [this.width / 2 + s * scale, this.height / 2 - t * scale];
  }

  // What is seen there: {label, point, corners near it}, or null. Cuts are seen so many pixels beside them, too.
  hit(x, y, reach = 0) {
    const {from, direction} = this.ray(x, y);
    const cap = this.section.hit(from, direction, reach * this.pose.height / this.height);
    if (cap) {
      return cap;
    }
    const found = this.mesh.hit(from, direction, (f, point) => this.isSeen(f, point));
    return found && {label: this.mesh.labels[found.triangle], point: found.point, corners: this.mesh.cornersOf(found.triangle)};
  }

  isSeen(triangle, point) { return this.isShown(this.mesh.labels[triangle]) && !this.section.isCutAway(point); }

  // Whether nothing of the solid is before one of the points, seen from there.
  areSeen(points, azimuth, elevation, slack) {
    const {towards} = frameOf(azimuth, elevation);
    return points.some(point => {
      const from = point.map((x, k) => x + slack * towards[k]);
      return this.mesh.hit(from, towards, (f, at) => this.isSeen(f, at) &&
        towards.reduce((way, t, k) => way + t * (at[k] - from[k]), 0) > 0) === null;
    });
  }

  // The direction nearest to the present one from where one of the points is seen; the present one if there is none.
  poseToSee(points, slack) {
    const {azimuth, elevation} = this.pose, candidates = [];
    for (let turn = -4; turn < 4; ++turn) {
      for (const to of [elevation, 0, 0.35, -0.35, 0.8, -0.8, 1.2, -1.2]) {
        const way = [azimuth + turn * Math.PI / 4, to];
        const cosine = frameOf(...way).towards.reduce((sum, x, k) => sum + x * this.frame().towards[k], 0);
        candidates.push({way, cosine});
      }
    }
    candidates.sort((a, b) => b.cosine - a.cosine);
    const found = candidates.find(({way}) => this.areSeen(points, ...way, slack));
    return found ? {azimuth: found.way[0], elevation: found.way[1]} : {};
  }

  turn(dx, dy) {
    const elevation = this.pose.elevation + dy * 0.008;
    this.flight = null;
    this.pose = {...this.pose, azimuth: this.pose.azimuth - dx * 0.008,
      elevation: Math.max(-Math.PI / 2, Math.min(Math.PI / 2, elevation))};
    this.moved();
  }

  shift(dx, dy) {
    const {right, up} = this.frame(), scale = this.pose.height / this.height;
    this.flight = null;
    this.pose = {...this.pose, target: this.pose.target.map((x, k) => x - dx * scale * right[k] + dy * scale * up[k])};
    this.moved();
  }

  // What is under the pointer stays there.
  zoom(factor, x, y) {
    const height = Math.max(this.mesh.size * 1e-5, Math.min(this.mesh.size * 20, this.pose.height * factor));
    const {right, up} = this.frame(), lost = (this.pose.height - height) / this.height;
    const s = (x - this.width / 2) * lost, t = (this.height / 2 - y) * lost;
    this.flight = null;
    this.pose = {...this.pose, height, target: this.pose.target.map((c, k) => c + s * right[k] + t * up[k])};
    this.moved();
  }
}
