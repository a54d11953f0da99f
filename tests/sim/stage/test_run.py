"""How much of a run is done, told to terminals and to files."""

import sys
from io import StringIO

from sim.stage.run import Bar


class Terminal(StringIO):
    def isatty(self):
        return True


def told(to, monkeypatch):
    monkeypatch.setattr(sys, "stderr", to)
    bar = Bar()
    for k in range(50):
        bar.show((k + 1) / 50)
    bar.end()
    return to.getvalue()


def test_a_terminal_has_a_bar_in_one_line(monkeypatch):
    text = told(Terminal(), monkeypatch)
    assert text.count("\n") == 1 and text.count("\r") == 50 and text.endswith(f"[{'#' * 30}] 100%\n")


def test_a_file_has_a_line_for_each_tenth(monkeypatch):
    lines = told(StringIO(), monkeypatch).split("\n")
    assert [line.split()[-1] for line in lines if line] == ["2%", *(f"{k}0%" for k in range(1, 11))], "that it runs, at once"
