"""Carries out the examples of documents, outside of the tests.

python -m documents README.md docs/schedule.md            report what is not as it is shown
python -m documents --update docs/schedule.md             and put what is printed in its place
python -m documents --list                                what is run of each page, and why others are not
python -m documents --close docs/decisions/0041-so.md     it is the record of its day from now on
"""

from __future__ import annotations

import argparse
import os
import sys
import tempfile
from pathlib import Path

from documents.blocks import PAGES, ROOT, Block, commands, matches, read
from documents.running import Reader, checkout, program_folder


def main() -> int:
    """0 where every example is as it is shown."""
    parser = argparse.ArgumentParser(prog="documents", description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("pages", nargs="*", metavar="PAGE.md")
    parser.add_argument("--update", action="store_true", help="replace what is shown; not where it has dots")
    parser.add_argument(
        "--installed",
        action="store_true",
        help="use the robodyn that is installed, and copies of what the checkout ships",
    )
    parser.add_argument("--list", action="store_true", help="count the examples")
    parser.add_argument(
        "--close", action="store_true", help="write the digest of a decision's text beneath it"
    )
    arguments = parser.parse_args()
    if arguments.list:
        return _list()
    if arguments.close:
        return max(map(_close, arguments.pages))
    return max(_follow(page, arguments.update, arguments.installed) for page in arguments.pages or PAGES)


def _list() -> int:
    executed = elsewhere = 0
    for page in PAGES:
        for block in read(page):
            if not block.is_example:
                continue
            size = len(list(commands(block))) if block.language == "console" else 1
            executed += size * block.is_run
            elsewhere += size * (block.mark == "run by")
            if block.mark == "not run":
                print(f"{page}:{block.line}: not run: {block.detail}")
    print(f"{executed} commands and Python blocks are run, {elsewhere} by other tests or pages")
    return 0


def _close(page: str) -> int:
    # imports robodyn; runs of an installed one do not
    from documents.figures import CLOSED, digest_of, faults

    path = ROOT / page
    text = CLOSED.sub("", path.read_text(encoding="utf-8")).rstrip()
    path.write_text(f"{text}\n\n<!-- closed {digest_of(text)} -->\n", encoding="utf-8")
    return int(bool(faults(path.read_text(encoding="utf-8"))))


def _follow(page: str, update: bool, installed: bool) -> int:
    faults: list[str] = []
    text = (ROOT / page).read_text(encoding="utf-8")
    start = sum(os.times()[:4])
    with tempfile.TemporaryDirectory() as folder:
        root = checkout(Path(folder) / "checkout", copy=installed)
        reader = Reader(root, () if installed else (program_folder(Path(folder) / "bin"),))
        for block in read(page):
            if update and block.is_run and block.language == "console":
                text = text.replace(block.text, _printed(reader, block))
            else:
                faults += reader.follow(block)
    if update:
        (ROOT / page).write_text(text, encoding="utf-8")
    seconds = sum(os.times()[:4]) - start  # of processors, of this process and what it started
    print(f"{page}: {seconds:.1f} s, {len(faults)} faults", file=sys.stderr)
    print("\n".join(faults), end="")
    return int(bool(faults))


def _printed(reader: Reader, block: Block) -> str:
    """The text of the block with what its commands print, where that is shown without dots."""
    lines = []
    for command, output, _ in reader.outputs(block):
        shown = command.output
        if shown and "..." not in shown and not matches(shown, output):
            shown = "\n".join(line.rstrip() for line in output.rstrip().splitlines())
        lines.append(f"$ {command.text}\n" + (f"{shown}\n" if shown else ""))
    return "".join(lines)


if __name__ == "__main__":
    sys.exit(main())
