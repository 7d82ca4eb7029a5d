"""The simulation engine of the folder ``c``, compiled together with the functions of a mechanical system.

::

    engine = build_engine(glue)
    record = engine.run(y, v, z, control=Control.pd(...), duration=2.0, sample_period=1e-3)
    record.y, record.v, record.a, record.applied, record.status

``glue`` is C text: macros for the sizes, and the static functions by which the engine calls the system; see
``c/system.h``. :class:`~robodyn.simulate.control.Control` says what drives the motors, :class:`Record` what
comes back. A run of no duration gives the acceleration and the directions of the dry friction at its start.

Two methods: ``rk4`` of fixed steps ends a step where an element of dry friction comes to rest, and lets go of
one that sticks where a step starts; ``adaptive`` (Dormand and Prince 5(4)) ends its steps on both.
"""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from importlib.resources import files as resources
from pathlib import Path
from typing import Any, Final, Literal

import numpy as np
from numpy.typing import ArrayLike

from robodyn.arrays import Floats
from robodyn.errors import InputError, ToolError
from robodyn.simulate.control import LINEAR_TABLE, Control
from robodyn.toolchain.cache import Cache, content_key
from robodyn.toolchain.compiler import C_FLAGS, find_c

Method = Literal["rk4", "adaptive"]

#: Tolerances of adaptive steps unless others are named: relative, and absolute [rad, m and their rates].
RTOL: Final = 1e-8
ATOL: Final = 1e-10
_COUNTERS = ("steps", "rejected", "evaluations", "events", "iterations")
_METHODS = ("rk4", "adaptive")
_CHUNK = 0.05  # s between two looks at what Python has to do

#: What a run ended with, by the engine's own number.
STATUSES = ("done", "not finite", "no acceleration", "too many steps", "step too small", "interrupted")


@dataclass(frozen=True, slots=True)
class Record:
    """What a run gave at its S samples, as far as it came; SI units.

    ``t`` [S]; coordinates ``y`` [S, n], their velocities ``v`` and accelerations ``a``; internal states ``z``
    [S, k]; directions ``s`` [S, elements] of the dry friction, -1 or 1 sliding, 0 stuck; torques [S, motors]
    as the control gave them, ``command``, and as the drives did, ``applied``; ``work`` [S] of the torques and
    ``loss`` to what the system's ``conserved`` leaves out [J], 0 where it has none. ``status``: one of
    :data:`STATUSES`; ``time``: where the run ended [s]; ``counters``: steps, rejected, evaluations of the
    acceleration, events, iterations of Newton's method.

    A sample at an instant of the control is taken after it: ``a``, ``s`` and the torques are those from
    there on.
    """

    t: Floats
    y: Floats
    v: Floats
    a: Floats
    z: Floats
    s: Floats
    command: Floats
    applied: Floats
    work: Floats
    loss: Floats
    status: str
    time: float
    counters: Mapping[str, int]


@dataclass(frozen=True, slots=True)
class Engine:
    """A compiled system of ``n`` coordinates, ``elements`` of dry friction, ``states``, ``parameters``."""

    ffi: Any
    library: Any
    path: Path
    n: int
    elements: int
    states: int
    parameters: int
    conserved: bool
    model: bool

    def run(
        self,
        y: ArrayLike,
        v: ArrayLike,
        z: ArrayLike = (),
        *,
        duration: float,
        sample_period: float,
        control: Control | None = None,
        method: Method = "rk4",
        step: float | None = None,
        rtol: float = RTOL,
        atol: float = ATOL,
        breaks: Sequence[float] = (),
        parameters: ArrayLike = (),
        progress: Callable[[float], object] | None = None,
        max_steps: int = 50_000_000,
    ) -> Record:
        """Simulate from ``y`` [n], ``v`` [n], ``z`` [states] at t = 0.

        ``step`` [s] is the length of the fixed steps (default: ``sample_period``), or the longest of the
        adaptive ones (default: ten times that): while everything is stuck, nothing else keeps them short.
        ``rtol`` and ``atol`` are the adaptive method's, of y, v and z alike. ``breaks`` [s] are the times at
        which the system's external forces jump. ``progress`` is called every now and then with the time
        reached. The last sample is the last that ``duration`` has room for. No control is no torque. Ctrl-C
        ends the run with the status "interrupted" and keeps what there is.

        Raises
        ------
        InputError: an array of the wrong shape or with a number that is not finite, a period that is not
            positive.
        Exception: what ``progress`` raises.
        """
        plan = control if control is not None else Control.none()
        self._check(plan, method)
        for name, value in (("duration", duration), ("sample_period", sample_period), ("step", step)):
            if value is not None and not (0 < value < math.inf or (name == "duration" and value == 0)):
                raise InputError(f"{name} is not a time", found=f"{value}", expected="a positive number")
        new = self.ffi.new
        kept: list[Any] = []

        def pointer(values: Floats) -> Any:
            kept.append(values)
            return self.ffi.from_buffer("double[]", values)

        settings = new("settings *")
        settings.method = _METHODS.index(method)
        settings.step = step if step is not None else sample_period * (1 if method == "rk4" else 10)
        settings.rtol, settings.atol = rtol, atol
        settings.duration, settings.sample_period, settings.max_steps = duration, sample_period, max_steps
        settings.y, settings.v = pointer(_read("y", y, self.n)), pointer(_read("v", v, self.n))
        settings.z = pointer(_read("z", z, self.states))
        settings.parameters = pointer(_read("parameters", parameters, self.parameters))
        times = np.sort(_read("breaks", breaks, len(breaks)))
        settings.breaks, settings.break_count = pointer(times), len(times)
        motors = plan.motors
        settings.control, settings.motors, settings.period = plan.kind, motors, min(plan.period, 1e300)
        for name in ("place", "seen"):
            places = new("int[]", list(getattr(plan, name)))
            kept.append(places)
            setattr(settings, name, places)
        settings.rows = plan.rows
        for name in ("torque", "q", "qd", "qdd", "kp", "kd"):
            setattr(settings, name, pointer(getattr(plan, name)))
        settings.limit = self.ffi.NULL if plan.limit is None else pointer(plan.limit)
        samples = math.floor(duration / sample_period + 1e-9) + 1
        width = 1 + 3 * self.n + self.states + self.elements + 2 * motors + 2
        rows = np.empty((samples, width))
        settings.record = pointer(rows)
        run = self.library.run_new(settings)
        if run == self.ffi.NULL:
            raise MemoryError
        state = self.ffi.gc(run, self.library.run_free)
        status = self._advance(state, samples, progress)
        return self._record(state, rows, motors, status)

    def model_torques(self, q: Floats, qd: Floats, qdd: Floats, parameters: ArrayLike = ()) -> Floats:
        """Torques [K, motors] of the system's model (N m or N) along ``q, qd, qdd`` [K, motors].

        Raises
        ------
        InputError: the system was compiled without a model.
        """
        arrays = [np.ascontiguousarray(x, np.float64) for x in (q, qd, qdd)]
        tau = np.empty_like(arrays[0])
        view = [self.ffi.from_buffer("double[]", x) for x in (*arrays, tau)]
        values = _read("parameters", parameters, self.parameters)
        rows, motors = arrays[0].shape
        if self.library.model_torques(rows, *view, motors, self.ffi.from_buffer("double[]", values)):
            raise InputError("this system was compiled without a model")
        return tau

    def _advance(self, state: Any, samples: int, progress: Callable[[float], object] | None) -> int:
        """Run in parts of about the same time; the status."""
        library, part = self.library, 100
        try:
            while library.run_recorded(state) < samples:
                begun = time.perf_counter()
                status = int(library.run_advance(state, part))
                if status:
                    return status
                if progress is not None:
                    progress(library.run_time(state))
                spent = time.perf_counter() - begun
                part = max(1, min(2 * part if spent < _CHUNK else part // 2, 1 << 24))
        except KeyboardInterrupt:
            return STATUSES.index("interrupted")
        return 0

    def _record(self, state: Any, rows: Floats, motors: int, status: int) -> Record:
        count = int(self.library.run_recorded(state))
        widths = [1, self.n, self.n, self.n, self.states, self.elements, motors, motors, 1, 1]
        columns = np.split(rows[:count], np.cumsum(widths)[:-1], axis=1)
        t, *middle, work, loss = [np.ascontiguousarray(part) for part in columns]
        y, v, a, z, s, command, applied = middle
        end = float(self.library.run_time(state))
        counted = {name: int(self.library.run_counter(state, k)) for k, name in enumerate(_COUNTERS)}
        return Record(
            t.ravel(), y, v, a, z, s, command, applied, work.ravel(), loss.ravel(),
            STATUSES[status], end, counted,
        )  # fmt: skip

    def _check(self, plan: Control, method: str) -> None:
        if method not in _METHODS:
            raise InputError("there is no such method", found=repr(method), expected=" or ".join(_METHODS))
        if plan.motors > self.n or any(k >= self.n for k in (*plan.place, *plan.seen)):
            raise InputError(
                "the control has motors that the system does not",
                found=f"coordinates {max((*plan.place, *plan.seen)) + 1}, {plan.motors} motors",
                expected=f"at most {self.n}",
            )
        if plan.model and not self.model:
            raise InputError("this system was compiled without a model for computed torque")
        if plan.kind == LINEAR_TABLE and plan.rows > 1 and not math.isfinite(plan.period):
            raise InputError("a table between whose rows is interpolated needs a period")


def engine_files() -> dict[str, str]:
    """The engine's own C: text by path in a folder ``engine``. ``engine.c`` is what Python calls; other
    programs include ``advance.h``. The glue is ``engine_glue.h``, in that folder or an include folder."""
    home = resources("robodyn.simulate").joinpath("c")
    items = sorted(
        (item for item in home.iterdir() if item.name.endswith((".c", ".h"))), key=lambda i: i.name
    )
    return {f"engine/{item.name}": item.read_text(encoding="utf-8") for item in items}


def build_engine(
    glue: str, *, cc: str | None = None, flags: Sequence[str] = C_FLAGS, cache: Path | None = None
) -> Engine:
    """Compile the engine with ``glue``, C text. Found in the cache if it is there.

    Raises
    ------
    ToolError: no C compiler, or it refuses.
    """
    import cffi

    texts = {**engine_files(), "engine_glue.h": glue}
    compiler = find_c(cc)

    def build(folder: Path) -> str:
        for path, text in texts.items():
            target = folder / path
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_text(text, encoding="utf-8", newline="\n")
        compiled = compiler.compile("engine/engine.c", flags=(*flags, "-I."), folder=folder)
        compiler.link([compiled], "engine.so", flags=tuple(flags), folder=folder, extension=False)
        return "engine.so"

    key = content_key(["engine", texts, compiler.command, compiler.identity, *flags])
    try:
        path = Cache(cache).fetch(key, build)
    except OSError as error:
        raise ToolError(
            "the compiled engine cannot be stored",
            found=f"{error.filename}: {error.strerror or error}",
            remedy="set ROBODYN_CACHE to a folder that can be written",
        ) from None
    ffi = cffi.FFI()
    declared = texts["engine/settings.h"].partition("start here */")[2].partition("/* declarations")[0]
    ffi.cdef(declared)
    library: Any = ffi.dlopen(str(path))
    n, elements, states, parameters, conserved, model = (int(library.engine_size(k)) for k in range(6))
    return Engine(ffi, library, path, n, elements, states, parameters, bool(conserved), bool(model))


def _read(name: str, values: ArrayLike, length: int) -> Floats:
    try:
        array = np.array(values, dtype=np.float64).reshape(-1)
    except (TypeError, ValueError) as error:
        raise InputError(f"{name} is not an array of numbers", found=str(error)) from None
    if len(array) != length:
        raise InputError(f"{name} has the wrong length", found=f"{len(array)}", expected=f"{length}")
    if not np.isfinite(array).all():
        raise InputError(f"{name} has a number that is not finite", found=f"{array.tolist()}")
    return array
