"""Who races: our kernels, and the peers that can be had here."""

from __future__ import annotations

import subprocess
import sys
import sysconfig
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path

from benchmarks.peers.building import (
    AVX2,
    NATIVE,
    STRICT,
    Lacking,
    Source,
    library,
    package_folder,
    program,
    version,
)
from benchmarks.peers.numbers_in_c import text_of

from robodyn.bench.peers.numbers import Numbers


@dataclass(frozen=True, slots=True)
class Candidate:
    """A runner: ``timed`` is raced, in ``counted`` instructions are counted (None: they are not)."""

    key: str
    title: str
    flags: str
    timed: Path
    counted: Path | None
    ours: bool = False
    single: bool = False
    note: str = ""


@dataclass(frozen=True, slots=True)
class Missing:
    """A peer that does not race, and why."""

    key: str
    title: str
    why: str


Maker = Callable[[Numbers, Path], Candidate]
_CXX = ("-std=c++17",)
#: Without it Eigen checks every access: release builds have it, the wheel of Pinocchio too.
_RELEASE = ("-std=c++17", "-DNDEBUG")
_MPL = (
    "-DBOOST_MPL_LIMIT_LIST_SIZE=30",
    "-DBOOST_MPL_LIMIT_VECTOR_SIZE=30",
    "-DBOOST_MPL_CFG_NO_PREPROCESSED_HEADERS",
    "-DBOOST_FUSION_INVOKE_MAX_ARITY=12",
)


def pinocchio(arm: Numbers, folder: Path) -> Candidate:
    """Pinocchio's rnea, compiled from its headers with the flags that everything is compiled with."""
    source = Source(("pinocchio.cpp",), (*_RELEASE, *pinocchio_headers()), packages=("pin", "cmeel-eigen"))
    title = f"Pinocchio {version('pin')}, rnea, C++"
    return both("pinocchio", title, source, folder)


def pinocchio_checked(arm: Numbers, folder: Path) -> Candidate:
    """The same without ``-DNDEBUG``, as who forgets it has it: Eigen checks sizes all the time."""
    source = Source(("pinocchio.cpp",), (*_CXX, *pinocchio_headers()), packages=("pin", "cmeel-eigen"))
    compiled = library(folder / "pinocchio-checked.so", source, NATIVE)
    title = f"Pinocchio {version('pin')}, rnea, C++, without -DNDEBUG"
    return Candidate("pinocchio-checked", title, " ".join(NATIVE), compiled, None)


def pinocchio_wheel(arm: Numbers, folder: Path) -> Candidate:
    """Pinocchio's rnea as it lies compiled in the wheel."""
    prefix = package_folder("libpinocchio", "cmeel.prefix")
    flags = (*_RELEASE, *pinocchio_headers(), "-DPINOCCHIO_ENABLE_TEMPLATE_INSTANTIATION")
    links = (f"-L{prefix / 'lib'}", "-lpinocchio_default", f"-Wl,-rpath,{prefix / 'lib'}")
    source = Source(("pinocchio.cpp",), flags, links, packages=("pin", "cmeel-eigen"))
    compiled = library(folder / "pinocchio-wheel.so", source, ("-O3",))
    title = f"Pinocchio {version('pin')}, rnea, as in the wheel"
    return Candidate("pinocchio-wheel", title, "its own", compiled, compiled)


def pinocchio_casadi(arm: Numbers, folder: Path) -> Candidate:
    """Pinocchio's rnea run over CasADi's SX, and the C that CasADi writes."""
    return _through_casadi(folder, "pinocchio_casadi", "", "Pinocchio -> CasADi C")


def pinocchio_casadi_cse(arm: Numbers, folder: Path) -> Candidate:
    """The same after ``casadi.cse``."""
    return _through_casadi(folder, "pinocchio_casadi_cse", "_cse", "Pinocchio -> CasADi C, after casadi.cse")


def _through_casadi(folder: Path, name: str, cse: str, title: str) -> Candidate:
    pinocchio_traced(folder, ("inverse_dynamics",), folder.parent)
    called = f"pinocchio_inverse_dynamics{cse}"
    source = Source(("casadi.c", folder / f"{called}.c"), defines=(("FUNCTION", called),))
    return both(name, f"{title} {version('casadi')}", source, folder, STRICT)


def pinocchio_traced(folder: Path, functions: Iterable[str], work: Path) -> None:
    """Pinocchio's algorithms run over CasADi's SX for the arm of ``folder``: there is then the C that CasADi
    writes, ``pinocchio_NAME.c`` and after its cse ``pinocchio_NAME_cse.c``, and ``pinocchio_NAME.casadi``.
    What traces them is compiled in ``work``.

    Raises
    ------
    Lacking: it cannot be had here.
    """
    casadi = package_folder("casadi", "casadi")
    source = Source(
        ("pinocchio_casadi.cpp",),
        (*_CXX, *pinocchio_headers(), f"-I{casadi / 'include'}"),
        (f"-L{casadi}", "-lcasadi", f"-Wl,-rpath,{casadi}"),
        packages=("pin", "casadi", "cmeel-eigen"),
    )
    writer = program(work / "pinocchio-to-casadi", source, ("-O0",))
    command = [str(writer), str(folder), *functions]
    done = subprocess.run(command, cwd=folder, capture_output=True, check=False)
    if done.returncode:
        raise Lacking(f"the program that traces Pinocchio fails: {done.stderr[-200:]!r}")


def pinocchio_headers() -> tuple[str, ...]:
    """What compilers need to find Pinocchio's headers, and to get through them."""
    prefix = package_folder("libpinocchio", "cmeel.prefix/include")
    eigen = package_folder("cmeel-eigen", "cmeel.prefix/include/eigen3")
    return *_MPL, f"-I{prefix}", f"-I{eigen}"


def casadi_sx(arm: Numbers, folder: Path) -> Candidate:
    """The textbook's recursion over CasADi's SX, equal nodes merged."""
    version("casadi")
    _written(arm, folder, "casadi", "casadi_sx.c")
    source = Source(("casadi.c", folder / "casadi_sx.c"), defines=(("FUNCTION", "casadi_sx"),))
    return both("casadi-sx", f"CasADi {version('casadi')} SX, textbook", source, folder, STRICT)


def symforce(arm: Numbers, folder: Path) -> Candidate:
    """The textbook's recursion through SymForce."""
    title = f"SymForce {version('symforce')}, textbook"
    _written(arm, folder / "symforce", "symforce", "generated.h")
    eigen = package_folder("cmeel-eigen", "cmeel.prefix/include/eigen3")
    flags = (*_RELEASE, f"-I{eigen}", f"-I{folder / 'symforce'}")
    source = Source(("symforce.cpp",), flags, defines=(("JOINTS", str(arm.n)), _stamp(folder / "symforce")))
    return both("symforce", title, source, folder)


def wrenfold(arm: Numbers, folder: Path) -> Candidate:
    """The textbook's recursion through wrenfold."""
    title = f"wrenfold {version('wrenfold')}, textbook"
    _written(arm, folder / "wrenfold", "wrenfold", "generated.h")
    flags = (*_RELEASE, f"-I{folder / 'wrenfold'}")
    source = Source(("wrenfold.cpp",), flags, defines=(("JOINTS", str(arm.n)), _stamp(folder / "wrenfold")))
    return both("wrenfold", title, source, folder)


def mujoco(arm: Numbers, folder: Path) -> Candidate:
    """MuJoCo's mj_inverse, from the library in the wheel."""
    place = package_folder("mujoco", "mujoco")
    _written(arm, folder, "mujoco", "arm.mjb")
    shared = next(iter(sorted(place.glob("libmujoco.so*"))), None)
    if shared is None:
        raise Lacking("the wheel of mujoco has no libmujoco.so")
    links = (str(shared), f"-Wl,-rpath,{place}")
    source = Source(("mujoco.c",), (f"-I{place / 'include'}",), links, packages=("mujoco",))
    note = "factors the mass matrix on its way"
    return both("mujoco", f"MuJoCo {version('mujoco')}, mj_inverse", source, folder, AVX2, note)


def kdl(arm: Numbers, folder: Path) -> Candidate:
    """KDL's ChainIdSolver_RNE, from the system."""
    header = next(
        (p for p in (Path("/usr/include"), Path("/usr/local/include")) if (p / "kdl").is_dir()), None
    )
    if header is None:
        raise Lacking("KDL's headers are not there: apt-get install liborocos-kdl-dev")
    source = Source(("kdl.cpp",), (*_RELEASE, f"-I{header / 'eigen3'}"), ("-lorocos-kdl",))
    return both("kdl", f"KDL {_kdl_version(header)}, ChainIdSolver_RNE", source, folder)


def _kdl_version(header: Path) -> str:
    config = header / "kdl" / "config.h"
    for line in config.read_text().splitlines() if config.is_file() else ():
        if line.startswith("#define KDL_VERSION_STRING"):
            return line.split('"')[1]
    return ""


def toolbox(arm: Numbers, folder: Path) -> Candidate:
    """The Robotics Toolbox's ne.c, compiled from the sources in its wheel."""
    place = package_folder("roboticstoolbox-python", "roboticstoolbox/robot/cpp-extensions")
    include = sysconfig.get_path("include")
    if not (Path(include) / "Python.h").is_file():
        raise Lacking("ne.c includes Python.h, which is not there: apt-get install python3-dev")
    files = ("toolbox.c", place / "ne.c", place / "vmath.c")
    source = Source(files, (f"-I{place}", f"-I{include}"), packages=("roboticstoolbox-python",))
    title = f"Robotics Toolbox {version('roboticstoolbox-python')}, ne.c"
    return both("toolbox", title, source, folder)


MAKERS: dict[str, tuple[str, Maker]] = {
    "pinocchio": ("Pinocchio, rnea, C++", pinocchio),
    "pinocchio-checked": ("Pinocchio, rnea, C++, without -DNDEBUG", pinocchio_checked),
    "pinocchio-wheel": ("Pinocchio, rnea, as in the wheel", pinocchio_wheel),
    "pinocchio_casadi": ("Pinocchio -> CasADi C", pinocchio_casadi),
    "pinocchio_casadi_cse": ("Pinocchio -> CasADi C, after casadi.cse", pinocchio_casadi_cse),
    "casadi-sx": ("CasADi SX, textbook", casadi_sx),
    "symforce": ("SymForce, textbook", symforce),
    "wrenfold": ("wrenfold, textbook", wrenfold),
    "mujoco": ("MuJoCo, mj_inverse", mujoco),
    "kdl": ("KDL, ChainIdSolver_RNE", kdl),
    "toolbox": ("Robotics Toolbox, ne.c", toolbox),
}


def peers(arm: Numbers, folder: Path, keys: tuple[str, ...] = tuple(MAKERS)) -> Iterator[Candidate | Missing]:
    """Each peer, set up for ``arm`` in ``folder``, or the reason why it does not race."""
    for key in keys:
        title, make = MAKERS[key]
        print(f"setting up {title}", file=sys.stderr)
        try:
            yield make(arm, folder)
        except Lacking as lacking:
            yield Missing(key, title, str(lacking))


def both(
    key: str,
    title: str,
    source: Source,
    folder: Path,
    counted: tuple[str, ...] = AVX2,
    note: str = "",
) -> Candidate:
    """Timed with :data:`~benchmarks.peers.building.NATIVE`, counted in another build."""
    timed = library(folder / f"{key}.so", source, NATIVE)
    other = library(folder / f"{key}-counted.so", source, counted)
    return Candidate(key, title, " ".join(NATIVE), timed, other, note=note)


def _written(arm: Numbers, folder: Path, tool: str, wanted: str) -> None:
    """Have ``tool`` write its code, in a process of its own: some cannot share one."""
    folder.mkdir(parents=True, exist_ok=True)
    path = folder / wanted
    text = text_of(arm)
    stamp = path.with_suffix(".arm")
    if path.is_file() and stamp.is_file() and stamp.read_text() == text:
        return
    command = [sys.executable, "-m", "benchmarks.peers.generators", tool, str(folder)]
    done = subprocess.run(command, input=text, text=True, capture_output=True, check=False)
    if done.returncode or not path.is_file():
        raise Lacking(f"{tool} does not generate: {(done.stderr.strip().splitlines() or ['?'])[-1]}")
    stamp.write_text(text)


def _stamp(folder: Path) -> tuple[str, str]:
    """Compile again where the generated header is another."""
    import hashlib

    return "STAMP", hashlib.sha256((folder / "generated.h").read_bytes()).hexdigest()[:16]
