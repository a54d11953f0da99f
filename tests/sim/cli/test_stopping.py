"""Signals: a run that is stopped keeps what there is, anything else ends at once, with the status that shells expect."""

import json
import signal
import subprocess
import sys
from functools import partial

import numpy as np
import pytest

import main
from sim.cli import entry, stopping
from sim.files import outputs
from sim.files.recording import load_recording
from sim.files.saving import restore

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="signals of POSIX")


@pytest.mark.parametrize("name, status", [("SIGINT", 130), ("SIGTERM", 143), ("SIGHUP", 129)])
def test_a_stopped_run_keeps_what_it_has(name, status, tmp_path):
    run, state = tmp_path / "run.npz", tmp_path / "state.npz"
    command = [sys.executable, "main.py", "--headless", "--seconds", "900000", "--record", str(run), "--save", str(state)]
    heard = partial(signal.signal, getattr(signal, name), signal.SIG_DFL)  # also where the tests run deaf to it, as under nohup
    program = subprocess.Popen(command, cwd=main.HERE, stderr=subprocess.PIPE, stdout=subprocess.PIPE, preexec_fn=heard)
    said = b""
    while b"]" not in said:  # the bar: it runs
        said += program.stderr.read(1)
    program.send_signal(getattr(signal, name))
    out, err = program.communicate()
    assert program.returncode == status and name in err.decode() and b"Traceback" not in err
    assert f"wrote {run}" in out.decode() and f"wrote {state}" in out.decode()
    recorded = load_recording(run)
    assert recorded.arrays["time"][-1] == pytest.approx(restore(state).time)
    assert np.array_equal(recorded.arrays["time"], np.arange(len(recorded.arrays["time"])) / 60)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["run.npz", "state.npz"]


def test_the_second_signal_ends_at_once(monkeypatch, tmp_path):
    ended = []
    monkeypatch.setattr(stopping.os, "_exit", ended.append)
    part = outputs.Part(tmp_path / "run.npz")
    with pytest.raises(stopping.Stopped) as stopped, stopping.between_ticks():
        assert not stopping.asked()
        stopping._heard(signal.SIGTERM)
        assert stopping.asked() and not ended and part.path.exists()
        stopping._heard(signal.SIGINT)
        assert ended == [130] and not part.path.exists()
    assert stopped.value.status == 143
    stopping._heard(signal.SIGTERM)  # nothing runs
    assert ended == [130, 143]


def test_whoever_was_told_not_to_hear_does_not():
    before = signal.signal(signal.SIGHUP, signal.SIG_IGN)
    try:
        with stopping.listening():
            assert signal.getsignal(signal.SIGHUP) == signal.SIG_IGN
            assert signal.getsignal(signal.SIGTERM) not in (signal.SIG_IGN, signal.SIG_DFL)
    finally:
        signal.signal(signal.SIGHUP, before)


def test_no_traceback_reaches_people(monkeypatch, capsys, tmp_path):
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    for fault, status in ((ZeroDivisionError("1/0"), 1), (MemoryError(), 2), (OSError(28, "No space left"), 2)):

        def broken(options, fault=fault):
            raise fault

        monkeypatch.setattr("sim.cli.jobs.run", broken)
        assert entry.run(main_options()) == status
        said = capsys.readouterr().err
        assert said.startswith("footfall: ") and "Traceback" not in said
    reports = list(tmp_path.glob("footfall-report-*.txt"))
    assert len(reports) == 2 and any("ZeroDivisionError: 1/0" in path.read_text() for path in reports)


def main_options():
    from sim.cli import parser

    return parser.parsed(["--headless"])


def test_a_reader_that_has_read_enough_is_no_fault():
    program = subprocess.Popen(
        [sys.executable, "main.py", "play", "--list"], cwd=main.HERE, stdout=subprocess.PIPE, stderr=subprocess.PIPE
    )
    program.stdout.close()
    assert program.stderr.read() == b"" and program.wait() == 0


def test_names_that_the_console_cannot_show_are_spelled(tmp_path):
    path = tmp_path / "雪.npz"
    ran = subprocess.run(
        [sys.executable, "main.py", "--headless", "--seconds", "0.1", "--record", str(path)],
        cwd=main.HERE, capture_output=True, env={**main.os.environ, "PYTHONIOENCODING": "ascii"},
    )  # fmt: skip
    assert ran.returncode == 0 and path.exists() and b"wrote " in ran.stdout and b"\\u96ea.npz" in ran.stdout


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="/dev/full")
def test_a_full_disk_keeps_no_other_file_from_being_written(tmp_path):
    state = tmp_path / "s.npz"
    ran = subprocess.run(
        [sys.executable, "main.py", "--headless", "--seconds", "0.1", "--json", "--record", "/dev/full", "--save", str(state)],
        cwd=main.HERE, capture_output=True, text=True,
    )  # fmt: skip
    assert ran.returncode == 2 and ran.stderr.count("/dev/full: cannot be written: No space left on device") == 1
    assert json.loads(ran.stdout)["seconds"] == pytest.approx(0.1) and state.exists()


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="/dev/full")
@pytest.mark.parametrize("command", [["play", "--list"], ["--help"], ["--version"], ["wander", "--help"]])
def test_words_that_find_no_room_are_missed(command):
    with open("/dev/full", "w") as full:
        ran = subprocess.run(
            [sys.executable, "main.py", *command], cwd=main.HERE, stdout=full, stderr=subprocess.PIPE, text=True, check=False
        )
    assert ran.returncode == 2 and ran.stderr == "footfall: standard output: cannot be written: No space left on device\n"


def test_unknown_kinds_of_pictures_and_films_are_refused_before_the_run(tmp_path, capsys):
    for option, ending, allowed in (("--video", ".xyz", ".mp4, .m4v"), ("--screenshot", ".docx", ".png, .jpg")):
        path = tmp_path / f"out{ending}"
        assert main.main(["--headless", option, str(path)]) == 2
        said = capsys.readouterr().err
        assert allowed in said and "Ready" not in said and not path.exists()
