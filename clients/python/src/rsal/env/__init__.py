"""Scenarios of RSAL as environments in which robots learn: for PettingZoo, Gymnasium, and many worlds at once.

Robots of one role learn, all other robots and agents take part as the scenario says. A child process in Java simulates
all worlds of an environment; nothing of it is in this process. The same seed and the same actions give the same bytes.
"""

from __future__ import annotations

from rsal.env._spec import Act, Observe
from rsal.env._vector import VectorScenario, make_vec
from rsal.env._view import Reward, Rules, View
from rsal.env._worlds import Layout, RsalCrashed
from rsal.launch import RsalError

_missing = ""
"""The package that is not installed, which all but :func:`make_vec` needs."""
try:
    from rsal.env._parallel import ParallelScenario, parallel_env
    from rsal.env._single import SingleScenario, single_env
    from rsal.env._team_vector import TeamVector
    from rsal.env.tasks import TASKS  # Gymnasium knows them from then on
except ModuleNotFoundError as error:
    if error.name not in ("gymnasium", "pettingzoo"):
        raise
    _missing = error.name

__all__ = [
    "TASKS",
    "Act",
    "Layout",
    "Observe",
    "ParallelScenario",
    "Reward",
    "RsalCrashed",
    "Rules",
    "SingleScenario",
    "TeamVector",
    "VectorScenario",
    "View",
    "make_vec",
    "parallel_env",
    "single_env",
]


def __getattr__(name: str) -> object:
    if _missing and name in __all__:
        raise RsalError(
            f"'{name}' needs the package {_missing}, which is not installed. Try 'pip install \"rsal[env]\"'."
        )
    raise AttributeError(f"Module 'rsal.env' has no name '{name}'. It has {', '.join(__all__)}.")
