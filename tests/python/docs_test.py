"""The examples in the documents run."""
import re

import pytest

from conftest import ROOT


def blocks(document):
    text = (ROOT / document).read_text()
    return re.findall(r"^```python\n(.*?)^```", text, re.M | re.S)


@pytest.mark.parametrize("document,least", [("README.md", 1), ("docs/python.md", 4), ("docs/tutorial.md", 1)])
def test_examples_run_as_they_stand(document, least, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "examples").symlink_to(ROOT / "examples")
    found = blocks(document)
    assert len(found) >= least
    names = {}
    for block in found:
        exec(compile(block, document, "exec"), names)
