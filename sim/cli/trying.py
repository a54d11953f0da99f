"""`trials`: characters are driven about levels by keys of chance, and what may go wrong is measured."""

import json
from typing import Any

from motion.characters.character import character_names, load_character
from sim.reports.trials.trial import as_dict, in_words, seed_of, trial
from sim.stage.warmup import warm_up
from worlds.compiled.telling import tell
from worlds.level import level_names, load_level


def trials(options: Any) -> None:
    """A line for each level and character; what is wrong there is no error of the command."""
    levels = options.levels or level_names()
    characters = [options.character] if options.character else character_names()
    for level in levels:
        load_level(level)
    for character in characters:
        load_character(character)
    warm_up("steer", tell)
    found = []
    for level, character in [(level, character) for level in levels for character in characters]:
        found.append(trial(level, character, options.seconds, seed_of(level, character, options.seed)))
        if not options.json:
            print(in_words(found[-1]), flush=True)
    if options.json:
        print(json.dumps([as_dict(one) for one in found]))
