"""Studies: start runs and sweeps, read their results and recordings, and connect to running sessions.

All of it goes through RSAL's commands and what they write: ``rsal run --json``, the rows of ``rsal sweep``, the tables
of ``rsal report`` and ``rsal export``, and the server of a page. So results in Python are those of the command line.

Lengths are in meters, angles in radians (counter-clockwise), times in seconds, and poses in the map frame.
"""

from __future__ import annotations

from rsal.studies._command import CommandFailed
from rsal.studies._recordings import OccupancyMap, Recording, Scans, load
from rsal.studies._runs import Pose, Result, RunFailed, run
from rsal.studies._sessions import Event, Events, GoalResult, Session, SessionError, connect, serve
from rsal.studies._sweeps import Report, report, rows, sweep

__all__ = [
    "CommandFailed",
    "Event",
    "Events",
    "GoalResult",
    "OccupancyMap",
    "Pose",
    "Recording",
    "Report",
    "Result",
    "RunFailed",
    "Scans",
    "Session",
    "SessionError",
    "connect",
    "load",
    "report",
    "rows",
    "run",
    "serve",
    "sweep",
]
