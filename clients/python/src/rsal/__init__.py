"""RSAL from Python: agents, learning environments, runs and their results, and running sessions.

``import rsal`` loads nothing else and starts no Java. A name of the table below loads its module when it is used.
"""

from __future__ import annotations

__version__ = "0.1.0"

#: Each public name of this package, by the module that has it.
_NAMES = {
    "Agent": "rsal.agents",
    "Message": "rsal.agents",
    "Param": "rsal.agents",
    "Point2d": "rsal.agents",
    "Pose2d": "rsal.agents",
    "RsalError": "rsal.errors",
    "Stamped": "rsal.agents",
    "Topic": "rsal.agents",
    "Twist2d": "rsal.agents",
    "connect": "rsal.studies",
    "load": "rsal.studies",
    "make_vec": "rsal.env",
    "parallel_env": "rsal.env",
    "report": "rsal.studies",
    "rows": "rsal.studies",
    "run": "rsal.studies",
    "serve": "rsal.studies",
    "single_env": "rsal.env",
    "sweep": "rsal.studies",
}

TYPE_CHECKING = False  # type checkers know better; the module typing would take most of the time of this import
if TYPE_CHECKING:
    from rsal.agents import Agent as Agent
    from rsal.agents import Message as Message
    from rsal.agents import Param as Param
    from rsal.agents import Point2d as Point2d
    from rsal.agents import Pose2d as Pose2d
    from rsal.agents import Stamped as Stamped
    from rsal.agents import Topic as Topic
    from rsal.agents import Twist2d as Twist2d
    from rsal.env import make_vec as make_vec
    from rsal.env import parallel_env as parallel_env
    from rsal.env import single_env as single_env
    from rsal.errors import RsalError as RsalError
    from rsal.studies import connect as connect
    from rsal.studies import load as load
    from rsal.studies import report as report
    from rsal.studies import rows as rows
    from rsal.studies import run as run
    from rsal.studies import serve as serve
    from rsal.studies import sweep as sweep


def __getattr__(name: str) -> object:
    module = _NAMES.get(name)
    if module is None:
        raise AttributeError(f"Module 'rsal' has no name '{name}'. It has {', '.join(sorted(_NAMES))}.")
    import importlib  # noqa: PLC0415 - not every program needs it

    value = getattr(importlib.import_module(module), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted({*globals(), *_NAMES})
