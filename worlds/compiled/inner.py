"""Kernels as other kernels call them.

numba makes each kernel whole before its callers are looked at: with an entry for Python, which unpacks tables of dozens of
arrays, optimised with all that it calls, as machine code; its callers then optimise all of that once more. More than half of
the time of a first start went there. Here a kernel that others call is typed and lowered, and no more: whoever is called from
Python, or by its address, links all that it calls and is optimised once, to the same bits. A kernel that is called from both is
lowered twice, which is little.

What is linked so belongs to whoever has linked it: the compiler is told that nobody else calls it, and may hand on what is
asked for alone. A round is a table of some fifty arrays, of which each function reads a few; to write them all down for each
call took a fifth of the time of a crowd.
"""

from collections.abc import Callable
from typing import Any

from llvmlite.binding import Linkage
from numba.core import compiler, registry, sigutils, typing
from numba.core.codegen import JITCodeLibrary
from numba.core.compiler_lock import global_compiler_lock
from numba.core.dispatcher import _FunctionCompiler  # type: ignore[attr-defined]
from numba.core.registry import CPUDispatcher

from worlds.compiled import telling


class _Lowered(JITCodeLibrary):  # type: ignore[misc]
    """Code of one kernel, to be linked into others."""

    def finalize(self) -> None:
        """Leaves the code as it is: optimising it is the business of whoever links it."""
        self._finalized = True

    def linked(self) -> list[Any]:
        """This code and all that it calls, directly or not, each once."""
        found: dict[Any, None] = {self: None}
        for library in self._linking_libraries:
            found |= dict.fromkeys(library.linked() if isinstance(library, _Lowered) else [library])
        return list(found)

    @property
    def names(self) -> list[str]:
        """Of the functions that this code consists of."""
        return [function.name for function in self._final_module.functions if not function.is_declaration]


class _Whole(JITCodeLibrary):  # type: ignore[misc]
    """Code that is called from Python, or by its address, with all that it calls."""

    def _optimize_final_module(self) -> None:
        """Optimises it, the kernels that it has linked as its own: nobody else calls them by their names."""
        names = {name for each in self._linking_libraries if isinstance(each, _Lowered) for name in each.names}
        for function in self._final_module.functions:
            if function.name in names and not function.is_declaration:  # what nobody calls the linker has left out
                function.linkage = Linkage.internal
        super()._optimize_final_module()


registry.cpu_target.target_context.codegen()._library_class = _Whole


class _Lowering(_FunctionCompiler):  # type: ignore[misc]
    """Types and lowers a kernel, without entries for others than kernels."""

    def _customize_flags(self, flags: Any) -> Any:
        flags.no_cpython_wrapper = flags.no_cfunc_wrapper = flags.no_compile = True
        return flags

    def _compile_core(self, args: tuple[Any, ...], return_type: Any) -> Any:
        flags, target = compiler.Flags(), self.targetdescr
        target.options.parse_as_flags(flags, self.targetoptions)
        context = target.target_context
        return compiler.compile_extra(
            target.typing_context, context, self.py_func, args, return_type, self._customize_flags(flags), self.locals,
            library=_Lowered(context.codegen(), self.py_func.__qualname__),
        )  # fmt: skip


class Compiled(CPUDispatcher):  # type: ignore[misc]
    """A kernel; whole for Python, lowered for other kernels."""

    def __init__(self, function: Callable, options: dict[str, Any]) -> None:
        options = {"nopython": True, "boundscheck": None, "no_cfunc_wrapper": True} | options
        super().__init__(function, targetoptions=options)
        self._lowering = _Lowering(function, registry.cpu_target, options, {}, compiler.Compiler)
        self._lowered: dict[tuple[Any, ...], tuple[Any, object]] = {}
        """By types of arguments: the signature, and what stands for the code among the compiler's functions."""

    def get_call_template(self, args: Any, kws: Any) -> Any:
        """What a call by another kernel returns: asked by the compiler, as in numba's own dispatcher."""
        signature, args = self.fold_argument_types(args, kws)
        self._lower(tuple(args))
        name, known = self.py_func.__name__, [each for each, _ in self._lowered.values()]
        return typing.make_concrete_template(f"CallTemplate({name})", key=name, signatures=known), signature, args, {}

    def get_overload(self, sig: Any) -> Any:
        """The code that another kernel calls for this signature: asked by the compiler."""
        return self._lowered[tuple(sigutils.normalize_signature(sig)[0])][1]

    def _lower(self, args: tuple[Any, ...]) -> None:
        """Lowers the kernel for these types, where it is not yet."""
        with global_compiler_lock, self._compiling_counter, telling.compiling():
            if args in self._lowered:
                return
            made, token = self._lowering.compile(args, None), object()
            self.targetctx.insert_user_function(token, made.fndesc, made.library.linked())
            self._lowered[args] = made.signature, token
