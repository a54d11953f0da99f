"""A process of a batch: takes runs as lines of JSON, writes their shards, and answers each with a line.

It ends when there are no more lines: also when whoever gave them is gone.
"""

import json
import sys

from sim.reports.batch.plan import Job
from sim.reports.batch.running import simulate
from sim.reports.batch.shards import Shards
from worlds.compiled.telling import be_quiet
from worlds.errors import InputError


def serve(folder: str) -> None:
    """Does runs until there are no more."""
    shards = Shards(folder)
    for line in sys.stdin:
        job = Job(*json.loads(line))
        try:
            shards.write(job, simulate(job))
            answer = ""
        except InputError as error:
            answer = str(error)
        print(json.dumps(answer), flush=True)


if __name__ == "__main__":
    be_quiet()
    serve(sys.argv[1])
