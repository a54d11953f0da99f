"""The command `footfall`, and `python -m sim`: what main.py does once everything is installed."""

import os
import sys

from sim.cli import parser


def main(arguments: list[str] | None = None) -> int:
    """Runs one command; returns its exit status: 0 done, 2 bad usage or input, 3 the task itself cannot be done."""
    options = parser.parsed(sys.argv[1:] if arguments is None else arguments)
    if options.command == "test":
        print("footfall: the tests come with the source: python main.py test, in a checkout", file=sys.stderr)
        return 2
    return run(options)


def run(options: object) -> int:
    """Runs the command of parsed options."""
    os.environ.setdefault("PYGAME_HIDE_SUPPORT_PROMPT", "1")
    from sim.cli import jobs

    return jobs.run(options)


def console() -> None:
    """What is installed as `footfall`."""
    try:
        sys.exit(main())
    except KeyboardInterrupt:
        sys.exit(130)
