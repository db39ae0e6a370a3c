# SPDX-License-Identifier: GPL-3.0-or-later
"""Chromium without a window, driven through pipes by its DevTools protocol: real keys, pointers and touches."""
import base64
import itertools
import json
import os
import shutil
import subprocess
import tempfile
import time

FLAGS = ("--headless", "--no-sandbox", "--no-first-run", "--disable-extensions", "--disable-background-networking",
         "--host-resolver-rules=MAP * ~NOTFOUND", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
         "--remote-debugging-pipe")
KEYS = {"Enter": ("Enter", 13, "\r"), "Escape": ("Escape", 27, ""), "Backspace": ("Backspace", 8, ""), "ArrowLeft": ("ArrowLeft", 37, ""),
        "ArrowUp": ("ArrowUp", 38, ""), "ArrowRight": ("ArrowRight", 39, ""), "ArrowDown": ("ArrowDown", 40, ""),
        "PageUp": ("PageUp", 33, ""), "PageDown": ("PageDown", 34, ""), "Home": ("Home", 36, "")}


def program():
    """Debian's Chromium, or None."""
    return shutil.which("chromium") or shutil.which("chromium-browser")


def reached(host):
    """The flag that lets the browser reach one host besides files."""
    return ["--host-resolver-rules=MAP * ~NOTFOUND, EXCLUDE " + host] if host else []


class Browser:
    def __init__(self, width=1000, height=600, reaches=None):  # a larger picture is slow without a graphics card
        self.profile = tempfile.TemporaryDirectory(prefix="spherewalk-browser-", ignore_cleanup_errors=True)
        to_browser, self.writes = os.pipe()
        self.reads, from_browser = os.pipe()

        def take_pipes():  # the browser reads 3 and writes 4
            os.dup2(to_browser, 13)
            os.dup2(from_browser, 14)
            os.dup2(13, 3)
            os.dup2(14, 4)

        self.process = subprocess.Popen([program(), *FLAGS, *reached(reaches), "--user-data-dir=" + self.profile.name, "about:blank"], preexec_fn=take_pipes,
                                        close_fds=False, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(to_browser)
        os.close(from_browser)
        self.numbers = itertools.count(1)
        self.pending = b""
        self.complaints = []  # what the console and the network say
        self.requests = []
        self.session = None
        target = next(t for t in self.ask("Target.getTargets")["targetInfos"] if t["type"] == "page")
        self.session = self.ask("Target.attachToTarget", targetId=target["targetId"], flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log", "Network"):
            self.ask(domain + ".enable")
        self.resize(width, height)

    def close(self):
        self.session = None
        self.ask("Browser.close")
        self.process.wait(30)
        os.close(self.reads)
        os.close(self.writes)
        self.profile.cleanup()

    def message(self):
        while b"\0" not in self.pending:
            more = os.read(self.reads, 1 << 20)
            if not more:
                raise EOFError("the browser has ended")
            self.pending += more
        first, self.pending = self.pending.split(b"\0", 1)
        return json.loads(first)

    def ask(self, method, **values):
        number = next(self.numbers)
        question = {"id": number, "method": method, "params": values}
        if self.session:
            question["sessionId"] = self.session
        os.write(self.writes, json.dumps(question).encode() + b"\0")
        while True:
            answer = self.message()
            if answer.get("id") == number:
                if "error" in answer:
                    raise RuntimeError("%s: %s" % (method, answer["error"]))
                return answer["result"]
            self.note(answer)

    def note(self, event):
        method, told = event.get("method"), event.get("params", {})
        if method == "Runtime.exceptionThrown":
            self.complaints.append(told["exceptionDetails"].get("exception", {}).get("description", str(told)))
        elif method == "Log.entryAdded" and told["entry"]["level"] == "error":
            self.complaints.append(told["entry"]["text"] + " " + told["entry"].get("url", ""))
        elif method == "Network.requestWillBeSent":
            self.requests.append(told["request"]["url"][:200])

    def open(self, file):
        self.ask("Page.navigate", url=file.as_uri())
        self.wait("document.readyState === 'complete'")

    def value(self, expression):
        """What JavaScript makes of the expression. Promises are awaited."""
        answer = self.ask("Runtime.evaluate", expression=expression, returnByValue=True, awaitPromise=True)
        if "exceptionDetails" in answer:
            raise RuntimeError(answer["exceptionDetails"].get("exception", {}).get("description", str(answer)))
        return answer["result"].get("value")

    def wait(self, condition, seconds=60):
        end = time.monotonic() + seconds
        while not self.value(condition):
            if time.monotonic() > end:
                raise TimeoutError(condition + " did not come true; " + "; ".join(self.complaints))
            time.sleep(0.05)

    def text(self, selector):
        return self.value("document.querySelector(%s).innerText" % json.dumps(selector))

    def resize(self, width, height, scale=1, touch=False):
        self.ask("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=scale, mobile=touch)
        self.ask("Emulation.setTouchEmulationEnabled", enabled=touch)

    def prefer(self, **features):
        self.ask("Emulation.setEmulatedMedia", features=[{"name": name.replace("_", "-"), "value": value} for name, value in features.items()])

    def key(self, name, shift=False):
        key, code, letters = KEYS[name] if name in KEYS else (name, ord(name.upper()), name)
        about = {"key": key, "windowsVirtualKeyCode": code, "modifiers": 8 if shift else 0}
        self.ask("Input.dispatchKeyEvent", type="keyDown", text=letters, **about)
        self.ask("Input.dispatchKeyEvent", type="keyUp", **about)

    def middle(self, selector):
        return self.value("(() => { const part = document.querySelector(%s); part.scrollIntoView({ block: 'nearest' });"
                          " const box = part.getBoundingClientRect(); return [box.x + box.width / 2, box.y + box.height / 2]; })()"
                          % json.dumps(selector))

    def click(self, x, y):
        for kind in ("mousePressed", "mouseReleased"):
            self.ask("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left", clickCount=1)

    def touch(self, *frames):
        """Fingers that go down, move from frame to frame, and leave. A frame is a list of places."""
        for number, frame in enumerate(frames):
            points = [{"x": x, "y": y, "id": finger} for finger, (x, y) in enumerate(frame)]
            self.ask("Input.dispatchTouchEvent", type="touchMove" if number else "touchStart", touchPoints=points)
        self.ask("Input.dispatchTouchEvent", type="touchEnd", touchPoints=[])

    def picture(self, file=None):
        """A PNG of the page."""
        bytes_ = base64.b64decode(self.ask("Page.captureScreenshot", format="png")["data"])
        if file:
            with open(file, "wb") as out:
                out.write(bytes_)
        return bytes_
