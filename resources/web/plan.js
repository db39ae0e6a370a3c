// SPDX-License-Identifier: GPL-3.0-or-later
"use strict";

/** The room from above, y upwards, with the photos and a map of the floor. Frames: room. */
spherewalk.Plan = class {
  static kSpace = "http://www.w3.org/2000/svg";
  static kMarginShare = 0.08;
  static kReachPx = 28; // a tap is rarely nearer

  constructor(parent, place, words) {
    this.place = place;
    const points = [...place.outline, ...place.photos.map((photo) => photo.position), ...place.without_photo.map((one) => one.at)];
    const xs = points.map((point) => point[0]);
    const ys = points.map((point) => point[1]);
    const [left, right, low, high] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
    const size = Math.max(right - left, high - low, 1);
    const margin = spherewalk.Plan.kMarginShare * size;
    this.size = size;
    this.svg = this.add(parent, "svg", {
      viewBox: [left - margin, -high - margin, right - left + 2 * margin, high - low + 2 * margin].join(" "),
      role: "img",
    });
    this.svg.setAttribute("aria-label", words.planAbout);
    this.floor = this.add(this.svg, "g", {});
    this.polygon(this.floor, place.outline, "outline");
    this.cells = this.add(this.floor, "g", {});
    place.obstacles.forEach((obstacle) => this.polygon(this.floor, obstacle, "obstacle"));
    this.polygon(this.floor, place.outline, "wall");
    this.lines = this.add(this.svg, "g", {});
    this.sight = this.add(this.svg, "path", { class: "sight" });
    this.addStations(words);
    for (const room of place.rooms) {
      this.label(room.at, room.name, 0.035 * size, "");
    }
    this.addScale([left - 0.5 * margin, low - 0.5 * margin], margin);
    this.here = this.add(this.svg, "circle", { class: "here", r: 1.6 * this.radius() });
    this.onpick = () => {};
    this.svg.addEventListener("click", (event) => this.pick(event));
  }

  add(parent, kind, attributes) {
    const element = document.createElementNS(spherewalk.Plan.kSpace, kind);
    for (const [name, value] of Object.entries(attributes)) {
      element.setAttribute(name, value);
    }
    parent.append(element);
    return element;
  }

  polygon(parent, corners, kind) {
    if (corners.length > 0) {
      this.add(parent, "polygon", { points: corners.map(([x, y]) => x + "," + -y).join(" "), class: kind });
    }
  }

  label([x, y], words, size, kind) {
    this.add(this.svg, "text", { x, y: -y, class: kind, "font-size": size }).textContent = words;
  }

  radius() {
    const { photos, step_m } = this.place;
    return Math.min(0.018 * this.size, photos.length > 1 && step_m > 0 ? 0.35 * step_m : Infinity);
  }

  addStations(words) {
    const radius = this.radius();
    const signs = { doubtful: "!", failed: "×" };
    for (const photo of this.place.photos) {
      const [x, y] = photo.position;
      const mark = this.add(this.svg, "circle", { cx: x, cy: -y, r: radius, class: photo.state });
      this.add(mark, "title", {}).textContent = photo.station;
      if (signs[photo.state]) {
        this.label(photo.position, signs[photo.state], 1.6 * radius, "sign");
      }
    }
    for (const one of this.place.without_photo) {
      const [x, y] = one.at;
      const mark = this.add(this.svg, "path", {
        d: `M${x - radius},${-y - radius}l${2 * radius},${2 * radius}m0,${-2 * radius}l${-2 * radius},${2 * radius}`,
        class: "missing",
      });
      this.add(mark, "title", {}).textContent = one.station + ": " + words[one.why];
    }
  }

  /** The room's axes, a round number of metres long, in the corner with least x and y. */
  addScale([x, y], margin) {
    const metres = [10, 5, 2, 1, 0.5, 0.2, 0.1].find((length) => length <= 0.25 * this.size) ?? 0.1;
    const arrow = 0.2 * margin;
    this.add(this.svg, "path", {
      d: `M${x},${-y - metres}m${-arrow},${arrow}l${arrow},${-arrow}l${arrow},${arrow}m${-arrow},${-arrow}L${x},${-y}h${metres}`
        + `m${-arrow},${-arrow}l${arrow},${arrow}l${-arrow},${arrow}`,
      class: "axis",
    });
    this.label([x + metres + 0.35 * margin, y - 0.2 * margin], "x", 0.5 * margin, "axis");
    this.label([x, y + metres + 0.25 * margin], "y", 0.5 * margin, "axis");
    this.label([x + metres / 2, y - 0.45 * margin], metres + " m", 0.45 * margin, "axis");
  }

  pick(event) {
    const { photos } = this.place;
    const inRoom = this.svg.getScreenCTM();
    const away = photos.map(({ position }) => {
      const x = inRoom.a * position[0] + inRoom.e;
      const y = inRoom.d * -position[1] + inRoom.f;
      return Math.hypot(x - event.clientX, y - event.clientY);
    });
    const nearest = away.indexOf(Math.min(...away));
    if (away[nearest] <= spherewalk.Plan.kReachPx) {
      this.onpick(nearest);
    }
  }

  /** Shows where the camera stands and looks. Units: radians. */
  look([x, y], yaw, field) {
    this.here.setAttribute("cx", x);
    this.here.setAttribute("cy", -y);
    const reach = 6 * this.radius();
    const edge = (angle) => `${x + reach * Math.cos(angle)},${-y - reach * Math.sin(angle)}`;
    this.sight.setAttribute("d", `M${x},${-y}L${edge(yaw - field / 2)}A${reach},${reach} 0 0 0 ${edge(yaw + field / 2)}Z`);
  }

  /** Colours the floor by the nearest photo, or as the map's own floor says; null: no map. */
  showMap(map) {
    this.cells.replaceChildren();
    if (!map) {
      return;
    }
    const { origin, cell_m: cell, runs } = map.floor ?? this.place.floor;
    for (const [row, begin, end, colour] of runs) {
      if (map.colours[colour]) {
        this.add(this.cells, "rect", {
          x: origin[0] + cell * begin, y: -origin[1] - cell * (row + 1), width: cell * (end - begin), height: cell,
          fill: map.colours[colour], "shape-rendering": "crispEdges",
        });
      }
    }
  }

  /** lines: pairs of points. */
  showLines(lines) {
    this.lines.replaceChildren();
    for (const [[x1, y1], [x2, y2]] of lines) {
      this.add(this.lines, "path", { d: `M${x1},${-y1}L${x2},${-y2}`, class: "measured" });
    }
  }
};
