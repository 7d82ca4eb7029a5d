"""Which link hangs on which: roots, paths, rigid groups and the tips that can be chosen."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from robodyn.errors import InputError, Place
from robodyn.formats.limits import NAMES_SHOWN
from robodyn.formats.tree import Tree, TreeJoint, TreeLink, names, near
from robodyn.robot.names import shown


class Topology:
    """The joints of a tree by their links.

    Raises
    ------
    InputError: a link hangs on two joints, or joints form a circle.
    """

    def __init__(self, tree: Tree) -> None:
        self.tree = tree
        self.links = {link.name: link for link in tree.links}
        self.above: dict[str, TreeJoint] = {}
        self.below: dict[str, list[TreeJoint]] = {name: [] for name in self.links}
        for joint in tree.joints:
            other = self.above.setdefault(joint.child, joint)
            if other is not joint:
                raise InputError(
                    f"the link {shown(joint.child)} hangs on two joints: the mechanism has a closed loop",
                    where=joint.where,
                    found=f"the joints {names((other.name, joint.name), 2)}",
                    expected="a tree, in which each link is the child of one joint",
                    remedy="delete one of the two joints; robodyn has no closed loops",
                )
            self.below[joint.parent].append(joint)
        self.roots = [name for name in self.links if name not in self.above]
        reached = {joint.child for root in self.roots for joint in self.joints_below(root)}
        circle = [joint for joint in tree.joints if joint.child not in reached]
        if circle:
            raise InputError(
                "the joints form a circle",
                where=circle[0].where,
                found=names((joint.name for joint in circle), NAMES_SHOWN),
                expected="a tree with a root",
            )

    def joints_below(self, link: str) -> Iterator[TreeJoint]:
        """All joints below ``link``, parents before children, in the order of the file."""
        stack = list(reversed(self.below[link]))
        while stack:
            joint = stack.pop()
            yield joint
            stack.extend(reversed(self.below[joint.child]))

    def path(self, link: str) -> list[TreeJoint]:
        """The joints from the root to ``link``."""
        joints = []
        while link in self.above:
            joints.append(self.above[link])
            link = joints[-1].parent
        return joints[::-1]

    def link(self, name: str, option: str) -> TreeLink:
        """The link of that name, which an option states.

        Raises
        ------
        InputError: there is none.
        """
        if name not in self.links:
            raise InputError(
                f"there is no link of the name after {option}",
                where=Place(self.tree.file),
                found=shown(name),
                expected=near(name, self.links, "link"),
            )
        return self.links[name]

    def base(self) -> str:
        """The root that joints hang on.

        Raises
        ------
        InputError: there are several, or there is no joint at all.
        """
        roots = [root for root in self.roots if self.below[root]]
        if len(roots) == 1:
            return roots[0]
        if not roots:
            raise InputError("the robot has no joints", where=Place(self.tree.file))
        raise InputError(
            "the file has several mechanisms",
            where=self.links[roots[1]].where,
            found=f"the roots {names(roots, NAMES_SHOWN)}",
            expected="one",
            remedy="choose one with --base",
        )

    def rigid_group(self, link: str, moves: Callable[[TreeJoint], bool]) -> list[str]:
        """``link`` and what is rigidly joined to it from below."""
        group = [link]
        for name in group:
            group += [joint.child for joint in self.below[name] if not moves(joint)]
        return group

    def tip(self, base: str, moves: Callable[[TreeJoint], bool], chosen: Callable[[TreeJoint], bool]) -> Tip:
        """The one tip below ``base``; ``chosen``: whether a chain may go through a joint.

        Raises
        ------
        InputError: there are several, with the choices.
        """
        ends: list[list[str]] = []
        choices: list[tuple[str, int]] = []  # links and how many joints move them
        groups: list[tuple[str, int, bool]] = [(base, 0, True)]
        for head, count, open_ in groups:
            group = self.rigid_group(head, moves)
            onward = [joint for name in group for joint in self.below[name] if moves(joint)]
            groups += [(joint.child, count + 1, open_ and chosen(joint)) for joint in onward]
            if not onward and count:
                ends.append(group)
            if open_ and count and len(onward) != 1:
                parents = dict.fromkeys(joint.parent for joint in onward)
                choices += [(name, count) for name in parents or self._leaves(group)[:1]]
        if len(ends) == 1:
            (group,) = ends
            leaves = self._leaves(group)
            return Tip(leaves[0] if len(leaves) == 1 else group[0], tuple(leaves) if len(leaves) > 1 else ())
        if not ends:
            raise InputError(
                f"nothing moves below the link {shown(base)}",
                where=self.links[base].where,
                expected="a joint that is revolute, continuous or prismatic",
            )
        raise InputError(
            "the mechanism branches and has several tips",
            where=Place(self.tree.file),
            found=f"{len(ends)} tips",
            expected="one of "
            + names((f"{name} ({count} joint{'s' * (count != 1)})" for name, count in choices), NAMES_SHOWN),
            remedy=f"choose one: robodyn import {self.tree.file} --tip LINK -o arm.yaml",
        )

    def _leaves(self, group: list[str]) -> list[str]:
        inside = set(group)
        return [name for name in group if not any(joint.child in inside for joint in self.below[name])]


class Tip:
    """The link at the end of a chain, and frames beside it that could have been chosen as well."""

    def __init__(self, link: str, others: tuple[str, ...]) -> None:
        self.link, self.others = link, others
