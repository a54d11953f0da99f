"""OpenGL contexts, and the one place where their absence is noticed."""

import os

import moderngl

HINT = "3D needs OpenGL; on Debian or Ubuntu: apt-get install libegl1 libgl1 libgl1-mesa-dri"


class NoGL(RuntimeError):
    """There is no OpenGL here; the message says what to install."""


def offscreen_context() -> moderngl.Context:
    """A context without a window. Raises NoGL."""
    try:
        return moderngl.create_standalone_context(require=330, backend="egl")  # type: ignore[arg-type]
    except Exception as error:  # moderngl raises bare Exception where libraries are missing
        try:
            return moderngl.create_standalone_context(require=330)
        except Exception:
            raise NoGL(f"{HINT} ({error})") from None


def window_context() -> moderngl.Context:
    """The context of the pygame window that is open. Raises NoGL."""
    try:
        return moderngl.create_context(require=330)
    except Exception as error:  # as above
        raise NoGL(f"{HINT} ({error})") from None


def prefer_egl_without_display() -> None:
    """Lets PyOpenGL, which the panel uses, find the same library as SDL's offscreen driver."""
    if os.environ.get("SDL_VIDEODRIVER") == "offscreen":
        os.environ.setdefault("PYOPENGL_PLATFORM", "egl")
