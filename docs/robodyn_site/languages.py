"""A page for each language, from its record, with a kernel that it writes."""

from __future__ import annotations

from typing import Final

from robodyn.emit.language import Language
from robodyn.emit.languages import DEFAULTS, LANGUAGES
from robodyn.kernels.generate import Options, generate
from robodyn.robot import load
from robodyn_site.markdown import code, fenced, page, plain, table

FOLDER: Final = "languages"
#: A robot and a function that are short enough to be read.
ROBOT, FUNCTION = "stanford_3dof", "gravity"


def pages() -> dict[str, str]:
    """The pages of the languages, and their index."""
    each = {f"{FOLDER}/{name}.md": of_language(language) for name, language in LANGUAGES.items()}
    return {f"{FOLDER}/index.md": _index()} | each


def of_language(language: Language) -> str:
    """The page of one language."""
    return page(
        f"# {language.title}",
        f"`--lang {language.name}` writes the kernels in {language.title}"
        + (", and so does `robodyn gen` without `--lang`." if language.name in DEFAULTS else "."),
        _table(language),
        "## What it looks like",
        f"`robodyn gen {ROBOT} --functions {FUNCTION} --lang {language.name}` writes",
        *_files(language),
    )


def _index() -> str:
    rows = [
        (f"[`{name}`]({name}.md)", plain(one.title), "yes" if name in DEFAULTS else "")
        for name, one in LANGUAGES.items()
    ]
    return page(
        "# Languages",
        "The languages that kernels are written in. The operations and their order are the same in each, and "
        "so are the bits of the results, as far as sine and cosine are.",
        table(("`--lang`", "language", "by default"), rows),
        "To add one takes a file and its templates: [Add a language](../contributing.md#add-a-language).",
    )


def _table(language: Language) -> str:
    compiled = language.compiled
    compiler = compiled.compiler if compiled else None
    compilers = [f"the one named by `{compiler.variable}`", *map(code, compiler.names)] if compiler else []
    rows = [
        ("also called", ", ".join(map(code, language.aliases))),
        ("files", ", ".join(map(code, language.files))),
        ("numbers", ", ".join(map(code, language.scalars))),
        ("sine and cosine", ", ".join(map(code, language.trigonometry)) + f" (`{language.trig}` by default)"),
        ("further options", ", ".join(f"`--{name}`" for name in sorted(language.features)) or "none"),
        ("called from Python", f"compiled with {code(' '.join(compiled.flags))}" if compiled else "no"),
        ("compiler: the first there is", ", ".join(compilers)),
        ("longest name", f"{language.longest_name} characters" if language.longest_name else ""),
    ]
    return table(("what", "value"), [row for row in rows if row[1]])


def _files(language: Language) -> list[str]:
    options = Options(functions=(FUNCTION,), trig=language.trig)
    files = generate(load(ROBOT, warn=lambda _: None), options).files((language.name,))
    return [
        part
        for name, text in files.items()
        if name.endswith(language.suffixes)
        for part in (f"{code(name)}:", fenced(text, language.name))
    ]
