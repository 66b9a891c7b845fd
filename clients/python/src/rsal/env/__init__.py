"""Scenarios of RSAL as environments in which robots learn: for PettingZoo, Gymnasium, and many worlds at once.

Robots of one role learn, all other robots and agents take part as the scenario says. A child process in Java simulates
all worlds of an environment; nothing of it is in this process. The same seed and the same actions give the same bytes.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from rsal.env._spec import Act, Observe
from rsal.env._vector import VectorScenario, make_vec
from rsal.env._view import Reward, Rules, View
from rsal.env._worlds import Layout, RsalCrashed
from rsal.launch import RsalError

if TYPE_CHECKING:
    from rsal.env._parallel import ParallelScenario, parallel_env
    from rsal.env._single import SingleScenario, single_env
    from rsal.env.tasks import TASKS

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
    "VectorScenario",
    "View",
    "make_vec",
    "parallel_env",
    "single_env",
]

_LAZY = {
    "ParallelScenario": "rsal.env._parallel",
    "SingleScenario": "rsal.env._single",
    "TASKS": "rsal.env.tasks",
    "parallel_env": "rsal.env._parallel",
    "single_env": "rsal.env._single",
}
"""Names that need gymnasium or pettingzoo, which :func:`make_vec` does not."""


def __getattr__(name: str) -> object:
    module = _LAZY.get(name)
    if module is None:
        raise AttributeError(f"Module 'rsal.env' has no name '{name}'. It has {', '.join(__all__)}.")
    import importlib  # noqa: PLC0415 - seldom needed

    try:
        value: object = getattr(importlib.import_module(module), name)
    except ModuleNotFoundError as error:
        if error.name not in ("gymnasium", "pettingzoo"):
            raise
        raise RsalError(
            f"'{name}' needs the package {error.name}, which is not installed. Try 'pip install \"rsal[env]\"'."
        ) from error
    globals()[name] = value
    return value
