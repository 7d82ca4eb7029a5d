"""Where the command ``robodyn`` begins: before anything else can be interrupted, or fail to be imported."""

from __future__ import annotations


def main() -> int:
    """Run the command of this process; the exit code. Nothing that happens on the way is a traceback."""
    try:
        from robodyn.process import Ended, quiet, received
    except KeyboardInterrupt:
        return 130
    try:
        code = _run()
        quiet()
    except Ended:  # in the moment before or after the work
        code, _ = received()
        quiet()
    return code


def _run() -> int:
    """As :func:`main`, but that a signal raises :class:`robodyn.process.Ended`."""
    from robodyn.process import begin, exit_code, listen, not_imported, quiet

    try:
        begin()
        from robodyn_cli.main import main as run

        listen()
        return run()
    except Exception as error:  # run lets none out
        quiet()
        return exit_code(not_imported(error))
