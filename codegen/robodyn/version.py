"""The version, where it is written once: the package's metadata and emitted files take it from here."""

VERSION = "0.1.0"
