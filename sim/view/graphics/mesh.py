"""A mesh on the graphics side: vertices, indices, and rows that it is drawn once for. Buffers are kept and reused."""

import moderngl
import numpy as np


class Mesh:
    """Triangles of one layout, as ("3f 3f", "in_position", ...); with a row layout, drawn once per row (instanced)."""

    def __init__(
        self, ctx: moderngl.Context, layout: tuple, vertices: np.ndarray, indices: np.ndarray, row_layout: tuple | None = None
    ) -> None:
        self.ctx, self.layout, self.row_layout = ctx, layout, row_layout
        self._vertices = ctx.buffer(np.ascontiguousarray(vertices, "f4"))
        self._indices = ctx.buffer(np.ascontiguousarray(indices, "i4"))
        self._rows: moderngl.Buffer | None = None
        self._arrays: dict[tuple[int, int], moderngl.VertexArray] = {}
        self.count = 0
        self._chosen = -1  # corners that are drawn; -1: all

    def write(self, rows: np.ndarray, at: int = 0, keep: int = 0) -> None:
        """Puts rows (N, ...) float32 at row `at`; `keep` rows before them outlive a buffer that had to grow."""
        size = (at + len(rows)) * rows[:1].nbytes
        if self._rows is None or size > self._rows.size:
            self._grow(2 * size, keep * rows[:1].nbytes)
        assert self._rows is not None
        if len(rows):
            self._rows.write(np.ascontiguousarray(rows), offset=at * rows[:1].nbytes)
        self.count = max(keep, at + len(rows))

    def choose(self, indices: np.ndarray) -> None:
        """Draws these triangles alone, corners (K,), until it is told others."""
        if indices.nbytes > self._indices.size:
            self._indices.release()
            self._indices = self.ctx.buffer(reserve=2 * indices.nbytes, dynamic=True)
            self._forget_arrays()
        self._indices.write(np.ascontiguousarray(indices, "i4"))
        self._chosen = len(indices)

    def _grow(self, size: int, keep: int) -> None:
        old, self._rows = self._rows, self.ctx.buffer(reserve=max(size, 1 << 14), dynamic=True)
        if old:
            if keep:
                self.ctx.copy_buffer(self._rows, old, keep)
            old.release()
        self._forget_arrays()

    def _forget_arrays(self) -> None:
        for array in self._arrays.values():
            array.release()
        self._arrays.clear()

    def draw(self, program: moderngl.Program, shape: "Mesh | None" = None) -> None:
        """Draws it: all rows, or once where it has none; `shape` lends its triangles to the rows."""
        if self.row_layout is None:
            self._array(program, self).render(vertices=self._chosen)
        elif self.count:
            self._array(program, shape or self).render(instances=self.count)

    def _array(self, program: moderngl.Program, shape: "Mesh") -> moderngl.VertexArray:
        key = (program.glo, shape._vertices.glo)
        if key not in self._arrays:
            content = [(shape._vertices, *_used(program, shape.layout))]
            if self.row_layout:
                content.append((self._rows, *_used(program, self.row_layout)))
            self._arrays[key] = self.ctx.vertex_array(program, content, index_buffer=shape._indices)
        return self._arrays[key]

    def release(self) -> None:
        """Gives everything back."""
        self._forget_arrays()
        for buffer in (self._vertices, self._indices, self._rows):
            if buffer:
                buffer.release()


def _used(program: moderngl.Program, layout: tuple) -> tuple:
    """The layout with what the program's compiler dropped left as padding."""
    formats, names = layout[0].removesuffix("/i").split(), layout[1:]
    kept = [name for name in names if name in program]
    padded = [one if name in program else f"{4 * int(one[0])}x" for one, name in zip(formats, names, strict=True)]
    return (" ".join(padded) + ("/i" if layout[0].endswith("/i") else ""), *kept)
