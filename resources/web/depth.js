// SPDX-License-Identifier: GPL-3.0-or-later
"use strict";

/** The page's parts; data/place.js adds the place itself. */
const spherewalk = {};

/** How far away a photo's pixels are: values as in Spherewalk's depth files. Frames: the photo's. */
spherewalk.Depth = class {
  static kStepPerM = 1 / 1600;
  static kMostJump = 1.08; // of 1 / distance within one surface
  static kFarthestM = 200;

  /** encoded: little-endian words of 16 bits in base64, row by row; rows are twice as long as columns. */
  constructor(encoded) {
    const bytes = Uint8Array.from(atob(encoded), (letter) => letter.charCodeAt(0));
    const view = new DataView(bytes.buffer);
    this.height = Math.sqrt(bytes.length / 4);
    this.width = 2 * this.height;
    this.values = Uint16Array.from({ length: bytes.length / 2 }, (_, i) => view.getUint16(2 * i, true));
  }

  at(x, y) {
    const column = ((x % this.width) + this.width) % this.width;
    return this.values[Math.min(Math.max(y, 0), this.height - 1) * this.width + column];
  }

  pixel(direction) {
    const [x, y, z] = direction;
    return {
      u: (Math.PI - Math.atan2(y, x)) / (2 * Math.PI) * this.width - 0.5,
      v: (Math.PI / 2 - Math.atan2(z, Math.hypot(x, y))) / Math.PI * this.height - 0.5,
    };
  }

  /** The distance of the nearest pixel, measured or not. */
  shown(direction) {
    const { u, v } = this.pixel(direction);
    const steps = this.at(Math.round(u), Math.round(v)) >> 1;
    return Math.min(1 / (steps * spherewalk.Depth.kStepPerM), spherewalk.Depth.kFarthestM);
  }

  /** The distance in this direction; null where it was not measured, or where surfaces meet. */
  measured(direction) {
    const { u, v } = this.pixel(direction);
    const left = Math.floor(u);
    const top = Math.min(Math.max(Math.floor(v), 0), this.height - 2);
    const [x, y] = [u - left, Math.min(Math.max(v - top, 0), 1)];
    const pixels = [this.at(left, top), this.at(left + 1, top), this.at(left, top + 1), this.at(left + 1, top + 1)];
    const steps = pixels.map((value) => value >> 1);
    const isSure = pixels.every((value) => value & 1);
    if (!isSure || Math.max(...steps) > spherewalk.Depth.kMostJump * Math.min(...steps)) {
      return null;
    }
    const between = (steps[0] * (1 - x) + steps[1] * x) * (1 - y) + (steps[2] * (1 - x) + steps[3] * x) * y;
    return 1 / (between * spherewalk.Depth.kStepPerM);
  }
};
