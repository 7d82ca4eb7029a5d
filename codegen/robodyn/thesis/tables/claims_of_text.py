"""Claims that the thesis makes in words, without a table of their own, each set beside what can be computed.

Of some only the words are known to us, not what they were concluded from; those say how they were read.
"""

from __future__ import annotations

import itertools
from typing import Any, Final

from robodyn.counts.general import general_count
from robodyn.counts.objective import operations_of, parse_objective
from robodyn.kernels.generate import Options, program
from robodyn.schedule import (
    FLOPS_PER_TASK,
    Machine,
    TaskGraph,
    critical_path_order,
    fewest_processors,
    general_graph,
    list_schedule,
    solve,
)
from robodyn.schedule.branch_and_bound import one_processor_a_joint
from robodyn.schedule.friction_tasks import Friction
from robodyn.targets import target_named
from robodyn.thesis.judge import printed_graph, rule_graph
from robodyn.thesis.printed_counts import TABLE_1_1, TABLE_3_3, TABLE_3_5
from robodyn.thesis.printed_tasks import LEVELS_STANFORD, TIMES_OTHERS, TIMES_STANFORD
from robodyn.thesis.tables import table_3_3
from robodyn.thesis.tables.table import Row, Verdict, judged
from robodyn.thesis.tables.table_1_1 import formulation
from robodyn.thesis.tables.table_2_10 import Load, plain
from robodyn.thesis.tables.table_4_4 import ROBOT

LINKS: Final = 6
#: The bundled arm on which formulations are compared, and the processor of today that a kernel is timed for.
PUMA: Final = "puma560"
TODAY: Final = "cortex-m4f"
#: Times a structural frequency that a sampling rate should be, and such frequencies [Hz].
TIMES: Final = 20
RESONANCES: Final = (5, 10)
#: Steps of the branch and bound for one processor a joint: enough, and the same on every machine.
_STEPS: Final = 200
_NODES: Final = 500
#: An increase that may be called marginal, and a share that may be called much smaller.
_MARGINAL: Final = 5.0  # percent
_MUCH_SMALLER: Final = 0.2


def rows(load_robot: Load) -> list[Row]:
    """All of them."""
    stanford = rule_graph("stanford")
    return [
        _on_an_8086(),
        _kilohertz(),
        _luh_and_lin(stanford),
        _no_advantage(load_robot),
        _much_smaller(),
        _region(),
        _marginal(),
        _levels_are_no_operations(),
        _ideal("six", general_graph(LINKS), 6),
        _ideal("four", printed_graph("stanford"), 4),
        _sampling_rates(stanford, load_robot),
    ]


def _row(
    name: str,
    claim: str,
    printed: dict[str, Any],
    statement: str,
    ours: dict[str, Any],
    verdict: Verdict,
    reason: str,
) -> Row:
    return Row(name, {"claim": claim, **printed}, {"found": statement, **ours}, verdict, reason)


def _flop_us() -> float:
    """Microseconds an operation on the thesis's processor, by Table 4.8."""
    return 1e3 * TIMES_STANFORD[1] / LEVELS_STANFORD[1] / FLOPS_PER_TASK


def _on_an_8086() -> Row:
    flop = _flop_us()
    ours = {name: round(cost.total_6 * flop / 1e3, 1) for name, cost in TABLE_1_1.items()}
    return _row(
        "800 ms on an 8086",
        "the inverse dynamics takes 800 ms on an 8086",
        {"ms": 800},
        f"Newton-Euler {ours['newton_euler']} ms, Lagrange {ours['uicker_kahn']:.0f} ms at the thesis's own "
        f"{flop:.0f} us an operation",
        {"ms": ours},
        "not recoverable",
        "neither the formulation, the clock nor whether a coprocessor is there is known to us. The printed "
        f"operations of Table 1.1 at the {flop:.0f} us of Table 4.8 give no 800 ms; with Newton-Euler's "
        f"{TABLE_1_1['newton_euler'].total_6} it is {8e5 / TABLE_1_1['newton_euler'].total_6:.0f} us an "
        "operation, floating point in software",
    )


def _kilohertz() -> Row:
    low, high = (TIMES * frequency for frequency in RESONANCES)
    printed = {"hz": [1000, 2000]}
    return _row(
        "1 to 2 kHz",
        f"torques are needed at 1 to 2 kHz, {TIMES} times the {RESONANCES[0]} to {RESONANCES[1]} Hz of the "
        "structure",
        printed,
        f"{low} to {high} Hz",
        {"hz": [low, high]},
        judged([low, high] == printed["hz"]),
        f"{TIMES} times {RESONANCES[0]} to {RESONANCES[1]} Hz is {low} to {high} Hz: ten times less",
    )


def _luh_and_lin(stanford: TaskGraph) -> Row:
    steps = itertools.count()
    best = one_processor_a_joint(stanford, seconds=_STEPS, clock=lambda: float(next(steps)))
    ours = round(len(stanford) / best.schedule.levels, 2)
    theirs = TIMES_OTHERS["Luh and Lin 1982"]
    by_table = round(theirs[1] / theirs[LINKS], 2)
    return _row(
        "Luh and Lin",
        "Luh and Lin's schedule, one processor a joint, is 2.64 times as fast as one processor",
        {"speedup": 2.64},
        f"{ours} with one processor a joint: {len(stanford)} tasks in {best.schedule.levels} levels; "
        f"{by_table} by Table 4.8",
        {
            "speedup": ours,
            "levels": best.schedule.levels,
            "bound_levels": best.lower_bound,
            "by_table_4_8": by_table,
        },
        "not recoverable",
        f"their tasks are others, and which joint each belongs to is not known. The thesis's own tasks, so "
        f"bound, come to about the same; none below {best.lower_bound} levels is proven. The figures quoted "
        f"in Table 4.8, {theirs[1]} and {theirs[LINKS]} ms, are {by_table} and not 2.64",
    )


def _no_advantage(load_robot: Load) -> Row:
    robot = load_robot(PUMA)
    names = ("newton_euler", "modified_newton_euler", "balafoutis", "kane")
    customised = {name: plain(robot, name).total for name in names}
    general = {name: general_count(formulation(name), LINKS, dense=True).total for name in names}
    apart = {
        name: {
            "customised_pct": round(100 * (customised[name] / customised["newton_euler"] - 1), 1),
            "general_pct": round(100 * (general[name] / general["newton_euler"] - 1), 1),
        }
        for name in names[1:]
    }
    saves = [name for name in ("balafoutis", "kane") if apart[name]["customised_pct"] < -_MARGINAL]
    against = customised["balafoutis"] - customised["modified_newton_euler"]
    return _row(
        "Kane and Balafoutis",
        "Kane's equations and Balafoutis's tensors have no significant advantage over Newton-Euler",
        {"significant": []},
        ", ".join(
            f"{name} {apart[name]['customised_pct']:+.0f} % on {PUMA}, {apart[name]['general_pct']:+.0f} % "
            "for any arm"
            for name in ("balafoutis", "kane")
        ),
        {"operations": customised, "operations_of_any_arm": general, "apart": apart},
        judged(not saves),
        f"{' and '.join(saves) or 'neither'} saves more than {_MARGINAL:.0f} % of Newton-Euler's operations; "
        f"beside the thesis's own recursion Balafoutis's has {abs(against)} "
        f"{'more' if against > 0 else 'fewer'} on {PUMA}. Counted as each stands, optimised by nobody's hand",
    )


def _torques() -> Any:
    """The case study's motion, and the torques [S, 3] without friction, with that of the joints, with all."""
    from robodyn.thesis.case_arm import led, robots
    from robodyn.thesis.case_study import DURATION, SAMPLES, Assumptions, motion_of
    from robodyn.verify.reference import Reference

    assumed = Assumptions()
    arms = robots(assumed.payload, assumed.span)
    fine = motion_of(assumed, led(assumed.arm))
    motion = fine.sampled(DURATION / (SAMPLES - 1))
    moving = slice(1, -1)
    return motion.qd[moving], [
        Reference(robot).inverse_dynamics(motion.q, motion.qd, motion.qdd)[moving]
        for robot in (arms.rigid, arms.with_bearings, arms.complete)
    ]


def _much_smaller() -> Row:
    _, (rigid, joint, total) = _torques()
    ratio = abs(joint - rigid) / abs(total - joint)
    most = [round(float(x), 2) for x in ratio.max(axis=0)]
    holds = max(most) <= _MUCH_SMALLER
    return _row(
        "friction of joints",
        "friction in the joints is much smaller than in the transmissions, for all times",
        {"at_most": "much smaller"},
        f"at most {', '.join(map(str, most))} of it at joints 1 to 3",
        {"largest_ratio": most},
        judged(holds),
        "on our case study, whose motion is another: smaller at all times"
        + (", and much so" if holds else f", but at joint 1 not much: up to {most[0]} of the transmission's")
        + ". In Table 3.5, at 0.6 s, the ratios are "
        + ", ".join(f"{float(abs(row.joint_friction / row.transmission)):.2f}" for row in TABLE_3_5),
    )


def _region() -> Row:
    rates, (_, joint, _) = _torques()
    regions = {"I": (1, 1), "II": (-1, 1), "III": (-1, -1), "IV": (1, -1)}
    printed = [  # the motion goes where joint friction points
        name
        for row in TABLE_3_5
        for name, (rate, torque) in regions.items()
        if rate * row.joint_friction > 0 and torque * row.joint_total > 0
    ]
    shares = {
        name: [
            round(float(((rates[:, j] * rate > 0) & (joint[:, j] * torque > 0)).mean()), 2)
            for j in range(rates.shape[1])
        ]
        for name, (rate, torque) in regions.items()
    }
    spelled = [
        "joint {}: {}".format(j + 1, ", ".join(f"{name} {s[j]:.0%}" for name, s in shares.items() if s[j]))
        for j in range(rates.shape[1])
    ]
    return _row(
        "region I",
        "the transmissions work in region I, torque and motion both positive",
        {"region": "I"},
        "; ".join(spelled),
        {"shares": shares},
        "not recoverable",
        f"by Table 3.5 itself the joints are in regions {', '.join(printed)} at 0.6 s: the last one brakes. "
        "Our case study's motion is another; whose motion the sentence means is not known to us",
    )


def _marginal() -> Row:
    counts = {row: count.mul + count.add for row, count in table_3_3.ours().items()}
    rigid = sum(TABLE_3_3["frictionless"]["revolute"])
    printed = _increase(rigid, sum(TABLE_3_3["total_linear"]["revolute"]))
    gear_only = _increase(rigid, rigid + sum(TABLE_3_3["transmission"]["linear"]))
    own = _increase(counts["frictionless, revolute"], counts["total_linear, revolute"])
    plain_graph, graph = general_graph(LINKS), general_graph(LINKS, Friction("journal", "linear"))
    tasks = _increase(len(plain_graph), len(graph))
    chain = _increase(plain_graph.critical_path, graph.critical_path)
    return _row(
        "load with friction",
        "friction increases the computational load marginally",
        {"percent": printed},
        f"{own} % more operations a revolute joint; six joints: {tasks} % more tasks, {chain} % more levels",
        {
            "percent": own,
            "tasks_percent": tasks,
            "levels_percent": chain,
            "transmission_percent": gear_only,
        },
        judged(own <= _MARGINAL),
        f"by the thesis's own Table 3.3 it is {printed} %, of which transmissions alone are {gear_only} %: "
        "that is marginal, friction in the joints is not",
    )


def _increase(base: int, more: int) -> float:
    return round(100 * (more / base - 1), 1)


def _levels_are_no_operations() -> Row:
    layers = general_graph(LINKS).critical_path
    return _row(
        "4 n + 3 operations",
        "the parallel algorithm takes 4 n + 3 operations",
        {"operations": "4 n + 3"},
        f"{layers} tasks one after another for six joints, {FLOPS_PER_TASK * layers} operations",
        {"levels": layers, "operations": FLOPS_PER_TASK * layers},
        judged(FLOPS_PER_TASK * layers == 4 * LINKS + 3),
        f"4 n + 3 are levels, each a task of {FLOPS_PER_TASK} operations long: 12 n + 9 operations, as the "
        "thesis has it elsewhere",
    )


def _ideal(name: str, graph: TaskGraph, processors: int) -> Row:
    solved = {
        p: solve(graph, Machine(p), "df-ihs", seconds=1e6, nodes=_NODES) for p in range(1, processors + 4)
    }
    shares = {p: round(100 * one.efficiency, 2) for p, one in solved.items()}
    most = max(p for p in shares if all(shares[k] > 98 for k in shares if k <= p))
    arm = "six-link" if name == "six" else "Stanford"
    order, span = critical_path_order(graph), graph.critical_path
    some = range(fewest_processors(graph, span), len(graph) + 1)
    least = next(p for p in some if list_schedule(graph, p, order).levels == span)
    return _row(
        f"{name} processors ideal",
        f"{name} processors are ideal for the {arm} arm",
        {"processors": processors},
        f"{shares[processors]} % efficiency with {processors}, {shares[processors + 1]} % with "
        f"{processors + 1}; above 98 % up to {most}",
        {"processors": most, "efficiency_pct": {str(p): share for p, share in shares.items()}},
        judged(most == processors),
        "read as the most with an efficiency above 98 %, of shortest schedules"
        + (", all proven" if all(one.optimal for one in solved.values()) else "")
        + f"; the time goes on falling up to {least} processors, to the {span} levels of the "
        "longest chain",
    )


def _sampling_rates(stanford: TaskGraph, load_robot: Load) -> Row:
    """Rates by Table 4.8, and by the operations of our kernel on a small processor of today."""
    printed = {str(p): round(1e3 / ms) for p, ms in TIMES_STANFORD.items()}
    task_ms = TIMES_STANFORD[1] / LEVELS_STANFORD[1]
    best = round(1e3 / (stanford.critical_path * task_ms))
    kernel = program(load_robot(ROBOT), "inverse_dynamics", Options(("inverse_dynamics",), optimize="fast"))
    target = target_named(TODAY)
    assert target.chip is not None
    cycles = parse_objective(target.objective).cost(operations_of(kernel))
    call_us = cycles / target.chip.mhz
    wanted = [TIMES * frequency for frequency in RESONANCES]
    fewest = {hz: next((p for p, rate in printed.items() if rate >= hz), None) for hz in wanted}
    return _row(
        "sampling rates",
        f"{printed['1']} Hz with one processor, {printed['8']} Hz with eight (Table 4.8)",
        {"hz": printed},
        f"{best} Hz at the longest chain; one {TODAY} of today {1e3 / call_us:.0f} kHz",
        {"best_hz": best, "kernel_us": round(call_us, 2), "kernel_khz": round(1e3 / call_us)},
        judged(all(fewest.values())),
        f"{wanted[0]} Hz take {fewest[wanted[0]]} processors and {wanted[1]} Hz {fewest[wanted[1]]} by the "
        f"printed times, and 1 kHz no number of them: the longest chain allows {best} Hz. Our kernel of the "
        f"Stanford arm needs no second processor: about {cycles:.0f} cycles at {target.chip.mhz:.0f} MHz by "
        "the weights of its operations, not measured, loads and stores not in it",
    )
