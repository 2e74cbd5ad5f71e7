"""Drives Firefox by WebDriver BiDi, with the words of driver.py: the same tests run in both browsers. It draws on a screen
that nobody sees (Xvfb), because a headless Firefox has no WebGL.

Standard library only. Nothing sleeps: whoever waits, waits for a message of the browser.
"""
import base64
import contextlib
import json
import os
import shutil
import signal
import subprocess
import tempfile

from driver import PROFILE, READY, BrowserError, NotHere
from websocket import WebSocket, WebSocketError

# No question to the network, WebGL 2 without a graphics card.
PREFERENCES = {
    "app.update.enabled": False, "browser.shell.checkDefaultBrowser": False, "browser.startup.homepage_override.mstone": "ignore",
    "datareporting.policy.dataSubmissionEnabled": False, "toolkit.telemetry.enabled": False, "network.captive-portal-service.enabled": False,
    "network.connectivity-service.enabled": False, "browser.safebrowsing.update.enabled": False, "extensions.update.enabled": False,
    "browser.region.network.url": "", "browser.topsites.contile.enabled": False, "services.settings.server": "data:,",
    "webgl.force-enabled": True, "webgl.forbid-software": False, "ui.prefersReducedMotion": 1, "widget.gtk.overlay-scrollbars.enabled": True,
    "dom.ipc.processCount": 1, "security.fileuri.strict_origin_policy": True,
}
# Names of keys in WebDriver; letters are their own.
KEYS = {"Tab": "\ue004", "Enter": "\ue007", "Escape": "\ue00c", "End": "\ue010", "Home": "\ue011", "ArrowLeft": "\ue012", "ArrowUp": "\ue013",
        "ArrowRight": "\ue014", "ArrowDown": "\ue015"}
SHIFT = "\ue008"


def find_firefox():
    """The command of Firefox, or None."""
    for name in [os.environ.get("FIREFOX", ""), "firefox-esr", "firefox"]:
        if name and shutil.which(name):
            return shutil.which(name)
    return None


class Firefox:
    """One Firefox with a profile of its own; a context manager, which always ends it."""

    def __init__(self, timeout=120):
        self.timeout = timeout

    def __enter__(self):
        self.profile = tempfile.mkdtemp(prefix=PROFILE)
        with open(os.path.join(self.profile, "user.js"), "w", encoding="utf-8") as file:
            file.writelines(f"user_pref({json.dumps(name)}, {json.dumps(value)});\n" for name, value in PREFERENCES.items())
        to_read, to_write = os.pipe()
        self.screen = subprocess.Popen(["Xvfb", "-displayfd", str(to_write), "-screen", "0", "1400x1000x24", "-nolisten", "tcp"], pass_fds=[to_write],
                                       stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(to_write)
        with os.fdopen(to_read) as told:
            display = ":" + told.readline().strip()
        # With system access a script can make a tab report dark mode or print to its page; there is no other way.
        self.process = subprocess.Popen(
            [find_firefox(), "--no-remote", "--profile", self.profile, "--remote-debugging-port=0", "--remote-allow-system-access",
             "about:blank"], env={**os.environ, "HOME": self.profile, "DISPLAY": display}, preexec_fn=lambda: os.nice(10), stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, start_new_session=True)
        self.last_id = 0
        self.events = []
        try:
            for line in self.process.stderr:
                if b"listening on ws://" in line:
                    host, port = line.decode().strip().split("ws://")[1].split(":")
                    break
            else:
                raise BrowserError("Firefox does not listen")
            self.socket = WebSocket(host, int(port), "/session", self.timeout)
            self.call("session.new", capabilities={"alwaysMatch": {"unhandledPromptBehavior": {"default": "accept"}}})
            self.call("session.subscribe", events=["log.entryAdded", "network.beforeRequestSent", "browsingContext.load"])
            chrome = self.call("browsingContext.getTree", **{"moz:scope": "chrome"})["contexts"]
            self.window = chrome[0]["context"]
        except Exception:
            self.__exit__()
            raise
        return self

    def __exit__(self, *_):
        with contextlib.suppress(ProcessLookupError):
            os.killpg(self.process.pid, signal.SIGKILL)
        self.process.wait()
        self.process.stderr.close()
        self.screen.terminate()
        self.screen.wait()
        if hasattr(self, "socket"):
            self.socket.close()
        shutil.rmtree(self.profile, ignore_errors=True)

    def receive(self):
        try:
            return json.loads(self.socket.receive())
        except (TimeoutError, WebSocketError) as error:
            raise BrowserError(f"the browser says nothing: {error}") from error

    def call(self, method, **params):
        """The result of a command; earlier events are kept."""
        self.last_id += 1
        self.socket.send(json.dumps({"id": self.last_id, "method": method, "params": params}))
        while True:
            answer = self.receive()
            if answer.get("id") == self.last_id:
                if answer["type"] == "error":
                    raise BrowserError(f"{method}: {answer['message']}")
                return answer["result"]
            if answer.get("type") == "event":
                self.events.append(answer)

    def evaluate(self, context, script):
        """The value of a JavaScript expression; it may wait with await."""
        answer = self.call("script.evaluate", expression=f"(async () => JSON.stringify(await (async () => ({script}))() ?? null))()",
                           target={"context": context}, awaitPromise=True)
        if answer["type"] == "exception":
            raise BrowserError(answer["exceptionDetails"]["text"])
        return json.loads(answer["result"]["value"])

    def processor_time(self):
        """Processor time in seconds of all processes of the browser, including software graphics. It depends less on other programs than the clock does."""
        ticks = 0
        for number in filter(str.isdigit, os.listdir("/proc")):
            with contextlib.suppress(OSError), open(f"/proc/{number}/stat", encoding="latin-1") as file:
                fields = file.read().rpartition(")")[2].split()
                if int(fields[2]) == self.process.pid:
                    ticks += int(fields[11]) + int(fields[12])
        return ticks / os.sysconf("SC_CLK_TCK")

    def page(self, **options):
        return Page(self, **options)


class Page:
    """One tab. Exceptions, console warnings and requests are collected in `exceptions`, `console` and `requests`."""

    def __init__(self, browser, width=1280, height=800, scale=1, mobile=False, dark=False):
        self.browser = browser
        self.context = browser.call("browsingContext.create", type="tab")["context"]
        self.size(width, height, scale, mobile)
        self.look(prefersColorSchemeOverride="dark" if dark else "light")

    def size(self, width, height, scale=1, mobile=False):
        """A phone differs only in its size: Firefox has no command for touch."""
        del mobile
        self.call("browsingContext.setViewport", viewport={"width": width, "height": height}, devicePixelRatio=scale)

    def look(self, **properties):
        """Sets properties of the tab that pages see as media features."""
        self.browser.evaluate(self.browser.window, f"""Object.assign(ChromeUtils.importESModule(
            'chrome://remote/content/shared/NavigableManager.sys.mjs').NavigableManager.getBrowsingContextById({json.dumps(self.context)}), {json.dumps(properties)}) && 0""")

    def call(self, method, **params):
        return self.browser.call(method, context=self.context, **params)

    def frames_within(self):
        """This tab and all frames in it."""
        def all_of(tree):
            return [tree["context"], *(context for child in tree["children"] for context in all_of(child))]
        return [context for tree in self.browser.call("browsingContext.getTree", root=self.context)["contexts"] for context in all_of(tree)]

    def before(self, script):
        self.browser.call("script.addPreloadScript", functionDeclaration=f"() => {{{script}}}", contexts=[self.context])

    def navigate(self, url):
        self.call("browsingContext.navigate", url=url, wait="complete")

    def reload(self):
        self.call("browsingContext.reload", wait="complete")

    def open(self, path, ready="fivecheck-ready", scripts=""):
        """Opens a file and waits for the event `ready` of its document; `scripts` run before those of the page."""
        self.before(scripts + ";" + READY % json.dumps(ready))
        self.navigate("file://" + os.path.abspath(path))
        return self.run("await window.wasReady")

    def open_without_scripts(self, path):
        self.call("browsingContext.navigate", url="about:blank", wait="complete")
        self.look(allowJavascript=False)
        self.navigate("file://" + os.path.abspath(path))
        self.look(allowJavascript=True)

    def on_paper(self):
        self.look(mediumOverride="print")

    def offline(self):
        """Nothing to do: the server of the test has ended, and a reloaded page requests what it has not stored."""

    def choose(self, selector, paths):
        """Chooses files by a button of the page."""
        node = self.call_node(selector)
        self.call("input.setFiles", element=node, files=[os.path.abspath(path) for path in paths])

    def call_node(self, selector):
        answer = self.browser.call("browsingContext.locateNodes", context=self.context, locator={"type": "css", "value": selector}, maxNodeCount=1)
        return {"sharedId": answer["nodes"][0]["sharedId"]}

    def drop(self, x, y, paths):
        raise NotHere("Firefox has no word for files that are dropped")

    def run(self, script):
        """The value of a JavaScript expression; it may wait with await."""
        return self.browser.evaluate(self.context, script)

    def frames(self):
        """Waits until two frames have been drawn."""
        self.run("await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => done())))")

    def exceptions(self):
        self.frames()
        within = self.frames_within()
        return [e["params"]["text"] for e in self.browser.events if e["method"] == "log.entryAdded"
                and e["params"]["level"] in ("error", "warn") and e["params"]["source"].get("context") in within]

    def requests(self):
        """The requested addresses, except for the page itself."""
        within = self.frames_within()
        asked = [e["params"]["request"] for e in self.browser.events if e["method"] == "network.beforeRequestSent"
                 and e["params"]["context"] in within]
        return [request["url"] for request in asked
                if request.get("destination") not in ("document", "iframe") and not request["url"].startswith(("data:", "blob:"))]

    def act(self, kind, name, actions, **more):
        return {"type": kind, "id": name, "actions": actions, **more}

    def perform(self, *sources):
        self.call("input.performActions", actions=list(sources))
        self.call("input.releaseActions")
        self.frames()

    def mouse(self, *actions):
        self.perform(self.act("pointer", "mouse", list(actions), parameters={"pointerType": "mouse"}))

    def click(self, x, y, clicks=1):
        self.mouse(move(x, y), *[DOWN, UP] * clicks)

    def drag(self, x, y, dx, dy):
        self.mouse(move(x, y), DOWN, *(move(x + dx * step / 4, y + dy * step / 4) for step in range(1, 5)), UP)

    def wheel(self, x, y, delta):
        self.perform(self.act("wheel", "wheel", [{"type": "scroll", "x": round(x), "y": round(y), "deltaX": 0, "deltaY": round(delta)}]))

    def touch(self, *steps):
        """Each step is a list of points (x, y) of the fingers; after the last step the fingers are lifted."""
        self.perform(*(self.act("pointer", f"finger-{k}", [act for i, points in enumerate(steps)
                                                           for act in ([move(*points[k]), PAUSE if i else DOWN])] + [UP],
                                parameters={"pointerType": "touch"}) for k in range(len(steps[0]))))

    def press(self, key, shift=False):
        """A key by its name ("ArrowLeft", "Tab") or its letter."""
        value = KEYS.get(key, key)
        keys = [SHIFT, value] if shift else [value]
        self.perform(self.act("key", "keys", [{"type": "keyDown", "value": k} for k in keys] + [{"type": "keyUp", "value": k} for k in keys[::-1]]))

    def box(self, selector):
        """x, y, width, height of the first element."""
        return self.run(f"(({{x, y, width, height}}) => [x, y, width, height])(document.querySelector({json.dumps(selector)}).getBoundingClientRect())")

    def picture(self, path):
        """A PNG of the visible part of the page."""
        data = base64.b64decode(self.call("browsingContext.captureScreenshot")["data"])
        with open(path, "wb") as file:
            file.write(data)
        return data

    def close(self):
        self.call("browsingContext.close")


DOWN, UP, PAUSE = {"type": "pointerDown", "button": 0}, {"type": "pointerUp", "button": 0}, {"type": "pause"}


def move(x, y):
    return {"type": "pointerMove", "x": x, "y": y}
