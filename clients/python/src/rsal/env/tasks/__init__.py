"""Tasks to learn, each declared once: ``rsal.env.tasks.NAVIGATION.parallel_env()``.

A task is a scenario, the robots that learn, what they observe and do, a reward, and a score of whole episodes. The
scenarios are files beside this one. Gymnasium knows the tasks as ``rsal/Navigation-v0`` and so on.
"""

from __future__ import annotations

from rsal.env.tasks._coverage import COVERAGE
from rsal.env.tasks._foraging import FORAGING
from rsal.env.tasks._formation import FORMATION
from rsal.env.tasks._navigation import NAVIGATION
from rsal.env.tasks._patrol import PATROL
from rsal.env.tasks._pursuit import PURSUIT
from rsal.env.tasks._task import Policy, Task, Team, make, make_vec, register

TASKS: dict[str, Task] = {task.name: task for task in (NAVIGATION, PURSUIT, COVERAGE, FORMATION, FORAGING, PATROL)}
"""All tasks, by name."""

register(TASKS)

__all__ = [
    "COVERAGE",
    "FORAGING",
    "FORMATION",
    "NAVIGATION",
    "PATROL",
    "PURSUIT",
    "TASKS",
    "Policy",
    "Task",
    "Team",
    "make",
    "make_vec",
]
