#!/usr/bin/env python3
"""Report pages in a real browser: they load from a file without a complaint and without asking for anything
else, and clicks do what they say. Pictures are compared by coarse features. Needs a Chromium, and skips
without (exit code 77). Usage: report_page_test.py DUPIN [FOLDER, for the pictures]"""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

import browser

DOCUMENT = {"units": "mm", "tolerance": 0.05, "parts": [
    {"name": "run", "colour": "#c0392b", "pipe": {"from": [0, 0, 0], "to": [40, 0, 0], "radius": 6}},
    {"name": "branch", "pipe": {"from": [15, 0, 0], "to": [15, 0, 30], "radius": 4}},
    {"name": "next", "pipe": {"from": [41, 0, 0], "to": [60, 0, 0], "radius": 6}},
    {"name": "<b>bad</b></script>", "sphere": {"center": [75, 0, 0], "radius": 8}}]}
STAGE = (250, 50, 730, 740)  # x, y, width, height of the picture below its tools


def is_red(r, g, b):
    return r > 1.6 * g and r > 1.6 * b


def is_cap(r, g, b):
    return r > 225 and g > 215 and 190 < b < 225 and r - b > 20


class ReportPage(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        folder = pathlib.Path(cls.folder.name)
        (folder / "plant.json").write_text(json.dumps(DOCUMENT), encoding="utf-8")
        built = subprocess.run([TOOL, "build", "plant.json", "-o", "plant.stl", "--report", "plant.html", "--connect", "2mm"],
                               cwd=folder, capture_output=True, text=True, check=False)
        assert built.returncode == 1, built.stderr  # there is a gap
        cls.url = (folder / "plant.html").as_uri()
        cls.browser = browser.Browser(browser.find())
        cls.addClassCleanup(cls.browser.__exit__)

    def setUp(self):
        self.browser.said.clear()
        self.browser.asked.clear()
        self.browser.open(self.url)
        self.browser.wait_for("window.dupinPage !== undefined && dupinPage.view && !dupinPage.view.requested")

    def tearDown(self):
        complaints = [text for text in self.browser.said if "GL Driver Message" not in text]
        self.assertEqual(complaints, [])
        self.assertEqual([url for url in self.browser.asked if not url.startswith(("file:", "data:"))], [])

    def shot(self, name):
        """The picture at rest."""
        self.browser.wait_for("!dupinPage.view.flight && !dupinPage.view.requested")
        self.browser.move(STAGE[0] + 5, STAGE[1] + STAGE[3] - 5)
        self.browser.evaluate("new Promise(done => setTimeout(() => requestAnimationFrame(() => requestAnimationFrame(done)), 400))")
        picture = self.browser.picture(STAGE)
        if len(sys.argv) > 2:
            (pathlib.Path(sys.argv[2]) / f"{name}.png").write_bytes(self.browser.picture().png)
        return picture

    def click(self, selector):
        x, y = self.browser.evaluate(
            f"(() => {{ const e = document.querySelector({json.dumps(selector)}); e.scrollIntoView({{block: 'nearest'}});"
            "const b = e.getBoundingClientRect(); return [b.x + b.width / 2, b.y + b.height / 2]; })()")
        self.browser.click(x, y)

    def open_tab(self, title):
        index = self.browser.evaluate(
            f"[...document.querySelectorAll('#tabs button')].findIndex(b => b.textContent.startsWith({json.dumps(title)}))")
        self.assertGreaterEqual(index, 0, title)
        self.click(f"#tabs button:nth-child({index + 1})")

    def project(self, point):
        x, y = self.browser.evaluate(f"dupinPage.view.project(dupinPage.local({point}))")
        return x + 250, y

    def test_shows_the_solid_and_its_texts_as_they_are(self):
        picture = self.shot("solid")
        self.assertGreater(picture.count(is_red), 2000)
        names = self.browser.evaluate("[...document.querySelectorAll('#parts .name')].map(e => e.textContent)")
        self.assertEqual(names, [part["name"] for part in DOCUMENT["parts"]])

    def test_a_click_on_a_gap_moves_the_camera_there(self):
        before = self.shot("before")
        self.open_tab("Gaps")
        self.assertEqual(self.browser.evaluate("document.querySelector('tr.finding td').textContent"), "gap")
        self.click("tr.finding")
        after = self.shot("gap")
        self.assertGreater(before.difference(after), 0.3)
        x, y = self.project([40.5, 0, 0])
        self.assertLess(abs(x - 615) + abs(y - 400), 3)
        self.assertLess(self.browser.evaluate("dupinPage.view.pose.height"), 25)

    def test_a_hidden_part_is_not_seen(self):
        self.assertGreater(self.shot("shown").count(is_red), 2000)
        self.click("#parts input[type=checkbox]")
        self.assertLess(self.shot("hidden").count(is_red), 100)
        self.click("#show-all")
        self.assertGreater(self.shot("again").count(is_red), 2000)

    def test_a_section_is_capped_and_measured(self):
        self.assertLess(self.shot("whole").count(is_cap), 20)
        self.click("#section")
        picture = self.shot("section")
        self.assertGreater(picture.count(is_cap), 1500)
        text = self.browser.evaluate("document.getElementById('cut-text').textContent")
        self.assertRegex(text, r"^y = [0-9.\u2212e]+ mm, area \d+")
        self.browser.evaluate("(() => { const place = document.getElementById('cut-place'), axis = document.getElementById('cut-axis');"
                              "axis.value = 0; axis.onchange(); place.value = 361; place.oninput(); })()")
        area = float(self.browser.evaluate("document.getElementById('cut-text').textContent").split("area ")[1].split(" ")[0])
        self.assertAlmostEqual(area, 113.1, delta=2)  # x = 30: the run alone

    def test_two_clicks_measure(self):
        self.click("[data-view=front]")
        self.shot("front")
        self.click("#measure")
        for point in ([5, -6, 0], [35, -6, 0]):
            self.browser.click(*self.project(point))
        self.shot("measured")
        points = self.browser.evaluate("dupinPage.overlay.measured")
        self.assertEqual(len(points), 2)
        self.assertAlmostEqual(abs(points[1][0] - points[0][0]), 30, delta=1)

    def test_the_pointer_names_part_and_patch(self):
        x, y = self.project([17.5, 0, 30])  # beside the mark of the open end
        self.browser.move(x, y)
        self.browser.wait_for("!document.getElementById('tip').hidden")
        tip = self.browser.evaluate("document.getElementById('tip').textContent")
        self.assertTrue(tip.startswith("branch, pipe\nbranch.end\n"), tip)

    def test_wireframe_and_dragging_change_the_picture(self):
        before = self.shot("smooth")
        self.click("#wireframe")
        dark = lambda r, g, b: r + g + b < 330
        self.assertGreater(self.shot("mesh").count(dark), before.count(dark))
        self.click("#wireframe")
        self.browser.drag((600, 600), (700, 560))
        self.assertGreater(before.difference(self.shot("turned")), 0.1)


if __name__ == "__main__":
    if browser.find() is None:
        print("skipped: there is no Chromium to load pages in (Debian: chromium)")
        sys.exit(77)
    TOOL = sys.argv[1]
    unittest.main(argv=sys.argv[:1])
