"""How processes of two machines know that they may trust each other."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Security:
    """The files, in PEM, by which a scheduler and who asks it know each other: the certificate of the
    ``authority`` that both trust, the ``certificate`` of who asks and its ``key`` (empty: it stands in the
    certificate's file)."""

    authority: str
    certificate: str
    key: str = ""
