"""The command `footfall`, and `python -m sim`: what main.py does once everything is installed."""

import os
import sys
import tempfile
import traceback
from contextlib import suppress
from typing import Any

from sim import VERSION
from sim.cli import parser, stopping
from sim.cli.status import BAD_INPUT, DONE, FAULT, forget_stdout, refuse_words, takes_words
from worlds.errors import InputError


def main(arguments: list[str] | None = None) -> int:
    """Runs one command; returns its exit status (sim.cli.status)."""
    try:
        options = parser.parsed(sys.argv[1:] if arguments is None else arguments)
    except OSError as error:
        return refuse_words(error)
    if options.command == "test":
        print("footfall: the tests come with the source: python main.py test, in a checkout", file=sys.stderr)
        return BAD_INPUT
    return run(options)


def run(options: Any) -> int:
    """Runs the command of parsed options. The last net: whatever happens, people get a sentence and a status."""
    os.environ.setdefault("PYGAME_HIDE_SUPPORT_PROMPT", "1")
    _speak_plainly()
    try:
        with stopping.listening():
            from sim.cli import jobs

            status = jobs.run(options)
            sys.stdout.flush()
            return status
    except stopping.Stopped as stopped:  # and has said so
        return stopped.status
    except BrokenPipeError:  # whoever reads has read enough, as `| head -1` does
        forget_stdout()
        return DONE
    except InputError as error:
        _say(str(error))
        return BAD_INPUT
    except MemoryError:
        _say("this needs more memory than there is")
        return BAD_INPUT
    except OSError as error:
        if not error.filename and not takes_words():
            return refuse_words(error)
        forget_stdout()
        _say(f"{error.filename or 'what was to be read or written'}: {error.strerror or error}")
        _say(f"where that was: {_report(options)}")
        return BAD_INPUT
    except Exception as error:
        _say(f"this should not have happened: {type(error).__name__}: {error}")
        _say(f"please send the report with what you did: {_report(options)}")
        return FAULT


def _speak_plainly() -> None:
    """Characters that the console cannot show are written as \\u...; where a stream is closed, nothing is said there."""
    for name in ("stdout", "stderr"):
        stream = getattr(sys, name)
        if stream is None:
            setattr(sys, name, open(os.devnull, "w"))  # noqa: SIM115 (it lives as long as the program)
        elif hasattr(stream, "reconfigure"):
            stream.reconfigure(errors="backslashreplace")


def _say(text: str) -> None:
    with suppress(OSError, ValueError):
        print(f"footfall: {text}", file=sys.stderr, flush=True)


def _report(options: Any) -> str:
    """A new file with what Python knows of the fault; where it is, or the fault itself where no file can be made."""
    text = f"Footfall {VERSION}, Python {sys.version}, {sys.platform}\n{options}\n\n{traceback.format_exc()}"
    try:
        handle, path = tempfile.mkstemp(".txt", "footfall-report-")
        with open(handle, "w", encoding="utf-8", errors="backslashreplace") as file:
            file.write(text)
        return path
    except OSError:
        return text


def console() -> None:
    """What is installed as `footfall`."""
    try:
        sys.exit(main())
    except KeyboardInterrupt:
        sys.exit(130)
