"""A report page in a browser: made by the tool, looked at, and worked with as a person does."""
import json
import pathlib
import subprocess
import tempfile
import unittest

import browser

STAGE = (250, 50, 730, 740)  # x, y, width, height of the picture below its tools
TREE_WIDTH = 250


class PageTest(unittest.TestCase):
    """A browser for all tests of a class, and a folder of pages. No page may complain, or ask for anything."""
    tool = None  # the tool that makes the pages
    pictures = None  # a folder for pictures to look at, or None

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        cls.browser = browser.Browser(browser.find())
        cls.addClassCleanup(cls.browser.__exit__)

    @classmethod
    def run_tool(cls, *arguments, code=0):
        ran = subprocess.run([cls.tool, *arguments], cwd=cls.folder, capture_output=True, text=True, check=False)
        assert ran.returncode == code, (arguments, ran.returncode, ran.stderr)
        return ran.stdout

    @classmethod
    def write(cls, name, document):
        text = document if isinstance(document, str) else json.dumps(document)
        (cls.folder / name).write_text(text, encoding="utf-8")
        return name

    def setUp(self):
        self.browser.said.clear()
        self.browser.asked.clear()

    def tearDown(self):
        complaints = [text for text in self.browser.said if "GL Driver Message" not in text]
        self.assertEqual(complaints, [])
        self.assertEqual([url for url in self.browser.asked if not url.startswith(("file:", "data:"))], [])

    def resize(self, width=1400, height=800):
        self.browser.call("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1,
                          mobile=False)

    def open(self, page):
        self.browser.open((self.folder / page).as_uri())
        self.browser.wait_for("window.dupinPage !== undefined && dupinPage.view && !dupinPage.view.requested", 120)

    def rest(self):
        self.browser.wait_for("!dupinPage.view.flight && !dupinPage.view.requested")

    def shot(self, name):
        """The picture at rest, without what lies over it."""
        self.rest()
        self.browser.move(STAGE[0] + 5, STAGE[1] + STAGE[3] - 5)
        self.browser.evaluate("new Promise(done => setTimeout(() => requestAnimationFrame(() =>"
                              "requestAnimationFrame(done)), 400))")
        picture = self.browser.picture(STAGE)
        if self.pictures:
            (pathlib.Path(self.pictures) / f"{name}.png").write_bytes(self.browser.picture().png)
        return picture

    def middle_of(self, selector):
        return self.browser.evaluate(
            f"(() => {{ const e = document.querySelector({json.dumps(selector)}); e.scrollIntoView({{block: 'nearest'}});"
            "const b = e.getBoundingClientRect(); return [b.x + b.width / 2, b.y + b.height / 2]; })()")

    def click(self, selector, count=1):
        self.browser.click(*self.middle_of(selector), count)

    def key(self, key):
        self.browser.call("Input.dispatchKeyEvent", type="keyDown", key=key)
        self.browser.call("Input.dispatchKeyEvent", type="keyUp", key=key)

    def open_tab(self, title):
        index = self.browser.evaluate(
            f"[...document.querySelectorAll('#tabs button')].findIndex(b => b.textContent.startsWith({json.dumps(title)}))")
        self.assertGreaterEqual(index, 0, title)
        self.click(f"#tabs button:nth-child({index + 1})")

    def texts(self, selector):
        return self.browser.evaluate(f"[...document.querySelectorAll({json.dumps(selector)})].map(e => e.textContent)")

    def text(self, selector):
        self.rest()
        return self.browser.evaluate(f"document.querySelector({json.dumps(selector)}).textContent")

    def rows(self):
        """The cells of the open table."""
        return self.browser.evaluate("[...document.querySelectorAll('#table tbody tr')].map(row =>"
                                     "[...row.cells].filter(cell => cell.className !== 'go').map(cell => cell.textContent))")

    def project(self, point):
        x, y = self.browser.evaluate(f"dupinPage.view.project(dupinPage.local({list(point)}))")
        return x + TREE_WIDTH, y

    def tip_at(self, x, y):
        self.browser.move(x, y)
        self.browser.wait_for("!document.getElementById('tip').hidden")
        return self.browser.evaluate("document.getElementById('tip').textContent")

    def pose(self):
        return self.browser.evaluate("dupinPage.view.pose")
