"""What the formats share: texts from templates, the README, archives."""

from __future__ import annotations

import io
import zipfile
from collections.abc import Mapping
from typing import Any, Final

from robodyn.emit.head import head_of
from robodyn.emit.languages.c import LANGUAGE as C
from robodyn.emit.markdown import Markdown, markdown_environment
from robodyn.emit.render import environment
from robodyn.packages.format import NOT_STATED, Files, Package
from robodyn.robot.account import account_lines

#: How the sentence begins by which a second run knows a file again (:mod:`robodyn.outputs`).
MARK: Final = "Written by robodyn"
#: The oldest date that an archive can have: no clock is in what we write.
_DATE: Final = (1980, 1, 1, 0, 0, 0)


def rendered(package: Package, templates: Mapping[str, str], **more: Any) -> dict[str, str]:
    """The ``templates`` of the package's format, ``templates/package/FORMAT``, by path of the file that each
    makes; in a path ``NAME`` is the robot's name. They are told :func:`context`, and ``more``."""
    values = {**context(package), **more}
    folder = f"package/{package.format.name}"
    name = package.robot.name
    texts = {path: environment().get_template(f"{folder}/{file}") for path, file in templates.items()}
    return {path.replace("NAME", name): template.render(values) for path, template in texts.items()}


def context(package: Package) -> dict[str, Any]:
    """What all templates of packages are told."""
    robot, title = package.robot, package.format.title
    names = (
        "version", "license", "maintainer", "scalar", "libm", "routines", "arrays", "parameters", "states",
    )  # fmt: skip
    return {
        **{name: getattr(package, name) for name in names},
        "name": robot.name,
        "package": package.name,
        "prefix": package.name.upper(),
        "contact": package.maintainer or NOT_STATED,
        "n": len(robot.commanded),
        "account": list(account_lines(robot)),
        "head": head_of(robot, [f"{title[:1].upper()}{title[1:]}."]),
    }


def sources(package: Package, headers: str = "src", tests: str = "test") -> dict[str, str]:
    """The kernel in ``src``, its headers in the folder ``headers``, the programs that test it in ``tests``:
    text by path."""
    kernel = package.kernel().items()
    placed = {f"{headers if path.endswith('.h') else 'src'}/{path}": text for path, text in kernel}
    return placed | {f"{tests}/{path}": text for path, text in package.tests().items()}


def arithmetic_flags(package: Package) -> tuple[str, ...]:
    """The flags with which gcc and clang leave arithmetic as it is written, with those of the target that was
    asked for. How far the rest is optimised is the affair of whoever builds it."""
    options = package.generated.options
    target, compiled = options.profile, C.compiled
    assert compiled is not None
    flags = compiled.flags if target is None else target.compiled(options.contraction or "off").split()
    return tuple(flag for flag in flags if not flag.startswith(("-std", "-O")))


def readme(package: Package, **more: Any) -> dict[str, str]:
    """``README.md``: what the package has, and the format's own ``use.md.j2`` on how it is used."""
    template = markdown_environment().get_template("package/README.md.j2")
    fixed = {key: Markdown(value) for key, value in context(package).items() if key in _IDENTIFIERS}
    values = {
        **context(package),
        **fixed,
        "title": package.robot.title or "a serial arm",
        "kind": package.format.title,
        "tool": package.format.tool,
        "options": package.generated.options.text,
        "use": f"package/{package.format.name}/use.md.j2",
        **more,
    }
    return {"README.md": template.render(values)}


#: Need no escape in Markdown, and stand in code.
_IDENTIFIERS: Final = ("name", "package", "prefix", "version", "scalar")


def zipped(files: Files) -> bytes:
    """``files`` as a zip archive: the same bytes from the same files, in the order given. Nothing in it is
    compressed, because one zlib's result is not another's."""
    archive = io.BytesIO()
    with zipfile.ZipFile(archive, "w", zipfile.ZIP_STORED) as target:
        target.comment = MARK.encode("ascii")
        for path, content in files.items():
            entry = zipfile.ZipInfo(path, _DATE)
            entry.create_system = 3  # Unix, wherever this runs
            entry.external_attr = 0o644 << 16
            target.writestr(entry, content)
    return archive.getvalue()
