"""Where the command ``robodyn`` begins: before anything else can be interrupted, or fail to be imported."""

from __future__ import annotations


def main() -> int:
    """Run the command of this process; the exit code. Nothing that happens on the way is a traceback."""
    try:
        from robodyn.process import Ended, begin, listen, not_imported, quiet, received
    except KeyboardInterrupt:
        return 130
    try:
        begin()
        from robodyn_cli.main import main as run

        listen()
        code = run()
        quiet()
    except Ended:  # in the moment before or after the work
        code, _ = received()
    except Exception as error:  # run lets none out
        return not_imported(error)
    return code
