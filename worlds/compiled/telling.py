"""Words to whoever waits: on stderr, and never a reason to stop."""

import sys
from contextlib import suppress


def tell(text: str, end: str = "\n") -> None:
    """Says something on stderr, where somebody listens: a terminal may have been closed, a pipe read to its end."""
    if sys.stderr is not None:
        with suppress(OSError, ValueError):
            print(text, end=end, file=sys.stderr, flush=True)
