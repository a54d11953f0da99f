"""Documents: any edits undone end where they began, to the bit; none raises."""

import numpy as np
import pytest
from hypothesis import HealthCheck, settings
from hypothesis import strategies as st
from hypothesis.stateful import RuleBasedStateMachine, invariant, precondition, rule

from planner.script.shaping import ComPull, Key, Stretch
from sim.files.studio import edits, groups, paths, shapes
from sim.files.studio.document import Spot, document_of, footprint_at, footprints_in, new_document, sheet_of, spots_of
from sim.files.studio.history import begun
from sim.files.studio.writing import text_of
from worlds import reading

NUMBERS = st.floats(-20, 20, allow_nan=False)
POINTS = st.tuples(NUMBERS, NUMBERS)
TIMES = st.one_of(st.none(), st.floats(-0.5, 3.0))
KEYS = st.sampled_from(["stance_time", "step_time", "at", "stand", "crouch", "facing_deg", "heading_deg", "nonsense"])


def walk(count=6):
    """A document of a walk along x."""
    history = begun(new_document())
    for i in range(count):
        assert history.do(edits.Place(0, i - 1, (1.0 + 0.6 * max(i - 1, 0), 2.0 + 0.1 * (1 - i % 2)), 0.0)) is None
    return history


class Editing(RuleBasedStateMachine):
    """Edits by chance, undone and redone by chance."""

    def __init__(self):
        super().__init__()
        self.history = begun(walk(3).document)
        self.first = self.history.document
        self.seen = {self.history.at: self.history.document}

    def do(self, edit):
        said = self.history.do(edit)
        assert said is None or (isinstance(said, str) and said)
        self.seen = {at: one for at, one in self.seen.items() if at < self.history.at} | {
            self.history.at: self.history.document
        }

    def spots(self, chance):
        known = spots_of(self.history.document)
        picked = chance.draw(st.lists(st.sampled_from(known), min_size=1, max_size=5, unique=True)) if known else []
        return tuple(sorted(picked)) or (Spot(0, 99),)

    @rule(at=POINTS, heading=NUMBERS, after=st.integers(-1, 8))
    def place(self, at, heading, after):
        count = len(footprints_in(self.history.document.tracks[0]))
        self.do(edits.Place(0, min(after, count - 1), at, heading))

    @rule(chance=st.data(), by=POINTS)
    @precondition(lambda self: spots_of(self.history.document))
    def move(self, chance, by):
        self.do(edits.Move(self.spots(chance), by))

    @rule(chance=st.data(), by=NUMBERS)
    @precondition(lambda self: spots_of(self.history.document))
    def turn(self, chance, by):
        spots = self.spots(chance)
        for edit in (edits.Turn(spots, by), edits.ScaleStride(spots, 1 + by / 40), edits.Mirror(spots), groups.Reverse(spots)):
            self.do(edit)

    @rule(chance=st.data(), key=KEYS, value=TIMES)
    @precondition(lambda self: spots_of(self.history.document))
    def set(self, chance, key, value):
        self.do(edits.Set(self.spots(chance), key, value))

    @rule(chance=st.data())
    @precondition(lambda self: spots_of(self.history.document))
    def rearrange(self, chance):
        spots, document = self.spots(chance), self.history.document
        kind = chance.draw(st.sampled_from(["flip", "delete", "paste", "auto", "retime"]))
        made = {
            "flip": lambda: edits.Flip(spots), "delete": lambda: edits.Delete(spots), "auto": lambda: edits.AutoTime(spots),
            "paste": lambda: groups.Paste(0, -1, groups.copied(document, spots), (0.3, 0.1)),
            "retime": lambda: edits.Retime(spots, (0.5,) * len(spots), (None,) * len(spots)),
        }  # fmt: skip
        self.do(made[kind]())

    @rule(points=st.lists(POINTS, min_size=2, max_size=4), to=POINTS, point=st.integers(0, 4), tangent=st.booleans())
    def bend(self, points, to, point, tangent):
        if len(self.history.document.tracks[0].path) < 2:
            self.do(paths.DrawPath(0, tuple(points)))
        self.do(paths.BendPath(0, 0, point, to, tangent))
        self.do(paths.AddPoint(0, 0, point, to))
        self.do(paths.RemovePoint(0, 0, point))

    @rule(width=TIMES, index=st.integers(-1, 2))
    def change_path(self, width, index):
        self.do(paths.SetPath(0, index, {"step_width": width, "stagger": 0.1}))
        self.do(paths.RemovePath(0, index))

    @rule(a=st.integers(0, 6), share=st.floats(0.05, 2.0), kind=st.sampled_from(["stretch", "pull", "key"]))
    def shape(self, a, share, kind):
        made = {
            "stretch": Stretch(first=a, last=a + 1, gravity=share), "pull": ComPull(footprint=a, position=(1.0, share, 1.0)),
            "key": Key(bone="hand_left", footprint=a, rotation_deg=(share, 0.0, 0.0)),
        }  # fmt: skip
        self.do(shapes.AddShape(0, made[kind]))
        self.do(shapes.SetShape(0, kind, a, None))

    @rule()
    def more_tracks(self):
        if len(self.history.document.tracks) < 3:
            self.do(groups.AddTrack("bird"))
        else:
            self.do(groups.Splice(0, 2))
        self.do(groups.SetTrack(0, "support", "toe"))

    @rule(back=st.integers(1, 5))
    def undo_and_redo(self, back):
        here = self.history.at
        done = sum(self.history.undo() is not None for _ in range(back))
        assert self.history.at == here - done
        for _ in range(done):
            assert self.history.redo()
        assert self.history.at == here

    @rule(back=st.integers(1, 3))
    def undo(self, back):
        for _ in range(back):
            self.history.undo()

    @invariant()
    def every_document_is_as_it_was(self):
        for at, document in self.seen.items():
            if at < len(self.history.steps):
                assert self.history.steps[at].document is document

    def teardown(self):
        while self.history.undo():
            pass
        assert self.history.document is self.first


TestEditing = Editing.TestCase
TestEditing.settings = settings(max_examples=10, stateful_step_count=50, deadline=None, suppress_health_check=list(HealthCheck))


def test_a_document_comes_back_from_its_text_to_the_bit():
    history = walk()
    third = (Spot(0, 3),)
    for edit in (
        edits.Move(third, (0.1 + 0.2, 1 / 3)), edits.Set(third, "stance_time", 2 / 3), edits.Turn(third, 0.1),
        paths.DrawPath(0, ((5.0, 2.0), (7.0, 3.1), (9.0, 2.0))), edits.Move((Spot(0, 8),), (0.07, -0.03)),
        shapes.AddShape(0, Key(bone="hand_left", footprint=4, rotation_deg=(10.0, 0.1, 0.0))), groups.AddTrack("bird"),
        edits.Place(1, -1, (3.0, 3.0), 90.0),
    ):  # fmt: skip
        assert history.do(edit) is None
    from pathlib import Path
    from tomllib import loads

    from planner.script.scene import Sheet

    text = text_of(history.document)
    again = document_of(reading.checked(Path("x.toml"), loads(text), Sheet))
    assert again == history.document and text_of(again, text) == text
    assert sheet_of(again) == sheet_of(history.document)


def test_a_print_of_a_bent_path_keeps_what_hands_did():
    history = begun(new_document())
    history.do(paths.DrawPath(0, ((1.0, 2.0), (7.0, 2.0)), 0.5))
    history.do(edits.Move((Spot(0, 6),), (0.03, 0.2)))
    assert history.document.tracks[0].path[0].moved[0].offset == pytest.approx((0.03, 0.2))
    straight = footprint_at(history.document, Spot(0, 6)).position
    history.do(paths.BendPath(0, 0, 1, (1.0, 8.0)))
    bent = footprint_at(history.document, Spot(0, 6)).position
    history.do(paths.BendPath(0, 0, 1, (7.0, 2.0)))
    assert footprint_at(history.document, Spot(0, 6)).position == straight
    np.testing.assert_allclose(np.array(bent) - (1.0, 2.0), [-(straight[1] - 2.0), straight[0] - 1.0], atol=1e-9)


def test_keys_go_with_their_footprints():
    history = walk(6)
    history.do(shapes.AddShape(0, Key(bone="hand_left", footprint=4, rotation_deg=(10.0, 0.0, 0.0))))
    history.do(shapes.AddShape(0, Stretch(first=3, last=5, gravity=0.5)))
    history.do(edits.Delete((Spot(0, 3),)))
    track = history.document.tracks[0]
    assert track.key[0].footprint == 3 and (track.stretch[0].first, track.stretch[0].last) == (3, 4)
    history.do(edits.Delete((Spot(0, 3),)))
    assert history.document.tracks[0].key == ()


def test_what_cannot_be_done_is_said_and_changes_nothing():
    history = walk(3)
    before = history.document
    for edit in (edits.Set((Spot(0, 1),), "stance_time", -1.0), edits.Delete((Spot(0, 9),)), groups.Splice(0, 1)):
        said = history.do(edit)
        assert said and history.document is before
