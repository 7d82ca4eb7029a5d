"""Which link hangs on which: roots, paths, rigid groups and the tips that can be chosen."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from robodyn.errors import InputError, Place
from robodyn.formats.tree import Tree, TreeJoint, names, no_such
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
                    found=f"the joints {names((other.name, joint.name))}",
                    expected="a tree, in which each link is the child of one joint",
                    remedy="delete one of the two joints; robodyn has no closed loops",
                )
            self.below[joint.parent].append(joint)
        self._roots = [name for name in self.links if name not in self.above]
        reached = {joint.child for root in self._roots for joint in self.joints_below(root)}
        if circle := [joint for joint in tree.joints if joint.child not in reached]:
            found, where = names(joint.name for joint in circle), circle[0].where
            raise InputError(
                "the joints form a circle", where=where, found=found, expected="a tree with a root"
            )

    def joints_below(self, link: str) -> Iterator[TreeJoint]:
        """All joints below ``link``, parents before children, in the order of the file."""
        stack = self.below[link][::-1]
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

    def path_between(self, start: str, end: str) -> list[TreeJoint]:
        """The joints from the link ``start`` down to the link ``end``.

        Raises
        ------
        InputError: the one does not hang on the other.
        """
        path = self.path(end)
        above = [joint.parent for joint in path] + [end]
        if start not in above:
            raise InputError(
                f"the link {shown(end)} does not hang on the link {shown(start)}",
                where=self.links[end].where,
                found=f"the path {names(above)}",
                expected="a tip below the base",
                remedy="choose another --base or --tip",
            )
        return path[above.index(start) :]

    def chosen_link(self, name: str, option: str) -> str:
        """``name``, which an option states, if it is a link's.

        Raises
        ------
        InputError: there is none.
        """
        if name not in self.links:
            what = f"there is no link of the name after {option}"
            raise no_such("link", what, name, self.links, Place(self.tree.file))
        return name

    def base(self) -> str:
        """The root that joints hang on.

        Raises
        ------
        InputError: there are several, or there is no joint at all.
        """
        roots = [root for root in self._roots if self.below[root]]
        if not roots:
            raise InputError("the robot has no joints", where=Place(self.tree.file))
        if len(roots) > 1:
            raise InputError(
                "the file has several mechanisms",
                where=self.links[roots[1]].where,
                found=f"the roots {names(roots)}",
                expected="one",
                remedy="choose one with --base",
            )
        return roots[0]

    def tip(
        self, base: str, moves: Callable[[TreeJoint], bool], chosen: Callable[[TreeJoint], bool]
    ) -> tuple[str, list[str]]:
        """The one tip below ``base``, and frames on it that could have been chosen as well; ``chosen``:
        whether a chain may go through a joint.

        Raises
        ------
        InputError: there are several, with the choices.
        """
        ends: list[list[str]] = []
        choices: list[tuple[str, int]] = []  # links and how many joints move them
        groups: list[tuple[str, int, bool]] = [(base, 0, True)]
        for head, count, open_ in groups:
            group = [head]  # what is rigidly joined to it from below
            for name in group:
                group += [joint.child for joint in self.below[name] if not moves(joint)]
            onward = [joint for name in group for joint in self.below[name] if moves(joint)]
            rigid = set(group)
            leaves = [name for name in group if not any(joint.child in rigid for joint in self.below[name])]
            groups += [(joint.child, count + 1, open_ and chosen(joint)) for joint in onward]
            if not onward and count:
                ends.append([leaves[0] if len(leaves) == 1 else head, *leaves])
            if open_ and count and len(onward) != 1:
                parents = dict.fromkeys(joint.parent for joint in onward)
                choices += [(name, count) for name in parents or leaves[:1]]
        if not ends:
            what, where = f"nothing moves below the link {shown(base)}", self.links[base].where
            raise InputError(what, where=where, expected="a joint that is revolute, continuous or prismatic")
        if len(ends) > 1:
            listed = names(f"{name} ({count} joint{'s' * (count != 1)})" for name, count in choices)
            raise InputError(
                "the mechanism branches and has several tips",
                where=Place(self.tree.file),
                found=f"{len(ends)} tips",
                expected=f"one of {listed}",
                remedy=f"choose one: robodyn import {self.tree.file} --tip LINK -o arm.yaml",
            )
        tip, *leaves = ends[0]
        return tip, leaves if len(leaves) > 1 else []
