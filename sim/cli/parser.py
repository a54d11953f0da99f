"""The command line, as it is typed. It needs nothing but Python: it is read before anything is installed."""

import argparse
import difflib
import re
import sys
from pathlib import Path
from typing import Any, NoReturn

from sim import VERSION
from sim.cli import values
from sim.export.endings import FILMS, FORMATS
from sim.files.imports.trajectories import formats

ABOUT = "Footfall: footprints in, living motion out."
DEFAULTS: dict[str, dict[str, Any]] = {
    "wander": {"level": "forest", "character": "bird", "characters": 1, "seed": 0},
    "steer": {"level": "forest", "character": "human", "characters": 1, "seed": 0},
    "river": {"level": "river_easy", "character": "bird", "characters": 1, "seed": 0},
    "crowd": {"level": "concourse", "character": "human", "characters": 200, "seed": 0},
    "play": {"level": "fig01_steps_and_a_hop", "character": None, "characters": 1, "seed": 0},
}
"""What is meant where nothing is typed; `given` keeps what was."""
SCALES = (0.75, 1.0, 1.25, 1.5, 2.0, 3.0)


class _Parser(argparse.ArgumentParser):
    """Names what is nearest to a misspelt word."""

    def error(self, message: str) -> NoReturn:
        super().error(message + _nearest(message, self))

    def _print_message(self, message: str, file: Any = None) -> None:
        print(message or "", end="", file=file or sys.stderr, flush=True)


def _nearest(message: str, parser: argparse.ArgumentParser) -> str:
    """ "; did you mean X?" for a command or option that there is not; nothing where none is near."""
    choice = re.search(r"invalid choice: '([^']*)'", message)
    option = re.search(r"unrecognized arguments: (?:.* )?(--[^ =]+)", message)
    known = [name for action in parser._actions for name in (action.choices or ())] if choice else []
    if option:
        known = list(parser._option_string_actions)
    word = choice or option
    found = difflib.get_close_matches(word[1], known, 1, 0.7) if word else []
    return f"; did you mean {found[0]}?" if found else ""


def parsed(arguments: list[str]) -> argparse.Namespace:
    """The options of a command line; one that begins with an option, or is empty, is one of `wander`.

    Raises OSError where help is asked for and stdout does not take it.
    """
    arguments = with_default(arguments)
    if arguments[0] == "test":  # whatever follows is pytest's
        return argparse.Namespace(command="test", arguments=arguments[1:])
    top = parser()
    options, unknown = top.parse_known_args(arguments)
    if unknown:
        _command_of(top, options.command).error(f"unrecognized arguments: {' '.join(unknown)}")
    defaults = DEFAULTS.get(options.command, {})
    if options.command == "export":
        film = Path(options.out).suffix.lower() in FILMS
        options.video = options.out if film else None
    options.given = {name for name in defaults if getattr(options, name) is not None}
    for name in defaults.keys() - options.given:
        setattr(options, name, defaults[name])
    return options


def _command_of(top: argparse.ArgumentParser, command: str) -> argparse.ArgumentParser:
    """What reads the arguments of a command: it knows its options."""
    return next(one.choices[command] for one in top._actions if isinstance(one, argparse._SubParsersAction))


def with_default(arguments: list[str]) -> list[str]:
    """The command line with `wander` before it where it begins with an option."""
    first = arguments[0] if arguments else ""
    named = first and (first in ("-h", "--help", "--version") or not first.startswith("-"))
    return arguments if named else ["wander", *arguments]


def parser() -> argparse.ArgumentParser:
    """The whole command line."""
    top = _Parser(prog="footfall", description=ABOUT, allow_abbrev=False)
    top.add_argument("--version", action="version", version=f"footfall {VERSION}")
    commands = top.add_subparsers(dest="command", metavar="COMMAND", required=True)
    _add_runs(commands)
    _add_reports(commands)
    _add_imports(commands)
    _add_plans(commands)
    _add_batch(commands)
    _add_doors(commands)
    commands.add_parser("test", help="run the tests, in a checkout; further arguments go to pytest")
    return top


def _add_runs(commands: argparse._SubParsersAction) -> None:
    """Commands that let characters walk."""
    wander = commands.add_parser("wander", help="wander through a forest (the default)")
    river = commands.add_parser("river", help="cross a river on its rocks")
    steer = commands.add_parser("steer", help="drive a character by keys or gamepad; headless, by keys of chance")
    crowd = commands.add_parser("crowd", help="people come into a level, wait, and go out, as its sources and exits say")
    play = commands.add_parser("play", help="play a scripted scene: footprints from a file")
    play.add_argument("level", nargs="?", metavar="SCENE", help="a scene that ships, or a .toml file")
    play.add_argument("--list", action="store_true", help="name the scenes that ship")
    edit = commands.add_parser("edit", help="the studio: place footprints, shape their timing, see the motion at once")
    edit.add_argument(
        "level", nargs="?", metavar="SCENE|RUN.npz", help="a scene that ships, a .toml file, or a recording; else a new scene"
    )
    edit.add_argument("--size", type=values.size, default=(1280, 720), metavar="WxH")
    edit.add_argument("--scale", type=float, default=1.0, choices=SCALES, help="of letters: 2 on screens of twice the pixels")
    edit.add_argument("--screenshot", metavar="P.png", help="draw the studio once, without a window, and end")
    edit.add_argument("--pictures", metavar="FOLDER", help="draw the pictures of docs/studio.md, and end")
    edit.add_argument("--latency", action="store_true", help="measure how long a drag takes from mouse to picture, and end")
    for job in (wander, steer, river, play):
        _common(job)
    _crowded(crowd)
    wander.add_argument(
        "--mixed", action="store_true", help="people as the level's populations say, each with a speed of its own"
    )
    for job in (wander, steer, river, crowd):
        job.add_argument("level", nargs="?", help="a level that ships, or a .toml file")
        job.add_argument("--save", metavar="STATE.npz", help="the state at the end, to go on from")
        job.add_argument("--restore", metavar="STATE.npz", help="go on from a saved state; --seconds counts from its beginning")
    play.set_defaults(save=None, restore=None)


def _add_reports(commands: argparse._SubParsersAction) -> None:
    """Commands that tell something."""
    sheets = commands.add_parser("sheets", help="draw a contact sheet of every scene")
    sheets.add_argument("scenes", nargs="*", metavar="SCENE", help="only these")
    sheets.add_argument("--folder", default="docs/scenes", help="where to write them")
    sheets.add_argument("--window", metavar="FOLDER", help="draw the window itself instead, in all it does, at several sizes")
    measure = commands.add_parser("measure", help="measure the quality of a recorded run")
    measure.add_argument("recording", metavar="RUN.npz")
    measure.add_argument("--plot", metavar="OUT.png", help="draw com, costs, joints, stances over time (.png, .svg, .pdf)")
    measure.add_argument(
        "--character-index", type=values.index, default=0, metavar="C", help="of the character to draw, from 0"
    )
    measure.add_argument("--between", type=float, nargs=2, metavar=("T0", "T1"), help="draw only these seconds")
    timing = commands.add_parser("timing", help="the automatic timing over the step length")
    timing.add_argument("--character", help="bird, dinosaur, human, ostrich, or a .toml file; without it every one that ships")
    timing.add_argument("--plot", metavar="OUT.png", help="draw it (.png, .svg, .pdf)")
    literature = commands.add_parser("literature", help="compare the human, walking and running on the flat, with people")
    literature.add_argument("--curves", metavar="PEOPLE.csv", help="compare whole curves: gait,quantity,percent,mean")
    literature.add_argument("--plot", metavar="OUT.png", help="draw the curves of a stride (.png, .svg, .pdf)")
    verify = commands.add_parser("verify", help="compare crowds with people: speed over density, bottlenecks, counterflow")
    verify.add_argument("--quick", action="store_true", help="few cases")
    verify.add_argument("--case", type=values.index, metavar="N", help="only test N of the RiMEA guideline")
    verify.add_argument("--without", metavar="TERM", help="leave a term of the steps' costs out, such as touch")
    verify.add_argument("--model", default="steps", help="how people choose among others: steps, or orca")
    verify.add_argument("--ablation", action="store_true", help="only the table of what each term of the costs pays")
    verify.add_argument("--trajectories", metavar="FOLDER", help="write where everyone went, as PedPy reads it")
    verify.add_argument("--pictures", metavar="FOLDER", help="draw speeds, flows, lanes, density, and what weights do")
    trials = commands.add_parser("trials", help="drive characters about levels by keys of chance; measure what may go wrong")
    trials.add_argument("levels", nargs="*", metavar="LEVEL", help="levels that ship, or .toml files; by default all that ship")
    trials.add_argument("--character", help="bird, dinosaur, human, ostrich, or a .toml file; by default all that ship")
    trials.add_argument("--seconds", type=values.seconds, default=600.0, metavar="T", help="simulated, for each of them")
    trials.add_argument("--seed", type=values.seed, default=1, help="of chance; the same one is the same trial")
    check = commands.add_parser("check", help="check level, scene and character files; names every fault")
    check.add_argument("files", nargs="+", metavar="FILE")
    bench = commands.add_parser("bench", help="measure speed against other solvers")
    bench.add_argument("--quick", action="store_true", help="fewer repetitions and smaller crowds")
    parts = "solver, window, crowd, jam, learning, startup, frames or driven"
    bench.add_argument("--only", metavar="PART", help=f"measure {parts} alone")
    bench.add_argument("--plot", metavar="OUT.png", help="draw how crowds keep real time, and what a step costs")
    for report in (measure, timing, literature, verify, trials, bench):
        report.add_argument("--json", action="store_true")


def _add_imports(commands: argparse._SubParsersAction) -> None:
    """Commands that bring in what others have measured."""
    prints = commands.add_parser("import-trackway", help="make a scene of a trackway: prints of a .tps or .csv file")
    prints.add_argument("file", metavar="FILE")
    prints.add_argument(
        "--scale", type=values.length, metavar="M", help="metres in a pixel or unit of the file (a .csv's own: 1)"
    )
    prints.add_argument(
        "--hip-height", type=values.length, nargs="+", required=True, metavar="H", help="metres; one, or one each"
    )
    prints.add_argument("--trackway", type=values.index, metavar="K", help="only this one, from 1; else all, in one world")
    prints.add_argument("--first-side", choices=("left", "right"), nargs="+", default=["left"], help="one, or one each")
    prints.add_argument("--character", default="dinosaur", help="who walks, scaled to the hip height")
    prints.add_argument("--speed", choices=("ruiz", "alexander"), default="ruiz", help="the law of the speed")
    prints.add_argument("--out", required=True, metavar="SCENE.toml", help="several get numbers: SCENE.1.toml ...")
    prints.add_argument("--json", action="store_true", help="print the report as JSON")
    people = commands.add_parser("import-trajectories", help="let people walk where a file says that they were")
    people.add_argument("file", metavar="FILE")
    people.add_argument("--format", choices=formats.FORMATS, help="by default as the file looks")
    people.add_argument("--fps", type=values.length, help="frames a second, where the file does not say")
    people.add_argument("--homography", metavar="H.txt", help="nine numbers that make metres of a .vsp's pixels")
    people.add_argument("--between", type=float, nargs=2, metavar=("T0", "T1"), help="only these seconds of the file")
    people.add_argument("--character", default="human", help="bird, dinosaur, human, ostrich, or a .toml file")
    _shown(people)
    people.set_defaults(save=None, restore=None, seed=0, characters=1)


def _add_plans(commands: argparse._SubParsersAction) -> None:
    """Floor plans."""
    plan = commands.add_parser("import-plan", help="make a level of a floor plan: walls of a .wkt or .dxf file")
    plan.add_argument("file", metavar="FILE")
    plan.add_argument(
        "--scale", type=values.length, metavar="M", help="metres in a unit of the file; else 1, or as a drawing says"
    )
    plan.add_argument("--thickness", type=values.length, default=0.1, metavar="M", help="of the walls, metres")
    plan.add_argument("--layers", nargs="+", metavar="NAME", help="only these layers of a drawing")
    plan.add_argument("--out", required=True, metavar="LEVEL.toml")


def _add_batch(commands: argparse._SubParsersAction) -> None:
    """Many runs at once."""
    batch = commands.add_parser("batch", help="simulate many levels and seeds, measured in one table; killed, it goes on")
    batch.add_argument("--level", nargs="+", required=True, help="levels that ship, or .toml files")
    batch.add_argument("--seeds", type=values.seeds, required=True, metavar="A:B", help="from A on, up to but not B")
    batch.add_argument("--out", required=True, metavar="DIR", help="where shards and table are, and where to go on")
    batch.add_argument("--task", choices=("wander", "river"), default="wander", help="wander about, or cross to the goal")
    batch.add_argument("--character", default="bird", help="bird, dinosaur, human, ostrich, or a .toml file")
    batch.add_argument("--characters", type=values.positive, default=1, metavar="N", help="how many in each run")
    batch.add_argument("--seconds", type=values.seconds, default=20.0, metavar="T", help="simulated seconds of each run")
    batch.add_argument("--jobs", type=values.positive, metavar="J", help="processes; by default one for each processor")
    batch.add_argument("--engine", choices=("processes", "ray"), default="processes", help="this machine, or a Ray cluster")
    batch.add_argument("--json", action="store_true", help="print what came of it as JSON")


def _add_doors(commands: argparse._SubParsersAction) -> None:
    """Commands that let motion out to other programs."""
    export = commands.add_parser(
        "export", help="motion for other programs: " + ", ".join(FORMATS), formatter_class=argparse.RawDescriptionHelpFormatter,
        epilog="kinds of files:\n" + "\n".join(f"  {ending:10}{form.about}" for ending, form in FORMATS.items()),
    )  # fmt: skip
    export.add_argument("source", metavar="RUN.npz|STATE.npz|SCENE", help="a recording, a saved state, or a scene")
    export.add_argument("out", metavar="OUT", help="its ending says what is made")
    export.add_argument("--character-index", type=values.index, metavar="C", help="only this one, from 0")
    export.add_argument("--between", type=float, nargs=2, metavar=("T0", "T1"), help="only these seconds of the run")
    export.add_argument("--fps", type=float, metavar="N", help="moments per second; by default all that there are")
    export.add_argument("--array", metavar="NAME", help=".csv: this array of a recording")
    export.add_argument("--scenery", action="store_true", help="terrain, trees, rocks and water too (.glb)")
    export.add_argument("--size", type=values.size, default=(960, 540), metavar="WxH", help="of films and sprites, in pixels")


def _common(job: argparse.ArgumentParser) -> None:
    job.add_argument("--character", help="bird, dinosaur, human, ostrich, or a .toml file")
    job.add_argument("--characters", type=values.positive, metavar="N", help="how many")
    job.add_argument("--seed", type=values.seed, help="of chance; the same one is the same run")
    _shown(job)


def _crowded(job: argparse.ArgumentParser) -> None:
    job.add_argument("--characters", type=values.positive, metavar="N", help="so many at once, at most; others wait outside")
    job.add_argument("--seed", type=values.seed, help="of chance; the same one is the same run")
    _shown(job)
    job.set_defaults(character=None)


def _shown(job: argparse.ArgumentParser) -> None:
    job.add_argument("--headless", action="store_true", help="no window")
    job.add_argument("--scale", type=float, default=1.0, choices=SCALES, help="of letters: 2 on screens of twice the pixels")
    job.add_argument("--seconds", type=values.seconds, metavar="T", help="simulated seconds, then end")
    job.add_argument("--record", metavar="RUN.npz")
    job.add_argument("--scene", metavar="S.toml", help="the run's footprints as a scene, for `edit` and `play`")
    job.add_argument("--screenshot", metavar="P.png", help="a picture of the end")
    job.add_argument("--video", metavar="V.mp4", help="a film of the run")
    job.add_argument("--size", type=values.size, default=(960, 540), metavar="WxH")
    job.add_argument("--json", action="store_true", help="print the run's summary as JSON")
