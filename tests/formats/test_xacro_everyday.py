"""Everyday xacro expands to what plain xacro makes of it, element for element."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from pathlib import Path

import pytest

from robodyn.formats.arm import import_arm
from robodyn.formats.xacro import expanded
from robodyn_testing import require_module
from robodyn_testing.plain_xacro import element_list, plain_expansions
from robodyn_testing.xacro_arms import FAMILY, HEAD, PACKAGE, TWO_LINKS, arm, named, values, write

FAMILY_TOP = "Series_Description-main/urdf/series.urdf.xacro"


@dataclass(frozen=True)
class Case:
    """Files, which of them is expanded, with which arguments, and the packages that ROS would find."""

    files: dict[str, str]
    top: str = "arm.urdf.xacro"
    arguments: dict[str, str] = field(default_factory=dict)
    packages: dict[str, str] = field(default_factory=dict)


def one(text: str, **arguments: str) -> Case:
    return Case({"arm.urdf.xacro": text}, arguments=arguments)


LISTS = values(
    "items[0]", "items[1:]", "items[-1]", "[2 * x for x in items if x > 1]", "python.sum(items)",
    "len(items)",
    "list(map(float, text.split()))", "' '.join([str(x) for x in items])", "sorted(items, reverse=True)",
    "max(items) - min(items)", "max(names, key=len)", "[i * x for i, x in python.enumerate(items)]",
    "[a + b for a, b in python.zip(items, items)]", "python.sum(x for x in items)", "list(range(2, 8, 3))",
    "3 in items and 'a' not in items", "dict(a=1, b=[1, 2])['b'][1]", "dict(items=3)['items']",
    "[k for k, v in dict(x=1, y=2).items() if v == 2]", "list(dict(x=1).keys())",
    "list(map(lambda x: x * len(items), items))", "sorted(items, key=lambda x: -x)", "items + [7, 8]",
    "[0] * 3",
    "python.all([1, 0])", "python.any([1, 0])", "python.reversed(items) and 1", "python.abs(-3)",
    "python.isinstance(text, python.str)", "python.type(text) == python.str", "(1, 2)[0]", "list((1, 2))",
    before='<xacro:property name="items" value="${[3, 1, 2]}"/><xacro:property name="text" value="1 2.5 3"/>'
    "<xacro:property name=\"names\" value=\"${['a', 'bcd']}\"/>",
)  # fmt: skip
NUMBERS = values(
    "1 + 2 * 3 - 4 / 5", "7 // 2", "7 % 3", "2 ** 10", "2 ** -1", "-x", "not x", "5 &amp; 3",
    "0.1 + 0.2", "1e-7", "1e22", "1_000", "0x10", "round(2.567, 1)", "round(2.5)", "int(2.9)", "float('1e3')",
    "radians(90)", "degrees(pi)", "sin(pi / 6) + cos(0) + tan(0.1)", "atan2(1, 2)", "sqrt(2)", "hypot(3, 4)",
    "math.floor(2.5) + math.ceil(2.5)", "math.pi", "fabs(-1)", "copysign(1, -0.0)",
    "log(e)", "inf", "tau", "x if x &gt; 1 else 0", "0 &lt; x &lt;= 2",
    "1 if None is None else 2",
    "python.divmod(7, 2)", "bool(0)", "bool('a')", "True", "None", "x == 2 or y",
    before='<xacro:property name="x" value="2"/>',
)  # fmt: skip
TEXTS = values(
    "'a' + 'b'", "'ab' * 2", "text.upper()", "text.split('_')[0]", "text.replace('_', '-')", "text[1:3]",
    "'%.3f %5d|%-4s' % (1.23456, 7, 'x')", "'%(k)s' % dict(k=3)", "'%d%%' % 5", "text.startswith('left')",
    "text.strip('l')", "text.find('_')", "'left' in text", "text == 'left_arm'",     "str(1.0) + 'm'",
    "xacro.tokenize('a,b; c')", "xacro.tokenize('a:b', ':')", "xacro.message('hi')", "python.ord('a')",
    "'1' '2'",
    "python.repr('a')", "text.count('l')", "text.partition('_')[2]", "'a\\tb'", "text.title()",
    r"'\d' + text",
    before='<xacro:property name="text" value="left_arm"/>',
)  # fmt: skip
SCOPES = f"""{HEAD}
<xacro:property name="g" value="1"/><xacro:property name="late" value="${{g + more}}"/>
<xacro:property name="more" value="2"/><xacro:property name="g" default="5"/>
<xacro:property name="e" default="3"/><xacro:property name="gone" value="1"/>
<xacro:property name="gone" remove="true"/><xacro:property name="${{'na' + 'med'}}" value="3"/>
<xacro:macro name="set" params="v:=3 w:='x y' u:=^|9 z:=${{2*v0}} g:=^">
<xacro:property name="p" value="${{v}}" scope="parent"/>
<xacro:property name="q" value="${{v + 1}}" scope="global"/>
<l v="${{v}}" w="${{w}}" u="${{u}}" z="${{z}}" g="${{g}}"/>
</xacro:macro><xacro:property name="v0" value="4"/>
<xacro:set/><xacro:set v="8" w="${{[1]}}"/>
<l p="${{p}}" q="${{q}}" late="${{late}}" e="${{e}}" n="${{named}}"/>
<xacro:property name="max" value="6"/><l m="${{max}}" n="${{python.max(1, 2)}}"/>
<xacro:if value="${{g == 1}}"><yes/><xacro:unless value="true"><no/></xacro:unless></xacro:if>
<xacro:if value="${{[]}}"><no/></xacro:if><xacro:if value="1"><yes/></xacro:if>
<l a="$${{x}} $$(arg y) $ {{1}}" b="'quoted'"/><!-- ${{not evaluated}} -->
<!-- xacro:eval-comments --><!-- ${{g}} --></robot>"""
LOOP = f"""{HEAD}<xacro:macro name="loop" params="items:=^ i:=0"><xacro:if value="${{items}}">
<link name="l${{i}}_${{items[0]}}"/><xacro:loop items="${{items[1:]}}" i="${{i + 1}}"/></xacro:if>
</xacro:macro>
<xacro:loop items="${{['a', 'b', 'c']}}"/><xacro:property name="items" value="${{[1, 2]}}"/><xacro:loop/>
</robot>"""
BLOCKS = f"""{HEAD}<xacro:property name="block"><origin xyz="${{x}} 0 0"/><b/></xacro:property>
<xacro:property name="x" value="4"/><xacro:macro name="m" params="a *one **many"><w a="${{a}}">
<xacro:insert_block name="one"/><xacro:insert_block name="many"/><xacro:insert_block name="block"/></w>
</xacro:macro>
<xacro:m a="1"><p v="${{x}}"/><q><r/><s/></q></xacro:m><xacro:call macro="${{'m'}}" a="2"><p/><q/>
</xacro:call>
<xacro:element xacro:name="${{'li' + 'nk'}}" k="${{x}}"/><v>
<xacro:attribute name="${{'at'}}" value="${{'v' + 'w'}}"/></v>
</robot>"""
INCLUDES = {
    "arm.urdf.xacro": f"""{HEAD}<xacro:include filename="parts/a.xacro" ns="a"/>
<xacro:include filename="parts/b*.xacro"/><xacro:include filename="none.xacro" optional="true"/>
<xacro:property name="file" value="parts/c.xacro"/><xacro:include filename="${{file}}"/>
<xacro:a.part n="1"/><xacro:call macro="a.part" n="2"/>
<l v="${{a.x}}" w="${{a.x + a.y}}" b="${{b1 + b2}}" c="${{c}}"/></robot>""",
    "parts/a.xacro": f'{HEAD}<xacro:property name="x" value="2"/>'
    '<xacro:property name="y" value="${x * 3}"/>'
    '<xacro:macro name="part" params="n"><link name="p${n}${x}"/></xacro:macro></robot>',
    "parts/b1.xacro": f'{HEAD}<xacro:property name="b1" value="1"/></robot>',
    "parts/b2.xacro": f'{HEAD}<xacro:property name="b2" value="2"/></robot>',
    "parts/c.xacro": f'{HEAD}<xacro:include filename="../parts/d.xacro"/></robot>',
    "parts/b3.xacro": f"""{HEAD}<l m="${{xacro.abs_filename('../m/a.stl')}}"/></robot>""",
    "parts/d.xacro": '<robot xmlns:xacro="http://x" xmlns:n="u"><xacro:property name="c" value="3"/></robot>',
}
ARGUMENTS = f"""{HEAD}<xacro:arg name="side" default="left"/><xacro:arg name="sim" default="false"/>
<xacro:arg name="n" default="${{1 + 1}}"/><xacro:property name="which" value="n"/>
<l a="$(arg side)" n="${{$(arg n) * 2}}" e="$(eval n + 1)" f="$(eval side == 'left')" g="$(arg ${{which}})"
 h="${{xacro.arg('side')}}" i="$(eval sim or n > 1)" j="${{'$(arg side)'.upper()}}"/>
<xacro:if value="$(arg sim)"><no/></xacro:if><xacro:unless value="$(arg sim)"><yes/></xacro:unless>
<xacro:if value="$(eval 'ft' in side)"><yes/></xacro:if></robot>"""
YAML = {
    "arm.urdf.xacro": values(
        "c.a", "c['l'][1]", "c.l", "c.d.e", "c.d['f']", "c.deg", "c.rad", "c.mm", "c.m", "c.inch", "c.foot",
        "c.none", "c.flag", "c.text", "c.date", "c.merged.e", "c.get('none', 3)", "'a' in c", "c.l[0:2]",
        "[x.k for x in c.rows]", "len(c.rows)", "c.d", "list(c.d.keys())", "c.sci", "c.expression", "c.octal",
        "[k for k in c.d]", "python.sum([row['k'] for row in c.rows])", "c.tuple[0]",
        "xacro.dotify(dict(a=1)).a",
        before="<xacro:property name=\"c\" value=\"${xacro.load_yaml('t.yaml')}\"/>",
    ),
    "t.yaml": """
a: 1.5
l: [1, two, 3.0]
d: &d {e: 5, f: x y}
merged: {<<: *d, f: 7}
deg: !degrees -90
rad: !radians pi/2 + 0.1
mm: !millimeters 5
m: !meters 2
inch: !inches 3
foot: !foot 1
none: ~
flag: yes
text: "a: b"
date: 2024-05-01
sci: 1.0e-3
expression: ${1+1}
octal: 010
tuple: [[1, 2]]
rows: [{k: 1}, {k: 2}]
""",
}  # fmt: skip
PATHS = f"""{HEAD}<xacro:arg name="file" default="$(find p)/c.yaml"/><l a="$(find p)/m/a.stl"
 b="${{xacro.abs_filename('../x')}}" c="package://p/m/a.stl" d="$(cwd)"/>
<xacro:property name="t" value="${{xacro.load_yaml('$(arg file)')}}"/><l v="${{t.v}}" w="${{t.w}}"/>
</robot>"""
#: What files call their properties: none of it means anything else here.
NAMES = (
    "type", "format", "open", "_len", "f_max", "co_mass", "eval", "vars", "name", "gi_x", "mro", "exec", "id",
    "input", "globals", "compile", "getattr", "sum", "abs", "zip", "self", "os", "sys", "env", "arg", "find",
    "größe",
)  # fmt: skip
TYPED = """<xacro:macro name="jj" params="type format:=^|2"><joint name="j0" type="${type}">
<parent link="w"/><child link="b"/><limit effort="${format}"/></joint></xacro:macro><link name="w"/>
<xacro:jj type="fixed"/>"""
MASS = '<xacro:property name="m" value="2.5"/>'
CASES = {
    "names": one(f"{HEAD}{''.join(map(named, NAMES))}</robot>"),
    **{f"property {name}": one(arm(named(name) + MASS)) for name in ("format", "open", "_m", "co_mass")},
    "a parameter type": one(arm(MASS + TYPED)),
    "a table of the package": Case(
        {
            "my_description/package.xml": PACKAGE % "arm_desc",
            "my_description/urdf/arm.xacro": arm(
                """<xacro:property name="c" value="${xacro.load_yaml('$(find arm_desc)/config/p.yaml')}"/>"""
                """<xacro:property name="m" value="${c['inertia']['m']}"/>"""
            ),
            "my_description/config/p.yaml": "joint_limits: {j1: {lower: !degrees -170.0, v: !radians 2.0}}\n"
            "inertia: {m: 2.5, ixx: 0.03}",
        },
        "my_description/urdf/arm.xacro",
        packages={"arm_desc": "my_description"},
    ),
    "two links": one(TWO_LINKS),
    "family": Case(FAMILY, FAMILY_TOP, packages={"series_description": "Series_Description-main"}),
    "family with arguments": Case(
        FAMILY, FAMILY_TOP, {"tf_prefix": "r_",
        "absolute": "true"}, {"series_description": "Series_Description-main"}
    ),
    "lists": one(LISTS), "numbers": one(NUMBERS), "texts": one(TEXTS), "scopes": one(SCOPES),
    "loop": one(LOOP),
    "blocks": one(BLOCKS), "arguments": one(ARGUMENTS),
    "arguments stated": one(ARGUMENTS, side="r", n="7", sim="True"),
    "includes": Case(INCLUDES), "yaml": Case(YAML),
    "a package": Case(
        {"q/package.xml": PACKAGE % "p", "q/u/arm.xacro": PATHS, "q/c.yaml": "{v: 1, w: [2]}"},
        "q/u/arm.xacro", packages={"p": "q"},
    ),
    "a package beside": Case(
        {"a/package.xml": PACKAGE % "a", "a/u/arm.xacro": PATHS, "other/b/package.xml": PACKAGE % "p",
         "other/b/c.yaml": "{v: 1, w: 2}"},
        "a/u/arm.xacro", packages={"p": "other/b"},
    ),
}  # fmt: skip


@pytest.fixture(scope="module")
def references(tmp_path_factory: pytest.TempPathFactory) -> dict[str, tuple[Path, str]]:
    """By case its top file and what plain xacro makes of it: one process for all."""
    require_module("xacro")
    tasks = {}
    for name, case in CASES.items():
        folder = tmp_path_factory.mktemp("case") / "ws"
        write(folder, case.files)
        tasks[name] = (
            folder / case.top,
            case.arguments,
            {package: folder / path for package, path in case.packages.items()},
        )
    texts = plain_expansions(list(tasks.values()))
    return {name: (task[0], text) for (name, task), text in zip(tasks.items(), texts, strict=True)}


@pytest.mark.parametrize("name", CASES)
def test_the_elements_are_those_of_plain_xacro(name: str, references: dict[str, tuple[Path, str]]) -> None:
    path, reference = references[name]
    assert element_list(expanded(path, CASES[name].arguments).text) == element_list(reference)


@pytest.mark.parametrize("name", ["family", "family with arguments", "two links", "a table of the package"])
def test_an_arm_has_the_numbers_of_its_expansion(
    name: str, references: dict[str, tuple[Path, str]], tmp_path: Path
) -> None:
    path, reference = references[name]
    (tmp_path / "arm.urdf").write_text(reference, encoding="utf-8")
    robot = import_arm(path, arguments=CASES[name].arguments).robot
    of_reference = import_arm(tmp_path / "arm.urdf").robot
    assert replace(robot, source="") == replace(of_reference, source="")
    assert robot.n == (1 if name.startswith("a") else 2)
