#!/usr/bin/env python3
"""A picture of a report page in a Chromium. Usage: page_picture.py PAGE.html OUT.png [TABLE, that is open]"""
import json
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "tests/cli"))
import browser

SIZE = (1000, 480)


def main(page, out, table=""):
    with browser.Browser(browser.find(), SIZE) as window:
        window.open(pathlib.Path(page).resolve().as_uri())
        window.wait_for("window.dupinPage !== undefined && dupinPage.view && !dupinPage.view.requested")
        if table:
            window.evaluate(f"[...document.querySelectorAll('#tabs button')].find(b => b.textContent.startsWith({json.dumps(table)}))"
                            ".click()")
        window.evaluate("new Promise(done => setTimeout(() => requestAnimationFrame(() => requestAnimationFrame(done)), 500))")
        pathlib.Path(out).write_bytes(window.picture().png)
    print("docs/pictures/" + pathlib.Path(out).name)


if __name__ == "__main__":
    main(*sys.argv[1:])
