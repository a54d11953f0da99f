"""Files changed by chance are done or refused; a large run is `python -m tests.fuzz N`."""

from random import Random

import pytest

from tests import fuzz


@pytest.mark.parametrize("first", range(0, 100, 20))
def test_changed_files_are_done_or_refused(first, tmp_path):
    said = {k: fuzz.case(k, tmp_path) for k in range(first, first + 20)}
    assert {k: what for k, what in said.items() if what not in ("done", "refused")} == {}


def test_cases_are_the_same_everywhere():
    text = "a = 1.5\nb = [2, 3]\n" * 9
    assert fuzz.changed_text(text, Random(5)) == fuzz.changed_text(text, Random(5)) != fuzz.changed_text(text, Random(6))


def test_a_case_that_dies_is_told_and_the_others_are_done(monkeypatch):
    monkeypatch.setattr(fuzz.subprocess, "Popen", _Dying)
    assert fuzz._watched(3, 6) == {3: "killed: status -11"}


class _Dying:
    """A worker that dies of its first case, and another one that does the others."""

    stdout: list

    def __init__(self, command, **_):
        first, last = int(command[-2]), int(command[-1])
        self.stdout = [] if first == 3 else [f'[{k}, "done"]'.encode() for k in range(first, last)]

    def kill(self):
        pass

    def wait(self):
        return -11
