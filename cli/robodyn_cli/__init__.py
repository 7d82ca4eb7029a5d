"""The command line of robodyn: one file a command, no mathematics."""

import sys

_BEGUN = (sys.argv or [""])[0]  # of python -m, while it looks for the module: -m
if _BEGUN.endswith(("robodyn", "robodyn.exe")) or (_BEGUN == "-m" and "robodyn_cli" in sys.orig_argv):
    try:  # a command begins here
        from robodyn.process import begin

        begin()
    except KeyboardInterrupt:
        sys.exit(130)
