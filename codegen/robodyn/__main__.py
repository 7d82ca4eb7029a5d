"""``python -m robodyn`` is ``robodyn``: the one place of the library that knows the command line."""

from __future__ import annotations

import sys


def _main() -> int:
    from robodyn_cli.main import main

    return main()


if __name__ == "__main__":
    sys.exit(_main())
