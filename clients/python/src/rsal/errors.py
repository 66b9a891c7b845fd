"""What RSAL cannot do, as an exception: in agents, runs and environments."""

from __future__ import annotations


class RsalError(Exception):
    """Something that RSAL cannot do: what, where, with which value, and what to try."""
