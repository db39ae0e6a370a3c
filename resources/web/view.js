// SPDX-License-Identifier: GPL-3.0-or-later
"use strict";

/** A photo as its depth shows it in the room, painted by the directions in which the photo shows things. */
spherewalk.Surface = class {
  static kVertexShader = `
    varying vec3 inPhoto;
    void main() {
      inPhoto = position;
      gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
    }`;
  static kPixelShader = `
    uniform sampler2D picture;
    uniform float opacity;
    uniform float aheadM;
    varying vec3 inPhoto;
    void main() {
      vec3 ray = normalize(inPhoto - vec3(inPhoto.x < 0.0 ? -aheadM : aheadM, 0.0, 0.0));
      vec2 place = vec2(0.5 - atan(ray.y, ray.x) / 6.283185307, 0.5 + asin(ray.z) / 3.141592654);
      gl_FragColor = vec4(texture2D(picture, place).rgb, opacity);
    }`;

  constructor(photo, { image, depth }, radiusM, origin) {
    const texture = new THREE.Texture(image);
    texture.minFilter = THREE.LinearFilter;
    texture.generateMipmaps = false;
    texture.needsUpdate = true;
    this.photo = photo;
    this.depth = depth;
    this.material = new THREE.ShaderMaterial({
      uniforms: { picture: { value: texture }, opacity: { value: 1 }, aheadM: { value: photo.lens_ahead_m } },
      vertexShader: spherewalk.Surface.kVertexShader,
      fragmentShader: spherewalk.Surface.kPixelShader,
      side: THREE.DoubleSide,
    });
    const mesh = new THREE.Mesh(this.geometry(radiusM), this.material);
    const [w, x, y, z] = photo.rotation;
    mesh.quaternion.set(x, y, z, w);
    mesh.position.set(...photo.position.map((value, i) => value - origin[i]));
    mesh.frustumCulled = false;
    this.mesh = mesh;
    this.scene = new THREE.Scene();
    this.scene.add(mesh);
  }

  /** Where the lens stands that sees this direction. */
  lens(direction) {
    return [direction[0] < 0 ? -this.photo.lens_ahead_m : this.photo.lens_ahead_m, 0, 0];
  }

  geometry(radiusM) {
    const columns = 256;
    const rows = 128;
    const places = [];
    const corners = [];
    for (let row = 0; row <= rows; ++row) {
      for (let column = 0; column <= columns; ++column) {
        const azimuth = Math.PI - 2 * Math.PI * column / columns;
        const elevation = Math.PI / 2 - Math.PI * row / rows;
        const flat = Math.cos(elevation);
        const ray = [flat * Math.cos(azimuth), flat * Math.sin(azimuth), Math.sin(elevation)];
        const range = this.depth ? this.depth.shown(ray) : radiusM;
        const lens = this.lens(ray);
        places.push(...ray.map((value, i) => lens[i] + range * value));
        if (row < rows && column < columns) {
          const first = row * (columns + 1) + column;
          corners.push(first, first + columns + 1, first + 1, first + 1, first + columns + 1, first + columns + 2);
        }
      }
    }
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.Float32BufferAttribute(places, 3));
    geometry.setIndex(corners);
    return geometry;
  }

  /** The point of the room that the photo shows along a ray from its middle; null where that was not measured. */
  measured(rayInRoom) {
    const ray = rayInRoom.clone().applyQuaternion(this.mesh.quaternion.clone().inverse());
    let along = 2; // metres; only the lenses' distance depends on it
    let point = null;
    for (let pass = 0; pass < 3; ++pass) {
      const from = ray.toArray().map((value) => along * value);
      const lens = this.lens(from);
      const seen = from.map((value, i) => value - lens[i]);
      const range = this.depth?.measured(seen);
      if (!range) {
        return null;
      }
      const scale = range / Math.hypot(...seen);
      const inPhoto = new THREE.Vector3(...seen.map((value, i) => lens[i] + scale * value));
      along = inPhoto.length();
      point = { range, at: inPhoto.applyQuaternion(this.mesh.quaternion).toArray().map((value, i) => value + this.photo.position[i]) };
    }
    return point;
  }

  free() {
    this.mesh.geometry.dispose();
    this.material.uniforms.picture.value.dispose();
    this.material.dispose();
  }
};

/** The panorama: a camera that turns in one photo, and walks from photo to photo. Frames: room. */
spherewalk.View = class {
  static kWalkMs = 900;
  static kFieldDeg = { least: 25, usual: 75, most: 110 }; // of the longer side of the picture

  constructor(canvas, place) {
    this.canvas = canvas;
    this.place = place;
    this.origin = place.photos[0].position;
    this.yaw = 0;
    this.pitch = 0;
    this.field = spherewalk.View.kFieldDeg.usual;
    this.surface = null;
    this.next = null; // the surface that is walked to
    this.renderer = new THREE.WebGLRenderer({ canvas, antialias: true });
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    this.renderer.autoClear = false;
    this.camera = new THREE.PerspectiveCamera(60, 1, 0.02, 2 * spherewalk.Depth.kFarthestM);
    this.camera.up.set(0, 0, 1);
    this.marks = new THREE.Scene();
    this.onturn = () => {};
    new ResizeObserver(() => this.resize()).observe(canvas.parentElement);
  }

  inScene(point) {
    return new THREE.Vector3(...point.map((value, i) => value - this.origin[i]));
  }

  resize() {
    const { clientWidth, clientHeight } = this.canvas.parentElement;
    this.renderer.setSize(clientWidth, clientHeight, false);
    this.camera.aspect = clientWidth / clientHeight;
    this.draw();
  }

  ahead() {
    const flat = Math.cos(this.pitch);
    return new THREE.Vector3(flat * Math.cos(this.yaw), flat * Math.sin(this.yaw), Math.sin(this.pitch));
  }

  turn(left, up) {
    const most = Math.PI / 2 - 0.01;
    this.yaw = Math.atan2(Math.sin(this.yaw + left), Math.cos(this.yaw + left));
    this.pitch = Math.min(Math.max(this.pitch + up, -most), most);
    this.draw();
  }

  zoom(factor) {
    const { least, most } = spherewalk.View.kFieldDeg;
    this.field = Math.min(Math.max(this.field * factor, least), most);
    this.draw();
  }

  /** Radians that a CSS pixel in the middle is wide. */
  pixelAngle() {
    const longer = Math.max(this.canvas.clientWidth, this.canvas.clientHeight);
    return 2 * Math.tan(this.field * Math.PI / 360) / longer;
  }

  aim() {
    const { aspect } = this.camera;
    const half = Math.tan(this.field * Math.PI / 360);
    this.camera.fov = 360 / Math.PI * Math.atan(aspect > 1 ? half / aspect : half);
    this.camera.updateProjectionMatrix();
    this.camera.lookAt(this.camera.position.clone().add(this.ahead()));
    this.camera.updateMatrixWorld();
  }

  /** The direction in the room that a point of the canvas shows. Units: CSS pixels. */
  ray(x, y) {
    const { clientWidth, clientHeight } = this.canvas;
    const far = new THREE.Vector3(2 * x / clientWidth - 1, 1 - 2 * y / clientHeight, 0.5).unproject(this.camera);
    return far.sub(this.camera.position).normalize();
  }

  /** Where the canvas shows a point of the room, CSS pixels; null behind the camera. */
  onCanvas(point) {
    const inScene = this.inScene(point);
    if (inScene.clone().sub(this.camera.position).dot(this.ahead()) <= 0) {
      return null;
    }
    const { x, y } = inScene.project(this.camera);
    return [(x + 1) / 2 * this.canvas.clientWidth, (1 - y) / 2 * this.canvas.clientHeight];
  }

  /** Shows a photo that has arrived; walks there from the one before unless the person wants no motion. */
  async show(number, content) {
    const photo = this.place.photos[number];
    const surface = new spherewalk.Surface(photo, content, this.place.radius_m, this.origin);
    const calm = matchMedia("(prefers-reduced-motion: reduce)").matches;
    if (this.surface && !calm) {
      await this.walk(surface);
    }
    this.surface?.free();
    this.surface = surface;
    this.camera.position.copy(surface.mesh.position);
    this.draw();
  }

  walk(surface) {
    const from = this.surface.mesh.position;
    const began = performance.now();
    this.next = surface;
    return new Promise((arrived) => {
      const step = (now) => {
        const share = Math.min(Math.max((now - began) / spherewalk.View.kWalkMs, 0), 1);
        const eased = share * share * (3 - 2 * share);
        this.camera.position.lerpVectors(from, surface.mesh.position, eased);
        surface.material.uniforms.opacity.value = Math.min(Math.max(2 * eased - 0.5, 0), 1);
        this.draw();
        if (share < 1) {
          requestAnimationFrame(step);
          return;
        }
        this.next = null;
        surface.material.uniforms.opacity.value = 1;
        arrived();
      };
      requestAnimationFrame(step);
    });
  }

  /** Lays the surface over what is drawn. Its own nearer parts hide the farther ones. */
  overlay(surface) {
    const { material, scene } = surface;
    this.renderer.clearDepth();
    material.colorWrite = false;
    this.renderer.render(scene, this.camera);
    material.colorWrite = true;
    material.transparent = true;
    this.renderer.render(scene, this.camera);
    material.transparent = false;
  }

  draw() {
    this.aim();
    this.renderer.clear();
    if (this.surface) {
      this.renderer.render(this.surface.scene, this.camera);
      if (this.next) {
        this.overlay(this.next);
      }
      this.renderer.render(this.marks, this.camera);
    }
    this.onturn();
  }

  /** Lines and rings over the picture. rings: points on the floor; lines: pairs of points. */
  mark(rings, lines) {
    for (const old of [...this.marks.children]) {
      old.geometry.dispose();
      this.marks.remove(old);
    }
    const style = { color: 0xffffff, depthTest: false, transparent: true, opacity: 0.75 };
    this.ringStyle ??= new THREE.MeshBasicMaterial({ ...style, side: THREE.DoubleSide });
    this.lineStyle ??= new THREE.MeshBasicMaterial({ ...style, color: 0xffc20a, opacity: 1 });
    for (const point of rings) {
      const ring = new THREE.Mesh(new THREE.RingGeometry(0.1, 0.14, 32), this.ringStyle);
      ring.position.copy(this.inScene(point));
      this.marks.add(ring);
    }
    for (const ends of lines) {
      this.addLine(ends.map((point) => this.inScene(point)));
    }
    this.draw();
  }

  /** A thin tube with a ball at each end, since lines are one pixel wide everywhere. */
  addLine(ends) {
    for (const end of ends) {
      const ball = new THREE.Mesh(new THREE.SphereGeometry(0.012, 12, 8), this.lineStyle);
      ball.position.copy(end);
      this.marks.add(ball);
    }
    if (ends.length === 2) {
      const tube = new THREE.TubeGeometry(new THREE.LineCurve3(...ends), 1, 0.004, 6);
      this.marks.add(new THREE.Mesh(tube, this.lineStyle));
    }
  }
};
