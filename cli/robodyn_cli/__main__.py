"""``python -m robodyn_cli`` is ``robodyn``."""

from __future__ import annotations

import sys

from robodyn_cli.entry import main

if __name__ == "__main__":
    sys.exit(main())
