"""cargo: the crate that ``gen`` writes, with a version and a README."""

from __future__ import annotations

from robodyn.emit.languages.rust import LANGUAGE as RUST
from robodyn.emit.languages.rust import crate_name
from robodyn.packages.format import Files, Format, Package
from robodyn.packages.writing import readme, rendered


def _files(package: Package) -> Files:
    own = RUST.context(package.generated.unit)
    manifest = rendered(package, {"Cargo.toml": "Cargo.toml.j2"}, **own)
    return {**readme(package, libm=own["libm"]), **package.kernel(), **manifest}


FORMAT = Format(
    name="crate",
    title="a crate",
    tool="cargo, with Rust 1.59 or newer",
    language=RUST,
    files=_files,
    take="cargo add --path {folder}",
    called=crate_name,
)
