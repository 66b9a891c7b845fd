"""Begins the process in which the agents of a run live."""

from __future__ import annotations

import os
import signal
import sys

from rsal.protocol import VERSION, Frames


def main() -> None:
    """Take the pipes for frames: what else is read finds nothing, what else is written goes to stderr.

    Ctrl-C on the terminal reaches this process too. RSAL ends the run then, after the agents' ``on_stop``.
    """
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    source = os.fdopen(os.dup(0), "rb")
    sink = os.fdopen(os.dup(1), "wb", buffering=0)
    nothing = os.open(os.devnull, os.O_RDONLY)
    os.dup2(nothing, 0)
    os.dup2(2, 1)
    frames = Frames(source, sink)
    try:
        import numpy  # noqa: F401, PLC0415 - tries whether it is there
    except ImportError:
        frames.write(
            {
                "protocol": VERSION,
                "error": f"Agents in Python need the package 'numpy', which '{sys.executable}' does not have."
                " Maybe 'pip install numpy', or name another Python by RSAL_PYTHON=/path/to/python3.",
            }
        )
        return
    from rsal.agents.worker import work  # noqa: PLC0415 - needs numpy

    work(frames)
