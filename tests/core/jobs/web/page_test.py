#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Opens an exported page of a room of 3 x 2 x 2.5 m from the disk, and does with it what a person would: page_test.py FOLDER

The exit status is 77 where there is no browser.
"""
import base64
import json
import math
import pathlib
import re
import sys

import browser as browsers

ROOM = (3.0, 2.0, 2.5)
SCALE_SIGMA = 0.25  # of all lengths, as page_test.cpp writes it
PLACES = ((1.0, 0.8, 1.2), (2.0, 0.8, 1.2), (1.0, 1.3, 1.2), (2.0, 1.3, 1.2))
FIELD_DEG = 75  # of the picture's longer side
HOSTILE = '</script><img src=x onerror="hacked = 1">'


def expect(is_so, *about):
    if not is_so:
        raise AssertionError(" ".join(str(one) for one in about))


def wall(at, ray):
    """Where a ray from inside of the room meets it."""
    along = min((size - p if r > 0 else -p) / r for p, r, size in zip(at, ray, ROOM) if r)
    return tuple(p + along * r for p, r in zip(at, ray))


def colour(ray):
    """What the photos show in a direction; smoothWorld() of test_dataset.h."""
    x, y, z = ray
    return 128 + 100 * x, 128 + 60 * y + 40 * math.sin(3 * z), 128 + 80 * z + 20 * math.cos(4 * x + y)


class Page:
    def __init__(self, folder, browser):
        self.browser = browser
        self.folder = folder
        browser.open(folder / "index.html")
        self.arrive()
        self.choose("#station", 0)

    def arrive(self):
        self.browser.wait("document.querySelector('#look').getAttribute('aria-busy') === 'false'")

    def size(self):
        return self.browser.value("[document.querySelector('#picture').clientWidth, document.querySelector('#picture').clientHeight]")

    def ray(self, x, y, yaw):
        """The direction that a place of the picture shows, looking level; yaw in degrees."""
        width, height = self.size()
        scale = 2 * math.tan(math.radians(FIELD_DEG / 2)) / max(width, height)
        left, up = (width / 2 - x) * scale, (height / 2 - y) * scale
        cos, sin = math.cos(math.radians(yaw)), math.sin(math.radians(yaw))
        ray = (cos - sin * left, sin + cos * left, up)
        return tuple(value / math.dist(ray, (0, 0, 0)) for value in ray)

    def keys(self, *names):
        for name in names:
            self.browser.key(name)

    def distance(self):
        """The last distance and its deviation."""
        found = re.findall(r"([\d.]+) m ± ([\d.]+) m", self.browser.text("#measures"))
        return tuple(float(number) for number in found[-1])

    def said(self):
        return self.browser.text("#said")

    def station(self):
        return int(self.browser.value("document.querySelector('#station').value"))

    def choose(self, part, value):
        self.browser.value("(() => { const part = document.querySelector('%s'); part.value = '%s'; part.dispatchEvent(new Event('change')); })()"
                           % (part, value))
        self.arrive()

    def pixels(self, places):
        """Colours of a screenshot."""
        picture = base64.b64encode(self.browser.picture()).decode()
        return self.browser.value("""(async () => {
            const image = new Image();
            image.src = "data:image/png;base64,%s";
            await image.decode();
            const canvas = Object.assign(document.createElement("canvas"), { width: image.width, height: image.height });
            const pen = canvas.getContext("2d");
            pen.drawImage(image, 0, 0);
            return %s.map(([x, y]) => [...pen.getImageData(x, y, 1, 1).data.slice(0, 3)]);
        })()""" % (picture, json.dumps(places)))


def is_a_panorama(page):
    width, height = page.size()
    places = [[width // 2, height // 2], [width // 4, height // 2], [3 * width // 4, height // 3], [width // 2, height // 5]]
    for place, seen in zip(places, page.pixels(places)):
        wanted = colour(page.ray(place[0] + 0.5, place[1] + 0.5, 0))
        expect(max(abs(a - b) for a, b in zip(seen, wanted)) < 6, "at", place, "there is", seen, "in place of", wanted)


def measures_by_keyboard(page):
    page.keys("m", "Enter", *["ArrowLeft"] * 6, "Enter")
    truth = math.dist(wall(PLACES[0], (1, 0, 0)), wall(PLACES[0], (0, 1, 0)))
    metres, sigma = page.distance()
    expect(abs(metres - truth) < 0.015, metres, "m in place of", truth)
    expect(SCALE_SIGMA * truth < sigma < SCALE_SIGMA * truth + 0.1, "deviation", sigma)
    expect("All lengths are known to 25.0 %." in page.browser.text("#about"), page.browser.text("#about"))
    page.keys(*["ArrowRight"] * 6)


def measures_by_pointer(page):
    width, height = page.size()
    ends = []
    for x, y in ((0.3 * width, 0.4 * height), (0.6 * width, 0.95 * height - 90)):
        x, y = round(x), round(y)
        page.browser.click(x, y)
        ends.append(wall(PLACES[0], page.ray(x, y, 0)))
    metres, _ = page.distance()
    expect(abs(metres - math.dist(*ends)) < 0.03, metres, "m in place of", math.dist(*ends))
    page.keys("Backspace", "Escape")
    expect(len(page.browser.value("[...document.querySelectorAll('#measures li')].map((line) => line.innerText)")) == 1, "one was taken back")


def walks(page):
    page.keys("ArrowUp")
    page.arrive()
    expect(page.station() == 1, "walked to", page.station())
    expect("x 2.00 m, y 0.80 m" in page.browser.text("#place"), page.browser.text("#place"))
    page.keys("ArrowUp")
    expect("no photo to walk to" in page.said(), page.said())
    page.keys("m", "Enter", *["ArrowLeft"] * 12, "Enter")
    expect(abs(page.distance()[0] - ROOM[0]) < 0.02, "from wall to wall", page.distance())
    page.keys("Escape", *["ArrowRight"] * 12)


def says_where_nothing_is_measured(page):
    page.choose("#station", 3)
    page.keys("m")
    expect("no depth" in page.said(), page.said())
    page.keys("Enter")
    expect("no depth" in page.said(), page.said())
    page.keys("Escape")


def shows_names_as_text(page):
    expect(HOSTILE in page.browser.text("h1"), page.browser.text("h1"))
    expect(HOSTILE in page.browser.value("document.querySelector('#station').options[1].text"), "station")
    expect(page.browser.value("typeof hacked") == "undefined", "a name ran as code")
    expect(page.browser.value("document.images.length") == 0, "a name became a picture")


def shows_a_map_and_its_keys(page):
    page.choose("#map", 0)
    expect(page.browser.value("document.querySelectorAll('#plan rect').length") > 10, "cells of the map")
    expect("covered" in page.browser.text("#legend"), page.browser.text("#legend"))
    page.browser.key("?", shift=True)
    expect(page.browser.value("document.querySelector('#help').open"), "the list of keys is open")
    page.keys("Escape")
    expect(not page.browser.value("document.querySelector('#help').open"), "the list of keys is closed")


def shows_what_is_foretold(page):
    browser = page.browser
    browser.value("document.querySelector('#map').focus()")
    page.keys("ArrowDown")
    expect(browser.value("document.querySelector('#map').selectedOptions[0].text") == "Foretold error of views", "chosen by the keyboard")
    runs, fills = browser.value("[spherewalk.place.maps[1].floor.runs.length, [...document.querySelectorAll('#plan rect')]"
                                ".map((cell) => cell.getAttribute('fill'))]")
    expect(len(fills) == runs == 150, "cells", len(fills), runs)
    expect(fills == browser.value("spherewalk.place.maps[1].colours"), "the cells have the colours of the map")
    box = browser.value("(() => { const box = document.querySelector('#plan rect').getBBox(); return [box.x, box.y, box.width, box.height]; })()")
    expect(all(abs(a - b) < 1e-5 for a, b in zip(box, (0, -0.2, 0.2, 0.2))), "the first cell is", box)
    expect("2.00 px, the tolerance" in browser.text("#legend") and "nothing is known" in browser.text("#legend"), browser.text("#legend"))


def follows_fingers(page):
    browser = page.browser
    browser.resize(390, 844, touch=True)
    browser.wait("document.querySelector('#picture').clientWidth === 390")
    expect(browser.value("document.documentElement.scrollWidth") <= 390, "the page is wider than a phone")
    sight = "document.querySelector('#plan .sight').getAttribute('d')"
    before = browser.value(sight)
    browser.touch([(100, 200)], [(150, 200)], [(250, 200)])
    turned = browser.value(sight)
    expect(turned != before, "a finger turns")
    browser.touch([(150, 200), (200, 200)], [(100, 200), (250, 200)], [(50, 200), (300, 200)])
    expect(browser.value(sight) != turned, "two fingers zoom")
    page.browser.middle("#plan")
    x, y = browser.value("(() => { const mark = document.querySelectorAll('#plan circle')[2].getBoundingClientRect();"
                         " return [mark.x + mark.width / 2, mark.y + mark.height / 2]; })()")
    browser.touch([(x, y)])
    browser.wait("document.querySelector('#station').value === '2'")
    page.arrive()


def follows_the_scheme(page):
    colours = []
    for scheme in ("light", "dark"):
        page.browser.prefer(prefers_color_scheme=scheme)
        colours.append(page.browser.value("getComputedStyle(document.body).backgroundColor"))
    expect(colours[0] != colours[1], colours)


def names_a_missing_file(page):
    (page.folder / "photos/0001.js").unlink()
    page.browser.prefer(prefers_color_scheme="light", prefers_reduced_motion="reduce")
    page.browser.open(page.folder / "index.html")
    page.arrive()
    page.choose("#station", 0)
    expect("photos/0001.js" in page.browser.text("#trouble"), page.browser.text("#trouble"))
    page.choose("#station", 1)
    expect(page.browser.value("document.querySelector('#trouble').hidden"), "the other photos are shown")


def main():
    folder = pathlib.Path(sys.argv[1])
    if not browsers.program():
        return 77
    browser = browsers.Browser()
    try:
        page = Page(folder, browser)
        for test in (is_a_panorama, measures_by_keyboard, measures_by_pointer, walks, says_where_nothing_is_measured, shows_names_as_text,
                     shows_a_map_and_its_keys, shows_what_is_foretold, follows_fingers, follows_the_scheme):
            test(page)
        expect(not browser.complaints, browser.complaints)
        names_a_missing_file(page)
        foreign = [url for url in browser.requests if not url.startswith(("file:", "data:"))]
        expect(not foreign, foreign)
    finally:
        browser.close()
    return 0


if __name__ == "__main__":
    sys.exit(main())
