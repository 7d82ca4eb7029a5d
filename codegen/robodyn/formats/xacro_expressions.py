"""Expressions of xacro files, evaluated as data over a whitelist of syntax.

Nothing is compiled. A name is what the file bound it to, or a function of the tables in
:mod:`robodyn.formats.xacro_values`; an attribute is a key of a mapping, a name in a namespace, or a method
of those tables. No attribute of a Python object is read, so that no expression reaches the interpreter.
Values are of Python's own plain types, and their size, and the work on them, is bounded.
"""

from __future__ import annotations

import ast
from collections.abc import Iterator, Mapping
from typing import Any, Final

from robodyn.formats.xacro_values import (
    BINARY,
    COMPARISONS,
    DATA,
    METHODS,
    UNARY,
    Budget,
    Function,
    Names,
    Refused,
    bounded,
    checked_data,
    shown,
    spend,
)

LONGEST: Final = 10_000
"""[characters] Longest expression."""
Local = Mapping[str, Any]


def evaluate(expression: str, names: Names) -> Any:
    """The value of ``expression``, one of :data:`DATA`.

    Raises
    ------
    Refused: it is no expression, has syntax or calls that are not whitelisted, fails, or is too large.
    """
    text = expression.strip()
    if len(text) > LONGEST:
        raise Refused(f"an expression of more than {LONGEST} characters: {shown(text)}")
    work, Budget.steps = Budget.steps, 0
    try:
        tree = ast.parse(text, mode="eval")
        return checked_data(Evaluator(names).value(tree.body, {}))
    except (SyntaxError, UnicodeError):
        raise Refused(f"not an expression: {shown(text)}") from None
    except RecursionError:
        raise Refused(f"nested too deeply: {shown(text)}") from None
    except MemoryError:  # of the parser too, where parentheses are nested
        raise Refused(f"out of memory: {shown(text)}") from None
    except Exception as error:
        reason = str(error) if isinstance(error, Refused) else str(error)[:150] or type(error).__name__
        raise Refused(f"{reason}, in the expression {shown(text)}") from None
    finally:
        Budget.steps = work


class Evaluator:
    """Evaluates the nodes of one expression; ``local`` has the variables of its comprehensions."""

    def __init__(self, names: Names) -> None:
        self.names = names

    def value(self, node: ast.AST, local: Local) -> Any:
        """The value of ``node``. All syntax that there is stands here; what is not a case is refused."""
        spend(1)
        match node:
            case ast.Name():
                return local[node.id] if node.id in local else _looked_up(self.names, node.id)
            case ast.Constant():
                return bounded(node.value)
            case ast.Attribute():
                return self._attribute(self.value(node.value, local), node.attr)
            case ast.Subscript():
                return self._subscript(node, local)
            case ast.Call():
                return self._call(node, local)
            case ast.BinOp() if type(node.op) in BINARY:
                left, right = (checked_data(self.value(x, local)) for x in (node.left, node.right))
                return bounded(BINARY[type(node.op)](left, right))
            case ast.UnaryOp():
                return UNARY[type(node.op)](checked_data(self.value(node.operand, local)))
            case ast.BoolOp():
                value = None
                for part in node.values:
                    value = self.value(part, local)
                    if bool(value) is isinstance(node.op, ast.Or):
                        break
                return value
            case ast.Compare():
                left, outcome = self.value(node.left, local), True
                for operation, part in zip(node.ops, node.comparators, strict=True):
                    right = self.value(part, local)
                    outcome = COMPARISONS[type(operation)](left, right)
                    if not outcome:
                        break
                    left = right
                return outcome
            case ast.IfExp():
                return self.value(node.body if self.value(node.test, local) else node.orelse, local)
            case ast.List():
                return bounded(self._elements(node.elts, local))
            case ast.Tuple():
                return bounded(tuple(self._elements(node.elts, local)))
            case ast.Set():
                return bounded(set(self._elements(node.elts, local)))
            case ast.Dict():
                entries: dict[Any, Any] = {}
                for key, part in zip(node.keys, node.values, strict=True):
                    value = self.value(part, local)
                    entries.update(value if key is None else {self.value(key, local): value})
                return bounded(entries)
            case ast.ListComp() | ast.SetComp() | ast.GeneratorExp():
                values = [self.value(node.elt, inner) for inner in self._scopes(node.generators, local)]
                return bounded(set(values) if isinstance(node, ast.SetComp) else values)
            case ast.DictComp():
                scopes = self._scopes(node.generators, local)
                return bounded({self.value(node.key, x): self.value(node.value, x) for x in scopes})
            case ast.Lambda():
                return self._lambda(node, local)
        raise Refused(f"{type(getattr(node, 'op', node)).__name__} is not evaluated here")

    def _attribute(self, owner: Any, name: str) -> Any:
        if isinstance(owner, Names):
            return _looked_up(owner, name)
        method = METHODS.get(type(owner), {}).get(name)
        if method is not None:
            return Function(name, lambda *rest, **options: method.body(owner, *rest, **options))
        if type(owner) is dict and name in owner:
            return owner[name]
        raise Refused(f"no attribute {name!r} of a {type(owner).__name__}")

    def _subscript(self, node: ast.Subscript, local: Local) -> Any:
        owner = self.value(node.value, local)
        if isinstance(owner, Names) and isinstance(node.slice, ast.Constant):
            return _looked_up(owner, node.slice.value)
        checked_data(owner)
        if isinstance(node.slice, ast.Slice):
            ends = (node.slice.lower, node.slice.upper, node.slice.step)
            return bounded(owner[slice(*(end and self.value(end, local) for end in ends))])
        key = self.value(node.slice, local)
        try:
            return owner[key]
        except KeyError:
            raise Refused(f"no key {shown(str(key))}") from None

    def _call(self, node: ast.Call, local: Local) -> Any:
        function = self.value(node.func, local)
        options: dict[str, Any] = {}
        arguments = self._elements(node.args, local)
        for keyword in node.keywords:
            value = self.value(keyword.value, local)
            options.update(value if keyword.arg is None else {keyword.arg: value})
        if not isinstance(function, Function):
            raise Refused(f"{type(function).__name__} is not a function")
        return function(*arguments, **options)

    def _elements(self, nodes: list[ast.expr], local: Local) -> list[Any]:
        elements: list[Any] = []
        for node in nodes:
            if isinstance(node, ast.Starred):
                elements.extend(bounded(list(self.value(node.value, local))))
            else:
                elements.append(self.value(node, local))
        return elements

    def _lambda(self, node: ast.Lambda, local: Local) -> Any:
        parameters = [ast.arg(parameter.arg) for parameter in node.args.args]
        if ast.dump(node.args) != ast.dump(ast.arguments([], parameters, None, [], [], None, [])):
            raise Refused("a lambda takes plain parameters here")
        names = [parameter.arg for parameter in parameters]
        return Function(
            "lambda",
            lambda *values: self.value(node.body, {**local, **dict(zip(names, values, strict=True))}),
        )

    def _scopes(self, loops: list[ast.comprehension], local: Local) -> Iterator[Local]:
        """The variables of a comprehension, round by round."""
        if not loops:
            yield local
            return
        loop = loops[0]
        source = self.value(loop.iter, local)
        if loop.is_async or type(source) not in DATA:
            raise Refused("a loop over what is no value")
        for item in source:
            spend(1)
            inner = dict(local)
            self._bind(loop.target, item, inner)
            if all(self.value(condition, inner) for condition in loop.ifs):
                yield from self._scopes(loops[1:], inner)

    def _bind(self, target: ast.expr, value: Any, local: dict[str, Any]) -> None:
        if isinstance(target, ast.Name):
            local[target.id] = value
        elif isinstance(target, ast.Tuple | ast.List) and type(value) in DATA:
            for part, item in zip(target.elts, value, strict=True):
                self._bind(part, item, local)
        else:
            raise Refused(f"{type(target).__name__} is not bound here")


def _looked_up(names: Names, name: Any) -> Any:
    try:
        return names.lookup(name)
    except KeyError:
        raise Refused(f"name {shown(str(name))} is not defined") from None
