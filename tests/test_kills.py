"""A few kills of each kind that needs neither a display nor minutes; all of them: python -m tests.kills 50."""

import os
import random

import pytest

from tests import kills


@pytest.mark.skipif(os.name != "posix", reason="kill -9 of a process and its children")
@pytest.mark.parametrize("name", ["record", "save"])
def test_kill_9_leaves_old_files_whole_and_the_next_start_works(name, tmp_path):
    kills.killed(name, tmp_path, 2, random.Random(1))
