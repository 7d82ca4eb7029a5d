"""The one representation that is counted, scheduled, emitted, compiled and checked.

A recursion written over any scalar runs on :class:`~robodyn.ir.graph.Node` and leaves a graph in
which equal nodes are one node; ``lower`` turns what the outputs need into a straight-line
:class:`~robodyn.ir.program.Program`.
"""

from robodyn.ir.graph import Graph, Node
from robodyn.ir.program import Input, Label, Operand, Operation, Program
from robodyn.ir.signature import Signature

__all__ = ["Graph", "Input", "Label", "Node", "Operand", "Operation", "Program", "Signature"]
