"""A headless Chromium, driven through a pipe by the DevTools protocol, and pictures as it makes them.
Nothing but the standard library."""
import base64
import fcntl
import json
import os
import shutil
import struct
import subprocess
import tempfile
import time
import zlib

NAMES = ["chromium", "chromium-browser", "google-chrome"]
OPTIONS = ["--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
           "--disable-background-networking", "--disable-component-update", "--disable-sync",
           "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--disable-dev-shm-usage",
           "--hide-scrollbars", "--force-device-scale-factor=1", "--remote-debugging-pipe"]


def find():
    """The path of a Chromium, or None."""
    return next((path for path in map(shutil.which, NAMES) if path), None)


class Picture:
    """Pixels of a PNG with 8 bits a channel, not interlaced: RGB or RGBA."""

    def __init__(self, png):
        self.png = png
        place, data = 8, b""
        while place < len(png):
            length, kind = struct.unpack(">I4s", png[place:place + 8])
            body = png[place + 8:place + 8 + length]
            if kind == b"IHDR":
                self.width, self.height, depth, colour = struct.unpack(">IIBB", body[:10])
                assert depth == 8 and colour in (2, 6), (depth, colour)
                self.channels = 3 if colour == 2 else 4
            elif kind == b"IDAT":
                data += body
            place += 12 + length
        self.rows = self.unfiltered(zlib.decompress(data))

    def unfiltered(self, raw):
        stride, n = self.width * self.channels, self.channels
        rows, last = [], bytearray(stride)
        for y in range(self.height):
            kind, row = raw[y * (stride + 1)], bytearray(raw[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
            if kind == 1:
                for i in range(n, stride):
                    row[i] = (row[i] + row[i - n]) & 255
            elif kind == 2:
                row = bytearray((a + b) & 255 for a, b in zip(row, last))
            elif kind == 3:
                for i in range(stride):
                    row[i] = (row[i] + ((row[i - n] if i >= n else 0) + last[i]) // 2) & 255
            elif kind == 4:
                for i in range(stride):
                    a, b, c = (row[i - n] if i >= n else 0), last[i], (last[i - n] if i >= n else 0)
                    p, q, r = abs(b - c), abs(a - c), abs(a + b - 2 * c)
                    row[i] = (row[i] + (a if p <= q and p <= r else b if q <= r else c)) & 255
            rows.append(row)
            last = row
        return rows

    def pixel(self, x, y):
        return tuple(self.rows[y][x * self.channels:x * self.channels + 3])

    def coarse(self, across=24, down=16):
        """Mean colours of the fields of a grid."""
        fields = []
        for j in range(down):
            for i in range(across):
                xs = range(i * self.width // across, (i + 1) * self.width // across, 3)
                ys = range(j * self.height // down, (j + 1) * self.height // down, 3)
                pixels = [self.pixel(x, y) for y in ys for x in xs]
                fields.append(tuple(sum(p[k] for p in pixels) / len(pixels) for k in range(3)))
        return fields

    def difference(self, other):
        """The share of fields whose mean colours differ visibly."""
        pairs = list(zip(self.coarse(), other.coarse()))
        return sum(max(abs(x - y) for x, y in zip(a, b)) > 6 for a, b in pairs) / len(pairs)

    def count(self, accepts):
        """How many pixels are so, of every second one in both directions."""
        return sum(accepts(*self.pixel(x, y)) for y in range(0, self.height, 2) for x in range(0, self.width, 2))


class Browser:
    """One window on one page. What the page says on its console is in `said`, requests in `asked`."""

    def __init__(self, path, size=(1400, 800)):
        self.folder = tempfile.mkdtemp(prefix="dupin-browser-")
        to_browser, from_browser = os.pipe(), os.pipe()

        def connect():
            # Out of the way first: 3 and 4 may be what is to be copied.
            reader, writer = (fcntl.fcntl(fd, fcntl.F_DUPFD, 20) for fd in (to_browser[0], from_browser[1]))
            os.dup2(reader, 3)
            os.dup2(writer, 4)

        self.log = open(f"{self.folder}/log", "wb")
        self.process = subprocess.Popen(
            [path, *OPTIONS, f"--user-data-dir={self.folder}/profile", f"--window-size={size[0]},{size[1]}", "about:blank"],
            stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=self.log,
            close_fds=False, preexec_fn=connect, env={**os.environ, "HOME": self.folder})
        os.close(to_browser[0])
        os.close(from_browser[1])
        self.out, self.into = os.fdopen(to_browser[1], "wb", 0), os.fdopen(from_browser[0], "rb", 0)
        self.buffer, self.number, self.said, self.asked, self.events = b"", 0, [], [], []
        self.session = None
        target = next(t for t in self.call("Target.getTargets")["targetInfos"] if t["type"] == "page")
        self.session = self.call("Target.attachToTarget", targetId=target["targetId"], flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log", "Network"):
            self.call(domain + ".enable")
        self.call("Emulation.setDeviceMetricsOverride", width=size[0], height=size[1], deviceScaleFactor=1, mobile=False)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        try:
            self.session = None
            self.call("Browser.close")
            self.process.wait(20)
        except (OSError, EOFError, subprocess.TimeoutExpired):
            self.process.kill()
            self.process.wait()
        for file in (self.log, self.out, self.into):
            file.close()
        shutil.rmtree(self.folder, ignore_errors=True)

    def message(self):
        while b"\0" not in self.buffer:
            piece = self.into.read(1 << 16)
            if not piece:
                raise EOFError("the browser ended: " + open(f"{self.folder}/log", errors="replace").read()[-2000:])
            self.buffer += piece
        text, self.buffer = self.buffer.split(b"\0", 1)
        return json.loads(text)

    def call(self, method, **parameters):
        self.number += 1
        request = {"id": self.number, "method": method, "params": parameters}
        if self.session:
            request["sessionId"] = self.session
        self.out.write(json.dumps(request).encode() + b"\0")
        while True:
            message = self.message()
            if message.get("id") == self.number:
                if "error" in message:
                    raise RuntimeError(f"{method}: {message['error']}")
                return message["result"]
            self.note(message)

    def note(self, message):
        method, about = message.get("method", ""), message.get("params", {})
        self.events.append(method)
        if method == "Runtime.consoleAPICalled" and about["type"] in ("error", "warning", "assert"):
            self.said.append(" ".join(str(a.get("value", a.get("description"))) for a in about["args"]))
        elif method == "Runtime.exceptionThrown":
            details = about["exceptionDetails"]
            self.said.append(details.get("exception", {}).get("description", details["text"]))
        elif method == "Log.entryAdded" and about["entry"]["level"] in ("error", "warning"):
            self.said.append(about["entry"]["text"])
        elif method == "Network.requestWillBeSent":
            self.asked.append(about["request"]["url"])

    def open(self, url):
        self.events.clear()
        self.call("Page.navigate", url=url)
        while "Page.loadEventFired" not in self.events:
            self.note(self.message())

    def evaluate(self, expression):
        result = self.call("Runtime.evaluate", expression=expression, returnByValue=True, awaitPromise=True)
        if "exceptionDetails" in result:
            raise RuntimeError(result["exceptionDetails"].get("exception", {}).get("description", str(result)))
        return result["result"].get("value")

    def wait_for(self, expression, seconds=30):
        end = time.monotonic() + seconds
        while not self.evaluate(expression):
            if time.monotonic() > end:
                raise TimeoutError(expression)
            time.sleep(0.05)

    def click(self, x, y, count=1):
        self.call("Input.dispatchMouseEvent", type="mouseMoved", x=x, y=y)
        for kind in ("mousePressed", "mouseReleased"):
            self.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left", clickCount=count)

    def move(self, x, y):
        self.call("Input.dispatchMouseEvent", type="mouseMoved", x=x, y=y)

    def drag(self, start, end, modifiers=0):
        def send(kind, place, **more):
            self.call("Input.dispatchMouseEvent", type=kind, x=place[0], y=place[1], button="left", modifiers=modifiers, **more)
        send("mousePressed", start, clickCount=1)
        for share in (0.3, 0.7, 1):
            send("mouseMoved", [a + share * (b - a) for a, b in zip(start, end)], buttons=1)
        send("mouseReleased", end, clickCount=1)

    def picture(self, clip=None):
        area = {} if clip is None else {"clip": {**dict(zip(("x", "y", "width", "height"), clip)), "scale": 1}}
        return Picture(base64.b64decode(self.call("Page.captureScreenshot", format="png", **area)["data"]))
