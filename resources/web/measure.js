// SPDX-License-Identifier: GPL-3.0-or-later
"use strict";

/** Distances between points that photos show, with their standard deviations. Frames: room. Units: metres. */
spherewalk.Measure = class {
  /** scaleSigma: of all lengths, as a share of them. */
  constructor(scaleSigma) {
    this.scaleSigma = scaleSigma;
    this.distances = []; // { ends: two points, metres, sigma }
    this.begun = null; // the first point of the next distance
  }

  /** A point that a photo shows: number of the photo, its distance from the lens, and what a click is wide. */
  static point(number, photo, found, clickAngle) {
    const away = found.at.map((value, i) => value - photo.position[i]);
    const length = Math.hypot(...away);
    return {
      number,
      at: found.at,
      ray: away.map((value) => value / length),
      sigmaAlong: photo.depth.sigma_m + photo.depth.sigma_per_m * found.range ** 2,
      sigmaAcross: clickAngle * found.range,
      sigmaPose: Math.hypot(photo.sigma_position_m, photo.sigma_turn * found.range),
    };
  }

  /** Takes a point: the first one, or the end of a distance. */
  add(point) {
    if (!this.begun) {
      this.begun = point;
      return;
    }
    const between = point.at.map((value, i) => value - this.begun.at[i]);
    const metres = Math.hypot(...between);
    const line = between.map((value) => value / Math.max(metres, 1e-9));
    const isOnePhoto = point.number === this.begun.number; // whose pose both points share
    const variances = [this.begun, point].map((end) => {
      const along = line.reduce((sum, value, i) => sum + value * end.ray[i], 0) ** 2;
      return along * end.sigmaAlong ** 2 + (1 - along) * end.sigmaAcross ** 2 + (isOnePhoto ? 0 : end.sigmaPose ** 2);
    });
    const sigma = Math.hypot(Math.sqrt(variances[0] + variances[1]), this.scaleSigma * metres);
    this.distances.push({ ends: [this.begun.at, point.at], metres, sigma });
    this.begun = null;
  }

  /** Takes back the last point or, without one, the last distance. */
  undo() {
    if (this.begun) {
      this.begun = null;
    } else {
      this.distances.pop();
    }
  }
};
