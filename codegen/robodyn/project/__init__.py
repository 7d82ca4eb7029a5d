"""A project: what ``robodyn.toml`` says is to be written, what was, and how the two differ.

:mod:`.reading` reads the file, :mod:`.fingerprint` says whether anything changed, :mod:`.product` keeps what
was generated, :mod:`.lock` is what is committed of it, :mod:`.compare` finds what differs, and
:mod:`.reports` shows it.
"""
