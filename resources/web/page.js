// SPDX-License-Identifier: GPL-3.0-or-later
"use strict";

(() => {
  const place = spherewalk.place;
  const words = place.words;
  const part = (id) => document.getElementById(id);
  const number = (value, digits) => value.toLocaleString(place.language, { minimumFractionDigits: digits, maximumFractionDigits: digits });
  const filled = (sentence, ...values) => sentence.replace(/%(\d)/g, (_, i) => values[i - 1]);

  const photos = new spherewalk.Photos(place.photos);
  const plan = new spherewalk.Plan(part("plan"), place, words);
  const measure = new spherewalk.Measure(place.scale_sigma);
  let view = null; // null in a browser without WebGL
  let here = 0; // number of the photo
  let isMeasuring = false;
  let isWalking = false;

  function say(sentence) {
    part("said").textContent = sentence;
  }

  function trouble(sentence) {
    part("trouble").textContent = sentence;
    part("trouble").hidden = sentence === "";
  }

  function list(id, items) {
    part(id).replaceChildren(...items.map((item) => {
      const line = document.createElement("li");
      line.append(...[item].flat());
      return line;
    }));
  }

  function showPhoto() {
    const photo = place.photos[here];
    const [x, y, z] = photo.position.map((value) => number(value, 2));
    const sigma = Math.hypot(photo.sigma_position_m, place.scale_sigma * Math.hypot(...photo.position));
    const verdict = photo.decision === "accepted" ? [words[photo.state], words.accepted] : [words[photo.state]];
    part("station").value = here;
    part("picture").setAttribute("aria-label", filled(words.panoramaAbout, photo.station));
    part("state").className = photo.state;
    part("state").textContent = place.has_review ? verdict.join("; ") : "";
    part("place").textContent = photo.sigma_position_m > 0
      ? filled(words.within, x, y, z, number(Math.max(sigma, 0.001), sigma < 0.01 ? 3 : 2)) : filled(words.at, x, y, z);
    part("note").textContent = photo.note === "" ? "" : filled(words.note, photo.note);
    list("findings", [
      ...photo.findings,
      ...(photo.heading_known ? [] : [words.noHeading]),
      ...(photo.depth ? [] : [words.noDepth]),
      ...(photo.error_px === null ? [] : [filled(words.errorOf, number(photo.error_px, 1))]),
      ...(place.has_review ? [] : [words.noReview]),
    ]);
  }

  function setWalking(isOn) {
    isWalking = isOn;
    part("look").setAttribute("aria-busy", String(isOn));
  }

  async function go(target) {
    if (isWalking) {
      return;
    }
    setWalking(true);
    try {
      const content = view && await photos.get(target);
      here = target;
      showPhoto();
      say(isMeasuring ? measureHint() : "");
      trouble(view ? "" : words.no3d);
      showMarks([]);
      await view?.show(target, content);
    } catch (failure) {
      trouble(filled(words.photoMissing, failure.message));
    }
    showMarks(neighbours().map(({ position }) => [position[0], position[1], place.floor_m]));
    look();
    setWalking(false);
  }

  function neighbours() {
    return place.photos[here].neighbours.map((other) => place.photos[other]);
  }

  /** Walks to the neighbour that lies best in this direction, 60 degrees to either side. */
  function walk(heading) {
    const from = place.photos[here].position;
    let best = null;
    let least = Infinity;
    for (const other of place.photos[here].neighbours) {
      const [x, y] = place.photos[other].position;
      const aside = Math.atan2(y - from[1], x - from[0]) - heading;
      const ahead = Math.cos(aside);
      const detour = Math.hypot(x - from[0], y - from[1]) / ahead ** 2; // a near one, but rather straight ahead
      if (ahead > 0.5 && detour < least) {
        [best, least] = [other, detour];
      }
    }
    if (best === null) {
      say(words.nowhere);
    } else {
      go(best);
    }
  }

  /** Walks to the ring on the floor that a ray meets, or else into its direction. */
  function walkAlong(ray) {
    const from = place.photos[here].position;
    const along = (place.floor_m - from[2]) / ray.z;
    const reach = 0.2 + 0.05 * along; // far rings are small
    const away = (other) => {
      const [x, y] = place.photos[other].position;
      return Math.hypot(x - from[0] - along * ray.x, y - from[1] - along * ray.y);
    };
    const ringed = along > 0 ? place.photos[here].neighbours.filter((other) => away(other) < reach) : [];
    if (ringed.length > 0) {
      go(ringed.sort((a, b) => away(a) - away(b))[0]);
    } else {
      walk(Math.atan2(ray.y, ray.x));
    }
  }

  function measureHint() {
    if (!place.photos[here].depth) {
      return words.noDepth;
    }
    return measure.begun ? words.secondPoint : words.firstPoint;
  }

  function setMeasuring(isOn) {
    isMeasuring = isOn && view !== null;
    measure.begun = null;
    part("measure").setAttribute("aria-pressed", String(isMeasuring));
    part("look").classList.toggle("measuring", isMeasuring);
    part("aim").hidden = !isMeasuring;
    say(isMeasuring ? measureHint() : "");
    showDistances();
  }

  function takePoint(x, y) {
    const found = view.surface?.measured(view.ray(x, y));
    if (isWalking || !found) {
      say(place.photos[here].depth ? words.noDepthHere : words.noDepth);
      return;
    }
    measure.add(spherewalk.Measure.point(here, place.photos[here], found, view.pixelAngle()));
    showDistances();
    const last = measure.distances.at(-1);
    say(measure.begun ? words.secondPoint : distanceWords(last));
  }

  function distanceWords({ metres, sigma }) {
    return filled(words.metres, number(metres, 2), number(Math.max(sigma, 0.01), 2));
  }

  function showDistances() {
    part("distances").hidden = measure.distances.length === 0;
    list("measures", measure.distances.map(distanceWords));
    part("labels").replaceChildren(...measure.distances.map((distance) => {
      const label = document.createElement("span");
      label.textContent = distanceWords(distance);
      return label;
    }));
    plan.showLines(measure.distances.map(({ ends }) => ends));
    showMarks();
    look();
  }

  let rings = [];
  function showMarks(points = rings) {
    rings = points;
    const begun = measure.begun ? [[measure.begun.at]] : [];
    view?.mark(rings, [...measure.distances.map(({ ends }) => ends), ...begun]);
  }

  /** Lets plan and labels follow the camera. */
  function look() {
    if (!view) {
      plan.look(place.photos[here].position, 0, 0);
      return;
    }
    const at = view.camera.position.toArray().map((value, i) => value + view.origin[i]);
    plan.look(view.surface ? at : place.photos[here].position, view.yaw, view.field * Math.PI / 180);
    [...part("labels").children].forEach((label, i) => {
      const [a, b] = measure.distances[i].ends;
      const place = view.onCanvas(a.map((value, axis) => (value + b[axis]) / 2));
      label.hidden = place === null;
      if (place) {
        [label.style.left, label.style.top] = place.map((value) => value + "px");
      }
    });
  }

  /** entries: words with a colour, or with the kind of a mark on the plan. */
  function listSigns(id, entries) {
    list(id, entries.map(({ colour, kind, words: meaning, value }) => {
      const sign = plan.add(document.createElement("i"), "svg", { viewBox: "-1 -1 2 2", "aria-hidden": "true" });
      if (kind === "missing") {
        plan.add(sign, "path", { d: "M-.8-.8L.8.8M-.8.8L.8-.8", stroke: "var(--failed)", "stroke-width": 0.25 });
      } else {
        plan.add(sign, "circle", { r: 0.9, fill: colour ?? `var(--${kind})` });
      }
      return [sign, filled(meaning, number(value ?? 0, 2))];
    }));
  }

  function showMap() {
    const map = place.maps[part("map").value];
    plan.showMap(map ?? null);
    part("mapAbout").textContent = map ? map.about : "";
    listSigns("legend", map ? map.legend : []);
  }

  function showStates() {
    const states = place.has_review ? [...new Set(place.photos.map((photo) => photo.state))] : [];
    const whys = [...new Set(place.without_photo.map(({ why }) => why))];
    listSigns("states", [
      ...states.map((kind) => ({ kind, words: words[kind] })),
      ...whys.map((why) => ({ kind: "missing", words: words[why] })),
    ]);
  }

  const quarter = Math.PI / 12;
  const keys = {
    ArrowLeft: () => view?.turn(quarter, 0),
    ArrowRight: () => view?.turn(-quarter, 0),
    ArrowUp: () => walk(view ? view.yaw : 0),
    ArrowDown: () => walk((view ? view.yaw : 0) + Math.PI),
    PageUp: () => view?.turn(0, quarter),
    PageDown: () => view?.turn(0, -quarter),
    Home: () => view?.turn(0, -view.pitch),
    "+": () => view?.zoom(0.8),
    "-": () => view?.zoom(1.25),
    m: () => setMeasuring(!isMeasuring),
    Enter: () => isMeasuring && takePoint(part("picture").clientWidth / 2, part("picture").clientHeight / 2),
    Backspace: () => forget(),
    Escape: () => setMeasuring(false),
    "?": () => part("help").showModal(),
  };

  function forget() {
    measure.undo();
    showDistances();
    say(isMeasuring ? measureHint() : "");
  }

  function onKey(event) {
    const isBusy = event.target.closest("select, dialog") || (event.key === "Enter" && event.target.closest("button"));
    const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    const action = keys[key === "=" ? "+" : key];
    if (action && !isBusy && !event.ctrlKey && !event.altKey && !event.metaKey) {
      event.preventDefault();
      action();
    }
  }

  /** Turns with one pointer, zooms with two, and takes a short press that does not move as a click. */
  function watchPointers(canvas) {
    const down = new Map(); // pointer -> where it is
    let moved = 0;
    const spread = () => {
      const [a, b] = [...down.values()];
      return Math.hypot(a.x - b.x, a.y - b.y);
    };
    canvas.addEventListener("pointerdown", (event) => {
      canvas.setPointerCapture(event.pointerId);
      moved = down.size === 0 ? 0 : Infinity; // two fingers are no click
      down.set(event.pointerId, { x: event.offsetX, y: event.offsetY });
    });
    canvas.addEventListener("pointermove", (event) => {
      const last = down.get(event.pointerId);
      if (!last) {
        return;
      }
      const now = { x: event.offsetX, y: event.offsetY };
      const before = down.size === 2 ? spread() : 0;
      down.set(event.pointerId, now);
      moved += Math.hypot(now.x - last.x, now.y - last.y);
      if (down.size === 1) {
        view.turn((now.x - last.x) * view.pixelAngle(), (now.y - last.y) * view.pixelAngle());
      } else if (down.size === 2 && spread() > 0) {
        view.zoom(before / spread());
      }
    });
    const kClickPx = 8;
    canvas.addEventListener("pointerup", (event) => {
      if (down.delete(event.pointerId) && down.size === 0 && moved < kClickPx && event.button === 0) {
        if (isMeasuring) {
          takePoint(event.offsetX, event.offsetY);
        } else {
          walkAlong(view.ray(event.offsetX, event.offsetY));
        }
      }
    });
    canvas.addEventListener("pointercancel", (event) => down.delete(event.pointerId));
    canvas.addEventListener("wheel", (event) => {
      event.preventDefault();
      view.zoom(1.001 ** event.deltaY);
    }, { passive: false });
  }

  function addOptions(id, items) {
    part(id).replaceChildren(...items.map(([value, text]) => new Option(text, value)));
  }

  function showWords() {
    document.querySelectorAll("[data-word]").forEach((element) => { element.textContent = words[element.dataset.word]; });
    document.querySelectorAll("[data-label]").forEach((element) => {
      element.setAttribute("aria-label", words[element.dataset.label]);
      element.title = words[element.dataset.label];
    });
    const count = place.photos.length === 1 ? words.onePhoto : filled(words.photos, place.photos.length);
    const day = new Date(place.created_utc).toLocaleDateString(place.language);
    const scale = place.scale_sigma >= 0.005 ? " " + filled(words.scale, number(100 * place.scale_sigma, 1)) : "";
    part("about").textContent = count + ", " + filled(words.made, place.made_by, day) + "." + scale;
    const rows = [["← →", "keyTurn"], ["↑ ↓", "keyWalk"], ["PageUp PageDown", "keyTilt"], ["+ −", "keyZoom"], ["Home", "keyLevel"],
      ["M", "keyMeasure"], ["Enter", "keyPoint"], ["Backspace", "keyUndo"], ["Esc", "keyEnd"], ["?", "keyKeys"]];
    for (const [key, word] of rows) {
      const [term, meaning] = [document.createElement("dt"), document.createElement("dd")];
      term.textContent = key;
      meaning.textContent = words[word];
      part("keyList").append(term, meaning);
    }
    addOptions("station", place.photos.map((photo, i) => [i, photo.station]));
    addOptions("map", [[-1, words.nothing], ...place.maps.map((map, i) => [i, map.name])]);
  }

  function begin() {
    showWords();
    try {
      view = new spherewalk.View(part("picture"), place);
      view.onturn = look;
      watchPointers(part("picture"));
    } catch {
      part("tools").hidden = true;
    }
    const clicks = { back: "ArrowDown", ahead: "ArrowUp", closer: "+", wider: "-", measure: "m", keys: "?", forget: "Backspace" };
    for (const [id, key] of Object.entries(clicks)) {
      part(id).addEventListener("click", () => keys[key]());
    }
    part("station").addEventListener("change", () => go(Number(part("station").value)));
    part("map").addEventListener("change", showMap);
    plan.onpick = go;
    document.addEventListener("keydown", onKey);
    showStates();
    showMap();
    go(place.begin);
  }

  begin();
})();
