"""A renderer for the pictures of these tests, where there is OpenGL."""

import pytest

from sim.view.graphics import gl
from tests.view.studio_hand import hand, window  # noqa: F401  (fixtures)


@pytest.fixture(scope="module")
def picture():
    from sim.view.graphics.quality import Quality
    from sim.view.pictures.offscreen import Picture

    try:
        return Picture((320, 180), Quality(512, 1, 0, 1.0))
    except gl.NoGL as error:
        pytest.skip(str(error))
