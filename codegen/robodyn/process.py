"""The process of a command, from its first line to its last: whatever ends it, there is one line at most.

Python answers Ctrl-C (SIGINT) with an exception wherever it happens to be, other signals by ending at once.
In a command, instead: while it begins (:func:`begin`) any signal ends it at once; while it works
(:func:`listen`) the first one raises :class:`Ended`, so that temporary files are removed and what was started
is ended; when it is about to leave (:func:`quiet`) they no longer matter.
"""

from __future__ import annotations

import os
import sys

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from types import FrameType
    from typing import Any

#: After so many seconds another signal ends the process at once: something does not let go.
PATIENCE = 1.0
#: After so many seconds the first one does: the process is in a library that does not come back.
GRACE = 5.0
#: While modules are imported a signal waits, looked at again after so many seconds: what imports them may be
#: C code that answers every exception with a traceback.
WAIT = 0.02
_WORDS = {"SIGINT": "interrupted", "SIGTERM": "terminated", "SIGHUP": "hung up"}


class Ended(KeyboardInterrupt):
    """A signal asks for the end."""


class _State:
    """What has come (a number of a signal, or 0), since when further signals are no matter, and how many
    :class:`Held` there are."""

    received = 0
    quiet: float | None = None
    held = 0


class Held:
    """A context in which no :class:`Ended` is raised, and no :class:`KeyboardInterrupt` where Python's own
    handler raises it: a signal that comes in between waits for the end of the context."""

    def __init__(self) -> None:
        import threading

        # Signals are the main thread's; what others do neither needs this nor may count along.
        self.counts = int(threading.current_thread() is threading.main_thread())
        self.replaced = self.interrupted = False

    def __enter__(self) -> Held:
        import signal

        _State.held += self.counts
        if self.counts and signal.getsignal(signal.SIGINT) is signal.default_int_handler:
            self.replaced = True
            signal.signal(signal.SIGINT, self._wait)
        return self

    def __exit__(self, *_: object) -> None:
        import signal

        _State.held -= self.counts
        if self.replaced:
            signal.signal(signal.SIGINT, signal.default_int_handler)
        if self.interrupted:
            raise KeyboardInterrupt

    @property
    def has_signal(self) -> bool:
        """Whether a signal waits for the end of the context."""
        return self.interrupted or bool(_State.received and _State.quiet is None)

    def _wait(self, *_: object) -> None:
        self.interrupted = True


def begin() -> None:
    """Let SIGINT end the process at once, without a word, unless it is ignored or somebody's own."""
    try:
        import signal

        if signal.getsignal(signal.SIGINT) is signal.default_int_handler:
            signal.signal(signal.SIGINT, signal.SIG_DFL)
    except KeyboardInterrupt:
        os._exit(130)


def not_imported(error: Exception) -> int:
    """Say that robodyn cannot even be imported; the exit code: 74 where the operating system refuses, else
    3, as of a tool that is missing."""
    few = "Too many open files" in str(error)
    refused = few or isinstance(error, (OSError, MemoryError))
    what = "the limit of open files is too low" if few else "the operating system refused"
    what = what if refused else "robodyn, or a library that it needs, is not installed as a whole"
    text = " ".join(f"robodyn: error: {what}: {str(error) or type(error).__name__}".split())
    text += "; raise it with ulimit -n 256" if few else "" if refused else "; install robodyn again"
    try:
        sys.stderr.write(f"{ascii(text)[1:-1]}\n")
        sys.stderr.flush()
    except (AttributeError, OSError, ValueError):  # nobody to tell
        pass
    return 74 if refused else 3


def bound(**limits: int) -> None:
    """Give this process limits by their names in ``resource`` (``CPU`` [s], ``DATA`` [bytes] ...), or those
    that it has where they are lower; none on Windows."""
    try:
        import resource
    except ImportError:
        return
    for name, value in limits.items():
        limit = getattr(resource, f"RLIMIT_{name}")
        _, most = resource.getrlimit(limit)
        least = value if most == resource.RLIM_INFINITY else min(value, most)
        resource.setrlimit(limit, (least, least))


def listen() -> None:
    """Let the first SIGINT, SIGTERM or SIGHUP raise :class:`Ended` in the main thread, from now on.

    What is ignored (``nohup``, a shell's background) stays so. Where a library keeps the main thread for
    longer than :data:`GRACE` the process ends without it.
    """
    import signal

    numbers = [getattr(signal, name) for name in _WORDS if hasattr(signal, name)]
    for signum in numbers:
        if signal.getsignal(signum) in (signal.SIG_DFL, signal.default_int_handler):
            signal.signal(signum, _handle)
    if hasattr(signal, "SIGALRM"):
        signal.signal(signal.SIGALRM, _handle)
    sys.unraisablehook = _again
    _watch()


def quiet() -> None:
    """The work is done, or has failed: from now on no signal raises anything.

    A signal that waits is looked at no more: its timer would run out when the interpreter has taken back its
    handlers, and end the process by SIGALRM.
    """
    import signal
    from time import monotonic

    if _State.quiet is None:
        _State.quiet = monotonic()
    if hasattr(signal, "setitimer"):
        signal.setitimer(signal.ITIMER_REAL, 0.0)


def received() -> tuple[int, str]:
    """The exit code that the signal asks for, and a word for it; as for Ctrl-C where there was none."""
    import signal

    signum = _State.received or signal.SIGINT
    return 128 + signum, _WORDS.get(signal.Signals(signum).name, "ended")


def exit_code(code: int) -> int:
    """The exit code of a command that failed with ``code``: the signal's, if one came before its end."""
    return 128 + _State.received if _State.received and code else code


def _handle(signum: int, frame: FrameType | None) -> None:
    import signal
    from time import monotonic

    alarm = getattr(signal, "SIGALRM", None)
    if signum == alarm:
        signum = _State.received
        if not signum or _State.quiet is not None:
            return
    elif _State.received or _State.quiet is not None:  # one was enough, or nothing is left to end
        if _State.quiet is not None and monotonic() - _State.quiet > PATIENCE:
            _leave(signum)
        return
    _State.received = signum
    if (_State.held or _importing(frame)) and alarm is not None:
        signal.setitimer(signal.ITIMER_REAL, WAIT)
        return
    _State.quiet = monotonic()
    raise Ended


def _importing(frame: FrameType | None) -> bool:
    """Whether a module is being imported."""
    while frame is not None:
        if frame.f_code.co_filename.startswith("<frozen importlib"):
            return True
        frame = frame.f_back
    return False


def _again(lost: Any) -> None:
    """Where :class:`Ended` was raised in what cannot raise anything, such as a destructor: once more."""
    if not issubclass(lost.exc_type, Ended):
        sys.__unraisablehook__(lost)
        return
    import signal

    _State.quiet = None
    if hasattr(signal, "SIGALRM"):
        signal.setitimer(signal.ITIMER_REAL, WAIT)
    else:
        _leave(_State.received)


def _watch() -> None:
    """Let a thread of its own see to it that the first signal ends the process in the end."""
    import signal

    try:
        import resource

        if resource.getrlimit(resource.RLIMIT_NOFILE)[0] < 64:  # what there is is for the work
            return
        reader, writer = os.pipe()
        os.set_blocking(writer, False)
        signal.set_wakeup_fd(writer, warn_on_full_buffer=False)
    except (ImportError, OSError, ValueError):
        return
    import _thread

    # A thread that does not wait yet when the interpreter ends is cut off, and complains where no file is
    # left to open.
    waits = _thread.allocate_lock()
    waits.acquire()
    _thread.start_new_thread(_last_resort, (reader, waits.release))
    waits.acquire()


def _last_resort(reader: int, begun: Callable[[], None]) -> None:
    from time import sleep

    begun()
    while True:
        byte = os.read(reader, 1)
        if byte and byte[0] in (1, 2, 15):
            break
    sleep(GRACE)
    _leave(byte[0])


def _leave(signum: int) -> None:
    """End the process, and what it has started, now."""
    running = sys.modules.get("robodyn.toolchain.running")
    if running is not None:
        running.end_all()
    os._exit(128 + signum)
