"""What is to be known of a robot that was read from a file in another format, beyond its numbers."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, fields
from typing import Any, Final, Protocol

from robodyn.robot.origins import LinkWithOrigins, origins_in_words, origins_to_dicts

#: The parts of an :class:`Account` that are lines of text.
PARTS: Final = {
    "warnings": "What the format does not allow and was read all the same, with the places.",
    "left_out": "What changes torques, and was left out as --without said.",
    "decided": "How the arm was taken out of the file: joints that are locked, limits left out.",
    "not_used": "What the file says beyond, with the places.",
}


@dataclass(frozen=True, slots=True)
class Account:
    """What the reading of ``file``, in that ``format``, came upon; :data:`PARTS` says what each of the others
    holds, in lines of text."""

    file: str
    format: str
    warnings: tuple[str, ...] = ()
    left_out: tuple[str, ...] = ()
    decided: tuple[str, ...] = ()
    not_used: tuple[str, ...] = ()

    def risks(self) -> Iterator[str]:
        """What may make the numbers others than those that the file means, for people."""
        yield from self.warnings
        yield from (f"left out, although it changes torques: {text}" for text in self.left_out)

    def lines(self) -> Iterator[str]:
        """All of it for people: risks first, what is not used on one line."""
        yield from self.risks()
        yield from self.decided
        if self.not_used:
            yield f"not used: {'; '.join(self.not_used)}"

    def physics_left_out(self) -> Iterator[str]:
        """What changes torques and is not in the robot, for people who compare it with another."""
        yield from (f"left out of {self.file}: {text}" for text in self.left_out)

    def to_dict(self) -> dict[str, Any]:
        """For JSON, and the key ``imported`` of a description."""
        values = ((each.name, getattr(self, each.name)) for each in fields(self))
        return {name: list(value) if isinstance(value, tuple) else value for name, value in values}


class RobotWithAccount(Protocol):
    """What is asked of a :class:`~robodyn.robot.model.Robot` here."""

    @property
    def name(self) -> str: ...
    @property
    def links(self) -> Sequence[LinkWithOrigins]: ...
    @property
    def account(self) -> Account | None: ...


def account_lines(robot: RobotWithAccount) -> Iterator[str]:
    """What is known of ``robot`` and its numbers, for people."""
    for line in origins_in_words(robot.links):
        yield f"Origin of numbers: {line}"
    if robot.account is not None:
        yield f"Imported from {robot.account.file} ({robot.account.format})"
        yield from robot.account.lines()


def account_to_dict(robot: RobotWithAccount) -> dict[str, Any]:
    """What is known of ``robot`` and its numbers, for JSON: the :class:`Account` of the file that it was
    imported from, None where it comes from no such file, and the origin of each link's numbers."""
    return {
        "robot": robot.name,
        "imported": None if robot.account is None else robot.account.to_dict(),
        "origins": origins_to_dicts(robot.links),
    }
