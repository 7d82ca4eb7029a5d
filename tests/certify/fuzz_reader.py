"""Fuzz the reader of robot files with atheris: any bytes give a robot or an InputError.

    python tests/certify/fuzz_reader.py CORPUS_FOLDER -max_total_time=600

needs ``pip install atheris`` beside robodyn. The corpus may begin empty; arguments are those of libFuzzer.
"""

from __future__ import annotations

import contextlib
import sys
from pathlib import Path

import atheris  # type: ignore[import-not-found, import-untyped, unused-ignore]

with atheris.instrument_imports(include=["robodyn"]):
    from robodyn.certify.plan import with_ranges
    from robodyn.errors import InputError
    from robodyn.robot import bundled_names, bundled_text, read_text, starter, to_yaml
    from robodyn.robot.reader import read_bytes

#: Words that mutation takes long to find.
WORDS = """name links joint revolute prismatic alpha a d theta mass com inertia xx yy zz xy motor_inertia
limits position velocity acceleration torque confidence unknown gear ratio friction viscous coulomb effects
effect gravity compare convention sdh torque_side link motor smooth exact friction_at_rest dead_band spring
stiffness payload efficiency transmission_loss m_tool pi qd qdd""".split()  # noqa: SIM905 (it reads as the list that it is)


def one(data: bytes) -> None:
    """One robot file, and the same as ranges."""
    try:
        robot = read_bytes(data, "f.yaml", warn=lambda _: None)
    except InputError as error:
        told = str(error)
        assert "\n" not in told
        assert told.startswith("f.yaml"), told
    else:
        again = read_text(to_yaml(robot), warn=lambda _: None)
        assert again.n == robot.n
    with contextlib.suppress(InputError):
        with_ranges(PUMA, data.decode("utf-8", "replace"))


def seeds(folder: Path) -> None:
    """Begin the corpus with robots that there are."""
    for name in bundled_names():
        (folder / f"{name}.yaml").write_text(bundled_text(name), encoding="utf-8")
    (folder / "starter.yaml").write_text(starter("arm", 3), encoding="utf-8")
    (folder / "ranges.txt").write_text("q=-pi/2:pi/2,qd=6,qdd2=3", encoding="utf-8")
    quoted = "".join(f'"{word}"\n' for word in WORDS)
    (folder.parent / "words.txt").write_text(quoted, encoding="utf-8")


if __name__ == "__main__":
    PUMA = read_text(bundled_text("puma560"), warn=lambda _: None)
    place = Path(sys.argv[1])
    place.mkdir(parents=True, exist_ok=True)
    seeds(place)
    atheris.Setup([*sys.argv, f"-dict={place.parent / 'words.txt'}"], one)
    atheris.Fuzz()
