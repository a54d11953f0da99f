"""The page in a browser without a window, from a file: it plays, scrubs, complains about nothing and asks for nothing."""

import html
import json
import re
import shutil
import subprocess

import numpy as np
import pytest
from PIL import Image

from sim.export.clip.asked import Asked
from sim.export.page import export_page
from tests.sim.export.readers import clip, recording

BROWSERS = ("chromium", "chromium-browser", "google-chrome")
FLAGS = (
    "--headless=new", "--no-sandbox", "--no-first-run", "--disable-background-networking", "--disable-component-update",
    "--disable-sync", "--host-resolver-rules=MAP * ~NOTFOUND", "--disable-default-apps", "--disable-extensions",
    "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader",
    "--enable-logging=stderr", "--v=0", "--window-size=640,480", "--virtual-time-budget=30000",
)  # fmt: skip
SCRUB = """<script>
const wait = setInterval(() => {
  if (!document.body.dataset.ready) return;
  clearInterval(wait);
  const line = document.getElementById('timeline'), box = line.getBoundingClientRect();
  const hand = (share) => new PointerEvent('pointerdown', {clientX: box.left + share * box.width, buttons: 1});
  const press = (share) => line.dispatchEvent(hand(share));
  press(0.25); document.body.dataset.quarter = document.body.dataset.time;
  press(0.75); document.body.dataset.threeQuarters = document.body.dataset.time;
  document.getElementById('play').click();
  const asked = performance.getEntriesByType('resource').filter((one) => !/^(data|blob):/.test(one.name));
  document.body.dataset.asked = asked.length;
  document.body.dataset.said = document.getElementById('time').textContent;
}, 50);
</script>"""
"""What somebody's hand does to the page, who then lets it play."""


def browse(tmp_path, page, *more):
    """What the browser prints, and what it complains about, as of a request that it forbids. Skipped without one."""
    browser = next(filter(None, map(shutil.which, BROWSERS)), None)
    if browser is None:
        pytest.skip("needs Chromium")
    command = [browser, *FLAGS, f"--user-data-dir={tmp_path / 'profile'}", *more, page]
    done = subprocess.run(command, capture_output=True, text=True, timeout=180)
    return done.stdout, [line for line in done.stderr.splitlines() if "CONSOLE" in line]


@pytest.fixture(scope="module")
def page(tmp_path_factory):
    path = tmp_path_factory.mktemp("page") / "run.html"
    export_page(clip(recording("human", seconds=4.0)), str(path), Asked())
    return path


def test_a_page_plays_and_scrubs_from_a_file(page, tmp_path):
    played = tmp_path / "scrubbed.html"
    played.write_text(page.read_text("utf-8").replace("</body>", SCRUB + "</body>"), "utf-8")
    for _ in range(3):  # a machine that is busy may draw no further frame before the browser is done
        text, console = browse(tmp_path, played.as_uri(), "--dump-dom")
        found = dict(re.findall(r'data-([a-z-]+)="([^"]*)"', text[text.index("<body") : text.index("<canvas")]))
        if float(found["time"]) > float(found["three-quarters"]):
            break
    assert console == [] and found["asked"] == "0"
    assert float(found["quarter"]) == pytest.approx(1.0, abs=0.05)
    assert float(found["three-quarters"]) == pytest.approx(3.0, abs=0.05)
    assert float(found["time"]) > float(found["three-quarters"])  # it went on
    assert "stance" in html.unescape(found["said"]) and int(found["frames"]) > 1  # how many, a machine may take its time


def test_pictures_of_two_times_differ(page, tmp_path):
    pictures = []
    for time in ("1.0", "2.5"):
        shot = tmp_path / f"{time}.png"
        _, console = browse(tmp_path, f"{page.as_uri()}#t={time}", f"--screenshot={shot}")
        assert console == []
        pictures.append(np.asarray(Image.open(shot).convert("L"), float))
    middle = [picture[60:-160, 100:-100] for picture in pictures]
    assert np.abs(middle[0] - middle[1]).mean() > 2.0 and middle[0].std() > 10.0


def test_ten_seconds_of_one_human_are_small(tmp_path):
    path = tmp_path / "run.html"
    export_page(clip(recording("human", seconds=10.0)), str(path), Asked())
    assert path.stat().st_size < 2_000_000


def test_no_name_escapes_into_the_page(tmp_path):
    """Names come from other people's files."""
    run = clip(recording("human"))
    path = tmp_path / "run.html"
    hostile = type(run)("</script><script>alert(1)</script>{{glb}}", run.world, run.time, run.rate, run.actors)
    export_page(hostile, str(path), Asked())
    text = path.read_text("utf-8")
    assert "<script>alert" not in text and "{{glb}}" in text
    assert json.loads(re.search(r'id="run">(.*?)</script>', text)[1])["frames"] == len(run.time)
