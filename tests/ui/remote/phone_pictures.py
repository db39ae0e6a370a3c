#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Pairs a phone's browser with the remote and makes pictures of what it shows: phone_pictures.py URL CODE DIR SUFFIX light|dark

The exit status is 77 where there is no browser.
"""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "core/jobs/web"))
import browser as browsers

SCREEN = (390, 844)  # of a phone of 6 inches, at three pixels a point
SMALL = (320, 568)   # of the smallest one
DENSITY = 3


def main(url, code, folder, suffix, scheme):
    if browsers.program() is None:
        return 77
    browser = browsers.Browser(*SCREEN, reaches="127.0.0.1")
    try:
        def shoot(name):
            browser.picture("%s/phone-%s%s.png" % (folder, name, suffix))

        def show(size):
            browser.resize(*size, scale=DENSITY, touch=True)

        browser.prefer(prefers_color_scheme=scheme)
        show(SCREEN)
        browser.ask("Page.navigate", url=url)
        browser.wait("document.readyState === 'complete' && !document.querySelector('#pairing').hidden")
        shoot("pairing")
        for digit in code:
            browser.key(digit)
        browser.touch([browser.middle("#pair")])
        browser.wait("!document.querySelector('#remote').hidden")
        browser.wait("document.querySelector('#picture').hidden || document.querySelector('#picture').complete")
        shoot("remote")
        show(SMALL)
        shoot("remote-small")
        complaints = [one for one in browser.complaints if "403" not in one]  # what a device gets before it is paired
        for complaint in complaints:
            print(complaint, file=sys.stderr)
        return 1 if complaints else 0
    finally:
        browser.close()


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:6]))
