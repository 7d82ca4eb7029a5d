"""Which words may become names in C, C++, Fortran and Python, and which texts may become comments."""

from __future__ import annotations

import functools
import keyword
import re
import unicodedata
from collections.abc import Iterable

from robodyn.errors import InputError

#: Longest name of a robot. Fortran allows 63 characters, and no function of the default set takes over 17.
ROBOT_NAME_LENGTH = 40
#: Longest name of a run-time parameter: what C99 promises to tell apart.
PARAMETER_NAME_LENGTH = 31
#: Longest free text: a title, a source, the name of a link.
TEXT_LENGTH = 200

_C = """
auto break case char const continue default do double else enum extern float for goto if inline int
long register restrict return short signed sizeof static struct switch typedef union unsigned void
volatile while alignas alignof bool constexpr false nullptr static_assert thread_local true typeof
typeof_unqual
"""
_CPP = """
and and_eq asm bitand bitor catch char8_t char16_t char32_t class co_await co_return co_yield compl
concept const_cast consteval constinit decltype delete dynamic_cast explicit export friend mutable
namespace new noexcept not not_eq operator or or_eq private protected public reinterpret_cast
requires static_cast template this throw try typeid typename using virtual wchar_t xor xor_eq
"""
# Fortran reserves nothing, but a program in which these are names is read by nobody.
_FORTRAN = """
abstract allocatable allocate associate backspace bind block call character class close common
complex concurrent contains critical cycle data deallocate dimension elemental elseif elsewhere end
enddo endfile endif entry enumerator equivalence exit extends external final forall format function
generic go implicit import in inout inquire integer intent interface intrinsic logical module
namelist none nullify only open optional out parameter pointer precision print procedure program
pure read real recursive result return rewind save select sequence stop submodule subroutine target
then to type use where write
"""
_LANGUAGES = {
    word: language
    for language, words in (
        ("Python", " ".join(keyword.kwlist).lower()),
        ("Fortran", _FORTRAN),
        ("C++", _CPP),
        ("C", _C),
    )
    for word in words.split()
}
# Words that stand for a number, or for none, in somebody's mind: never the name of one.
_VALUE_WORDS = frozenset(
    ["pi", "nan", "inf", "infinity", "null", "nil", "true", "false", "yes", "no", "on", "off"]
)
# NAME.h must not stand in for a header that those of the C library include, and NAME.c must be a file on
# every system. After the standard's: glibc's, musl's and newlib's, those of macOS and BSD, of Windows.
_HEADERS = """
assert complex ctype errno fenv inttypes iso646 limits locale math setjmp signal stdalign stdarg stdatomic
stdbit stdbool stdckdint stddef stdint stdio stdlib stdnoreturn string tgmath threads time uchar wchar wctype
alloca endian features ieeefp malloc newlib picolibc pthread reent sched strings syslimits unistd xlocale
availability availabilityinternal availabilitymacros availabilityversions gethostuuid osreldate runetype
targetconditionals concurrencysal corecrt crtdbg crtdefs process sal sdkddkver vadefs vcruntime
xkeycheck yvals
"""
_DEVICES = ["con", "prn", "aux", "nul", *(f"{port}{i}" for port in ("com", "lpt") for i in range(1, 10))]

# What NAME_ goes on with in types, macros and include guards of the emitted files.
_ENDINGS = """
real params state h batch_h packed_h parallel_h selftest_h semihosting_h batch_bytes processors spins inline_
apart_ ik_max regressor_columns
"""
# Macros of C and C++ that are spelled like a name: as a member of a struct they would be replaced. The lists
# are longer than any one machine's: a header of the emitted files is read after whatever else a program
# includes, by compilers that nobody here has seen. A test holds them against the headers of this machine.

# Families with a pattern of their own, which new versions of a library add to; C reserves most of them.
_FAMILIES = (
    r"U?INT(MAX|PTR|(_(LEAST|FAST))?\d+)_(C|MAX|MIN|WIDTH)",
    r"([SU]?CHAR|U?(SHRT|INT|LONG|LLONG|LONG_LONG|QUAD)|WCHAR|WINT)_(MAX|MIN|WIDTH|BIT)",
    r"(BOOL|S?SIZE|PTRDIFF|SIG_ATOMIC)_(MAX|MIN|WIDTH)",
    r"(FLT|L?DBL|FLT\d+X?|DEC\d+X?)_[A-Z0-9_]+",
    r"(PRI|SCN)[A-Za-z]((LEAST|FAST)?\d+|MAX|PTR)",
    r"(FE|FP|FPE|LC|ATOMIC|CLOCK|CLONE|PTHREAD|SCHED|CPU|MATH|FRAMA_C)_[A-Z0-9_]+",
    r"(ADJ|BUS|CLD|ILL|ITIMER|MOD|NL|POLL|SA|SEGV|SI|SIGEV|SS|STA|TRAP|XATTR)_[A-Z]{2}[A-Z0-9_]*",
    r"REG_[A-Z0-9]+|S_I[A-Z]{3,}",
    r"M_(E|LOG2E|LOG10E|LN2|LN10|PI|PI_2|PI_4|1_PI|2_PI|2_SQRTPI|SQRT2|SQRT1_2)([fl]|f\d+x?)?",
    r"M_(TWOPI|3PI_4|SQRTPI|LN2LO|LN2HI|SQRT3|IVLN10|LOG2_E|INVLN2)",
    r"(HUGE_VAL|SNAN|CMPLX)\w*",
    r"(atomic|pthread)_[a-z_]+",
    r"(clearerr|feof|ferror|(get|put)char)_unlocked",
    r"(be|le)(16|32|64)toh|hto(be|le)(16|32|64)",
)
# Of the C library: the standard's, those of POSIX, of glibc, newlib and Frama-C.
_LIBRARY = """
AIO_PRIO_DELTA_MAX ARG_MAX BC_BASE_MAX BC_DIM_MAX BC_SCALE_MAX BC_STRING_MAX BIG_ENDIAN BUFSIZ BYTE_ORDER
CHARCLASS_NAME_MAX CHILD_MAX CLK_TCK CLOCKS_PER_SEC CLOSE_RANGE_CLOEXEC CLOSE_RANGE_UNSHARE COLL_WEIGHTS_MAX
CSIGNAL DECIMAL_DIG DELAYTIMER_MAX DOMAIN EXIT_FAILURE EXIT_SUCCESS EXPR_NEST_MAX FD_CLR FD_ISSET FD_SET
FD_SETSIZE FD_ZERO FILENAME_MAX FOPEN_MAX F_LOCK F_OK F_TEST F_TLOCK F_ULOCK HOST_NAME_MAX HUGE I INFINITY
MAXFLOAT IOV_MAX LINE_MAX LINK_MAX LITTLE_ENDIAN LOGIN_NAME_MAX LONG_BIT L_INCR L_SET L_XTND L_ctermid
L_cuserid L_tmpnam MAX_CANON MAX_INPUT MB_CUR_MAX MB_LEN_MAX MINSIGSTKSZ MQ_OPEN_MAX MQ_PRIO_MAX NAME_MAX
NAN NCARGS NFDBITS NGREG NGROUPS_MAX NOFILE NSIG NULL NZERO ONCE_FLAG_INIT OPEN_MAX OVERFLOW PAGESIZE
PAGE_SIZE PATH_MAX PDP_ENDIAN PIPE_BUF PLOSS P_tmpdir RAND_MAX RENAME_EXCHANGE RENAME_NOREPLACE
RENAME_WHITEOUT RE_DUP_MAX RTSIG_MAX R_OK SEEK_CUR SEEK_DATA SEEK_END SEEK_HOLE SEEK_SET SEM_NSEMS_MAX
SEM_VALUE_MAX SIGQUEUE_MAX SING STDERR_FILENO STDIN_FILENO STDOUT_FILENO STREAM_MAX SYMLINK_MAX SYMLOOP_MAX
TIMER_ABSTIME TIMER_MAX TIME_ACTIVE TIME_MONOTONIC TIME_THREAD_ACTIVE TIME_UTC TLOSS TMP_MAX
TSS_DTOR_ITERATIONS TTY_NAME_MAX TZNAME_MAX UNDERFLOW WORD_BIT W_OK X_OK X_TLOSS SIGABRT SIGALRM SIGBUS
SIGCHLD SIGCLD SIGCONT SIGEMT SIGFPE SIGHUP SIGILL SIGINFO SIGINT SIGIO SIGIOT SIGKILL SIGLOST SIGPIPE
SIGPOLL SIGPROF SIGPWR SIGQUIT SIGRTMAX SIGRTMIN SIGSEGV SIGSTKFLT SIGSTKSZ SIGSTOP SIGSYS SIGTERM SIGTHR
SIGTRAP SIGTSTP SIGTTIN SIGTTOU SIGUNUSED SIGURG SIGUSR1 SIGUSR2 SIGVTALRM SIGWINCH SIGXCPU SIGXFSZ
SIG_BLOCK SIG_DFL SIG_ERR SIG_GET SIG_HOLD SIG_IGN SIG_SETMASK SIG_SGE SIG_UNBLOCK WCONTINUED WEOF WEXITED
WEXITSTATUS WIFCONTINUED WIFEXITED WIFSIGNALED WIFSTOPPED WNOHANG WNOWAIT WSTOPPED WSTOPSIG WTERMSIG
WUNTRACED iscanonical iseqsig isfinite isgreater isgreaterequal isinf isless islessequal islessgreater isnan
isnormal issignaling issubnormal isunordered iszero sa_handler sa_sigaction sched_priority si_addr
si_addr_lsb si_arch si_band si_call_addr si_fd si_int si_lower si_overrun si_pid si_pkey si_ptr si_status
si_stime si_syscall si_timerid si_uid si_upper si_utime si_value sigev_notify_attributes
sigev_notify_function va_arg va_copy va_end va_start alloca assert complex errno fpclassify imaginary
kill_dependency math_errhandling noreturn offsetof sighandler_t sigmask signbit signgam static_assert stderr
stdin stdout strdupa strndupa u_int8_t u_int16_t u_int32_t u_int64_t unreachable HAVE_INITFINI_ARRAY
TIMESPEC_TO_TIMEVAL TIMEVAL_TO_TIMESPEC clearerr fast_putc fd_set feof ferror fropen fwopen log2 physadr quad
strtodf tzname
"""
# Of <errno.h>, of Linux and others, and the end of a file.
_ERRORS = """
E2BIG EACCES EADDRINUSE EADDRNOTAVAIL EADV EAFNOSUPPORT EAGAIN EALREADY EAUTH EBADARCH EBADE EBADEXEC EBADF
EBADFD EBADMACHO EBADMSG EBADR EBADRPC EBADRQC EBADSLT EBFONT EBUSY ECANCELED ECAPMODE ECASECLASH ECHILD
ECHRNG ECOMM ECONNABORTED ECONNREFUSED ECONNRESET EDEADLK EDEADLOCK EDESTADDRREQ EDEVERR EDOM EDOOFUS
EDOTDOT EDQUOT EEXIST EFAULT EFBIG EFTYPE EHOSTDOWN EHOSTUNREACH EHWPOISON EIDRM EILSEQ EINPROGRESS
EINTEGRITY EINTR EINVAL EIO EISCONN EISDIR EISNAM EKEYEXPIRED EKEYREJECTED EKEYREVOKED EL2HLT EL2NSYNC
EL3HLT EL3RST ELBIN ELIBACC ELIBBAD ELIBEXEC ELIBMAX ELIBSCN ELNRNG ELOOP EMEDIUMTYPE EMFILE EMLINK EMSGSIZE
EMULTIHOP ENAMETOOLONG ENAVAIL ENEEDAUTH ENETDOWN ENETRESET ENETUNREACH ENFILE ENMFILE ENOANO ENOATTR
ENOBUFS ENOCSI ENODATA ENODEV ENOENT ENOEXEC ENOKEY ENOLCK ENOLINK ENOMEDIUM ENOMEM ENOMSG ENONET ENOPKG
ENOPOLICY ENOPROTOOPT ENOSPC ENOSR ENOSTR ENOSYS ENOTBLK ENOTCAPABLE ENOTCONN ENOTDIR ENOTEMPTY ENOTNAM
ENOTRECOVERABLE ENOTSOCK ENOTSUP ENOTTY ENOTUNIQ ENXIO EOPNOTSUPP EOTHER EOVERFLOW EOWNERDEAD EPERM
EPFNOSUPPORT EPIPE EPROCLIM EPROCUNAVAIL EPROGMISMATCH EPROGUNAVAIL EPROTO EPROTONOSUPPORT EPROTOTYPE
EPWROFF EQFULL ERANGE EREMCHG EREMOTE EREMOTEIO ERESTART ERFKILL EROFS ERPCMISMATCH ESHLIBVERS ESHUTDOWN
ESOCKTNOSUPPORT ESPIPE ESRCH ESRMNT ESTALE ESTRPIPE ETIME ETIMEDOUT ETOOMANYREFS ETXTBSY EUCLEAN EUNATCH
EUSERS EWOULDBLOCK EXDEV EXFULL EOF
"""
# Of compilers, where they are not told to keep to the standard: the names of machines, old and new. near, far
# and their like are empty macros of <windows.h>.
_COMPILERS = """
AVR AVR32 BFIN LANGUAGE_C MIPSEB MIPSEL MSDOS MSP430 NIOS2 PPC R3000 R4000 SYSTYPE_BSD WIN32 WIN64 WINNT arm
bfin bsdi cdecl cris far frv h8300 hp9000s800 hppa hpux i386 i586 i686 interface linux m68k mc68000 mc68020
mc68030 mc68040 mips near nios2 ns32000 pascal pdp11 rs6000 sgi sparc spu sun svr4 ultrix unix vax
"""
# Of the emitted files: of NAME_batch.c, and registers in NAME_image.c.
_OURS = r"LANES(_[A-Z]+)?|RESTRICT|WITH_AVX(2|512)|TRY_AVX(2|512)|WIDEST|CHUNK|SYST_(CSR|RVR|CVR)"

_LIBRARY_NAMES = frozenset(f"{_LIBRARY} {_ERRORS}".split())
_COMPILER_NAMES = frozenset(_COMPILERS.split())
_IDENTIFIER = re.compile(r"[A-Za-z][A-Za-z0-9_]*\Z")
# Joiners, which some scripts and emoji need, and the hyphen that shows only where a line ends.
_HARMLESS = frozenset("\u00ad\u200c\u200d")


def is_unprintable(c: str) -> bool:
    """Whether the character ``c`` is a control character, ends a line, is half of one, or cannot be seen:
    such as the marks that turn the direction of writing, with which text is not what it looks like."""
    return unicodedata.category(c) in ("Cc", "Cf", "Cs", "Zl", "Zp") and c not in _HARMLESS


def _unprintable(text: str) -> str | None:
    """The first unprintable character of ``text``."""
    return None if text.isascii() and text.isprintable() else next(filter(is_unprintable, text), None)


def shown(text: str, length: int = 40) -> str:
    """``text`` quoted for an error message: shortened, control characters escaped, one line."""
    short = text if len(text) <= length else text[: length - 3] + "..."
    return ascii(short) if _unprintable(short) else f"'{short}'"


def _identifier_fault(name: str, length: int) -> str | None:
    if not _IDENTIFIER.match(name):
        if name.startswith("_"):
            return "begins with an underscore, which Fortran forbids"
        return "is not a name in C and Fortran"
    if len(name) > length:
        return f"has {len(name)} characters, {length} are allowed"
    language = _LANGUAGES.get(name.lower())
    return f"is a keyword of {language}" if language else None


def macro_of(name: str) -> str | None:
    """Whose macro ``name`` is, in words for a message; None: it is no macro that is known here."""
    if name in _LIBRARY_NAMES or re.fullmatch("|".join(_FAMILIES), name):
        return "the C library"
    if name in _COMPILER_NAMES:
        return "C compilers"
    return "the emitted files" if re.fullmatch(_OURS, name) else None


def robot_name_fault(name: str) -> str | None:
    """What keeps ``name`` from being a robot's name, or None.

    It prefixes every emitted symbol and is the stem of every emitted file.
    """
    fault = _identifier_fault(name, ROBOT_NAME_LENGTH)
    if fault is None and name.lower() in _HEADERS.split():
        fault = f"would make a file that hides the C header <{name.lower()}.h>"
    if fault is None and name.lower() in _DEVICES:
        fault = "is the name of a device on Windows"
    return fault


def parameter_name_fault(name: str) -> str | None:
    """What keeps ``name`` from being a run-time parameter's name, or None.

    A parameter is a member of the struct ``NAME_params`` (``p->m_tool``, in Fortran ``p%m_tool``), so
    only keywords and macros can clash, and what :func:`parameter_clash` tells.
    """
    if name.lower() in _VALUE_WORDS:
        return "is not a number, nor free to be a name"
    fault = _identifier_fault(name, PARAMETER_NAME_LENGTH)
    owner = macro_of(name)
    return f"is a macro of {owner}" if fault is None and owner else fault


@functools.lru_cache(maxsize=1 << 16)  # every function of an arm has a t1
def is_reserved(name: str) -> bool:
    """Whether ``name`` may not be that of a variable: it is a keyword, a type or a macro somewhere."""
    return name.lower() in _LANGUAGES or name.endswith("_t") or macro_of(name) is not None


def parameter_clash(name: str, robot: str) -> str | None:
    """What keeps the parameter ``name`` out of a robot of the name ``robot``, or None.

    The emitted files' types, macros and include guards have these names: as a member, ``arm_real arm_real``
    is no C++, and ``ARM_H`` is nothing at all.
    """
    if name.lower().startswith(f"{robot}_".lower()) and name.lower()[len(robot) + 1 :] in _ENDINGS.split():
        return "is a name of the emitted files"
    return None


def text_fault(text: str) -> str | None:
    """What keeps ``text`` from being a title, a source or a link's name, or None.

    Such text is written into comments of the emitted files. ``*/`` and the like may be in it: the
    emitter escapes them.
    """
    if len(text) > TEXT_LENGTH:
        return f"has {len(text)} characters, {TEXT_LENGTH} are allowed"
    return unprintable_fault(text)


def unprintable_fault(text: str) -> str | None:
    """What keeps ``text`` from being a line that may be as long as it will, or None."""
    bad = _unprintable(text)
    return f"contains the control character U+{ord(bad):04X}" if bad else None


def check_robot_name(name: str) -> str:
    """``name`` itself if it may name a robot.

    Raises
    ------
    InputError: it may not.
    """
    fault = robot_name_fault(name)
    if fault:
        raise InputError(
            f"the robot's name {fault}",
            found=shown(name),
            expected=ROBOT_NAME_EXPECTED,
            remedy="choose another name",
        )
    return name


def check_names(robot: str, parameters: Iterable[str]) -> None:
    """Make sure that a robot of the name ``robot`` with these run-time ``parameters`` can be emitted, whoever
    made it: a description was checked when it was read.

    Raises
    ------
    InputError: a name cannot stand in the emitted files.
    """
    check_robot_name(robot)
    for name in parameters:
        fault = parameter_name_fault(name) or parameter_clash(name, robot)
        if fault:
            raise InputError(
                f"the run-time parameter {fault}",
                found=shown(name),
                expected=PARAMETER_NAME_EXPECTED,
                remedy="choose another name",
            )


ROBOT_NAME_EXPECTED = (
    f"a letter, then letters, digits or underscores, at most {ROBOT_NAME_LENGTH} characters, no keyword"
)
PARAMETER_NAME_EXPECTED = (
    f"a letter, then letters, digits or underscores, at most {PARAMETER_NAME_LENGTH} characters, no keyword, "
    "no macro of C"
)
