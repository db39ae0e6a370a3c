// SPDX-License-Identifier: GPL-3.0-or-later
"use strict";

/** Photos with their depths, each from a script of its own: a page from a disk may read nothing else. */
spherewalk.Photos = class {
  static kMostKept = 6; // decoded pictures are large

  constructor(photos) {
    this.photos = photos;
    this.kept = new Map(); // number -> promise, the one used last at the end
    this.awaited = new Map(); // number -> what takes the script's content
    spherewalk.arrived = (number, content) => this.awaited.get(number)?.(content);
  }

  /** A promise of { image, depth } for the photo of this number; depth is null without one. */
  get(number) {
    const known = this.kept.get(number) ?? this.load(number);
    this.kept.delete(number);
    this.kept.set(number, known);
    for (const old of [...this.kept.keys()].slice(0, -spherewalk.Photos.kMostKept)) {
      this.kept.delete(old);
    }
    return known;
  }

  async load(number) {
    try {
      const content = await this.script(number);
      const image = new Image();
      image.src = "data:image/jpeg;base64," + content.picture;
      await image.decode();
      return { image, depth: content.depth ? new spherewalk.Depth(content.depth) : null };
    } catch (failure) {
      this.kept.delete(number);
      throw failure;
    }
  }

  script(number) {
    const script = document.createElement("script");
    const content = new Promise((take, fail) => {
      this.awaited.set(number, take);
      script.onerror = () => fail(new Error(this.photos[number].script));
      script.onload = () => fail(new Error(this.photos[number].script)); // the content came before, if at all
    });
    script.src = this.photos[number].script;
    document.head.append(script);
    const done = () => {
      this.awaited.delete(number);
      script.remove();
    };
    content.then(done, done);
    return content;
  }
};
