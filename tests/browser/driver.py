"""Drives a headless Chromium over --remote-debugging-pipe: opens pages, runs JavaScript, sends input, takes pictures.

Standard library only. Nothing sleeps: whoever waits, waits for a message of the browser.
"""
import base64
import contextlib
import json
import os
import select
import shutil
import signal
import subprocess
import tempfile
import time

# WebGL 2 without a graphics card.
FLAGS = [
    "--headless=new", "--remote-debugging-pipe", "--no-first-run", "--no-default-browser-check", "--disable-extensions",
    "--disable-background-networking", "--disable-component-update", "--disable-sync", "--mute-audio", "--hide-scrollbars",
    "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--disable-dev-shm-usage",
    # The browser's own pages, which load beside the first opened page.
    "--disable-features=WebUIOmniboxPopup,WebUIOmniboxAimPopup",
]


PROFILE = "fivecheck-browser-"
# Before all scripts of a page: the promise of the moment at which it is ready.
LOADED = "await new Promise((done) => document.readyState === 'complete' ? done() : addEventListener('load', done))"
READY = """window.wasReady = new Promise((done) => document.addEventListener(%s, () => done(performance.now()), {once: true}));"""


class BrowserError(Exception):
    pass


class NotHere(Exception):
    """This browser cannot be controlled in this way; the test is skipped with this reason."""


def find_browser():
    """The command of Chromium, or None."""
    for name in [os.environ.get("CHROMIUM", ""), "chromium", "chromium-browser", "google-chrome"]:
        if name and shutil.which(name):
            return shutil.which(name)
    return None


class Browser:
    """One Chromium with its own profile; a context manager that always ends it."""

    def __init__(self, flags=(), timeout=120):
        self.timeout = timeout
        self.flags = list(flags)

    def __enter__(self):
        self.profile = tempfile.mkdtemp(prefix=PROFILE)
        to_read, self.write_end = os.pipe()
        self.read_end, to_write = os.pipe()
        sandbox = ["--no-sandbox"] if os.geteuid() == 0 else []

        def wire():
            # The browser reads commands from 3 and writes answers to 4.
            read, write = os.dup(to_read), os.dup(to_write)
            os.dup2(read, 3)
            os.dup2(write, 4)
            os.nice(10)

        self.process = subprocess.Popen(
            [find_browser(), *FLAGS, *sandbox, *self.flags, f"--user-data-dir={self.profile}", "about:blank"],
            preexec_fn=wire, close_fds=False, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL, start_new_session=True)
        os.close(to_read)
        os.close(to_write)
        self.buffer = b""
        self.last_id = 0
        self.events = []
        return self

    def __exit__(self, *_):
        with contextlib.suppress(ProcessLookupError):
            os.killpg(self.process.pid, signal.SIGKILL)
        self.process.wait()
        os.close(self.read_end)
        os.close(self.write_end)
        shutil.rmtree(self.profile, ignore_errors=True)

    def receive(self):
        """The next message."""
        deadline = time.monotonic() + self.timeout
        while b"\0" not in self.buffer:
            ready, _, _ = select.select([self.read_end], [], [], max(0, deadline - time.monotonic()))
            if not ready:
                raise BrowserError("the browser says nothing")
            data = os.read(self.read_end, 1 << 20)
            if not data:
                raise BrowserError("the browser has ended")
            self.buffer += data
        message, self.buffer = self.buffer.split(b"\0", 1)
        return json.loads(message)

    def call(self, method, session=None, **params):
        """The result of a command; earlier events are kept."""
        self.last_id += 1
        wanted = self.last_id
        message = {"id": wanted, "method": method, "params": params}
        if session:
            message["sessionId"] = session
        data = json.dumps(message).encode() + b"\0"
        while data:
            data = data[os.write(self.write_end, data):]
        while True:
            answer = self.receive()
            if answer.get("id") == wanted:
                if "error" in answer:
                    raise BrowserError(f"{method}: {answer['error']['message']}")
                return answer["result"]
            if "method" in answer:
                self.events.append(answer)

    def processor_time(self):
        """Processor time in seconds of all processes of the browser, including software graphics. It depends less on other programs than the clock does."""
        return sum(process["cpuTime"] for process in self.call("SystemInfo.getProcessInfo")["processInfo"])

    def page(self, **options):
        return Page(self, **options)


class Page:
    """One tab. Exceptions, console warnings and requests are collected in `exceptions`, `console` and `requests`."""

    def __init__(self, browser, width=1280, height=800, scale=1, mobile=False, dark=False):
        self.browser = browser
        target = browser.call("Target.createTarget", url="about:blank")["targetId"]
        self.target = target
        self.session = browser.call("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        for domain in ["Page", "Runtime", "Network", "Log"]:
            self.call(f"{domain}.enable")
        self.size(width, height, scale, mobile)
        self.call("Emulation.setEmulatedMedia", features=[
            {"name": "prefers-color-scheme", "value": "dark" if dark else "light"},
            {"name": "prefers-reduced-motion", "value": "reduce"}])
        if mobile:
            self.call("Emulation.setTouchEmulationEnabled", enabled=True)

    def size(self, width, height, scale=1, mobile=False):
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=scale, mobile=mobile)

    def call(self, method, **params):
        return self.browser.call(method, self.session, **params)

    def events(self, method):
        return [e["params"] for e in self.browser.events if e["method"] == method and e.get("sessionId") == self.session]

    def wait(self, method):
        """Waits for an event; earlier events count."""
        while not self.events(method):
            message = self.browser.receive()
            if "method" in message:
                self.browser.events.append(message)

    def before(self, script):
        """Runs before the scripts of each page that is opened from now on."""
        self.call("Page.addScriptToEvaluateOnNewDocument", source=script)

    def navigate(self, url):
        """Opens an address and waits until it and everything that it needs is loaded."""
        self.call("Page.navigate", url=url)
        self.run(LOADED)

    def reload(self):
        self.call("Page.reload")
        self.run(LOADED)

    def open_without_scripts(self, path):
        self.call("Emulation.setScriptExecutionDisabled", value=True)
        self.call("Page.navigate", url="file://" + os.path.abspath(path))
        self.wait("Page.loadEventFired")
        self.call("Emulation.setScriptExecutionDisabled", value=False)

    def on_paper(self):
        """Shows the page as it would be printed."""
        self.call("Emulation.setEmulatedMedia", media="print")

    def offline(self):
        self.call("Network.emulateNetworkConditions", offline=True, latency=0, downloadThroughput=-1, uploadThroughput=-1)

    def choose(self, selector, paths):
        """Chooses files by a button of the page."""
        root = self.call("DOM.getDocument")["root"]["nodeId"]
        node = self.call("DOM.querySelector", nodeId=root, selector=selector)["nodeId"]
        self.call("DOM.setFileInputFiles", nodeId=node, files=paths)

    def drop(self, x, y, paths):
        """Drops files or folders as a file manager does."""
        data = {"items": [], "files": paths, "dragOperationsMask": 1}
        for kind in ("dragEnter", "dragOver", "drop"):
            self.call("Input.dispatchDragEvent", type=kind, x=x, y=y, data=data)

    def open(self, path, ready="fivecheck-ready", scripts=""):
        """Opens a file and waits for the event `ready` of its document; `scripts` run before those of the page."""
        self.before(scripts + ";" + READY % json.dumps(ready))
        self.call("Page.navigate", url="file://" + os.path.abspath(path))
        return self.run("await window.wasReady")

    def run(self, script):
        """The value of a JavaScript expression; it may wait with await."""
        answer = self.call("Runtime.evaluate", expression=f"(async () => ({script}))()", awaitPromise=True, returnByValue=True)
        if "exceptionDetails" in answer:
            details = answer["exceptionDetails"]
            raise BrowserError(details.get("exception", {}).get("description", details["text"]))
        return answer["result"].get("value")

    def frames(self):
        """Waits until two frames have been drawn."""
        self.run("await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))")

    def exceptions(self):
        self.frames()
        thrown = [e["exceptionDetails"].get("exception", {}).get("description", e["exceptionDetails"]["text"])
                  for e in self.events("Runtime.exceptionThrown")]
        said = [" ".join(str(a.get("value", a.get("description"))) for a in e["args"])
                for e in self.events("Runtime.consoleAPICalled") if e["type"] in ("error", "warning", "assert")]
        logged = [e["entry"]["text"] for e in self.events("Log.entryAdded") if e["entry"]["level"] in ("error", "warning")]
        return thrown + said + logged

    def requests(self):
        """The requested addresses, except for the page itself."""
        asked = [e["request"]["url"] for e in self.events("Network.requestWillBeSent") if e.get("type") != "Document"]
        return [url for url in asked if not url.startswith(("data:", "blob:"))]

    def click(self, x, y, clicks=1):
        for kind in ["mousePressed", "mouseReleased"]:
            self.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left", buttons=1, clickCount=clicks)
        self.frames()

    def drag(self, x, y, dx, dy):
        self.call("Input.dispatchMouseEvent", type="mousePressed", x=x, y=y, button="left", buttons=1, clickCount=1)
        for step in range(1, 5):
            self.call("Input.dispatchMouseEvent", type="mouseMoved", x=x + dx * step / 4, y=y + dy * step / 4, button="left", buttons=1)
        self.call("Input.dispatchMouseEvent", type="mouseReleased", x=x + dx, y=y + dy, button="left", buttons=0, clickCount=1)
        self.frames()

    def wheel(self, x, y, delta):
        self.call("Input.dispatchMouseEvent", type="mouseWheel", x=x, y=y, deltaX=0, deltaY=delta)
        self.frames()

    def touch(self, *steps):
        """Each step is a list of points (x, y) of the fingers; after the last step the fingers are lifted."""
        for i, points in enumerate(steps):
            touches = [{"x": x, "y": y, "id": k} for k, (x, y) in enumerate(points)]
            self.call("Input.dispatchTouchEvent", type="touchMove" if i else "touchStart", touchPoints=touches)
        self.call("Input.dispatchTouchEvent", type="touchEnd", touchPoints=[])
        self.frames()

    def press(self, key, shift=False):
        """A key by its name ("ArrowLeft", "Tab") or its letter."""
        known = {"Tab": 9, "Enter": 13, "Escape": 27, " ": 32, "End": 35, "Home": 36, "ArrowLeft": 37, "ArrowUp": 38,
                 "ArrowRight": 39, "ArrowDown": 40}
        text = key if len(key) == 1 else "\r" if key == "Enter" else ""
        code = known.get(key, ord(key.upper()) if len(key) == 1 and key.isalnum() else 0)
        common = {"key": key, "windowsVirtualKeyCode": code, "modifiers": 8 if shift else 0}
        self.call("Input.dispatchKeyEvent", type="keyDown", text=text, **common)
        self.call("Input.dispatchKeyEvent", type="keyUp", **common)
        self.frames()

    def box(self, selector):
        """x, y, width, height of the first element."""
        return self.run(f"(({{x, y, width, height}}) => [x, y, width, height])(document.querySelector({json.dumps(selector)}).getBoundingClientRect())")

    def picture(self, path):
        """A PNG of the visible part of the page."""
        data = base64.b64decode(self.call("Page.captureScreenshot", format="png")["data"])
        with open(path, "wb") as file:
            file.write(data)
        return data

    def close(self):
        self.browser.call("Target.closeTarget", targetId=self.target)
