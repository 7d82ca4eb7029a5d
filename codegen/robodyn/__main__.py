"""``python -m robodyn`` is ``robodyn``: the one place of the library that knows the command line."""

from __future__ import annotations

import sys


def _main() -> int:
    from robodyn.process import not_imported

    try:
        from robodyn_cli.entry import main
    except Exception as error:
        return not_imported(error)
    return main()


if __name__ == "__main__":
    sys.exit(_main())
