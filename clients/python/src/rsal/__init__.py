"""Robots and agents: write agents in Python for RSAL. Nothing is loaded until a name of it is used."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from rsal.agents import (
        Agent,
        Message,
        Param,
        Point2d,
        Pose2d,
        Stamped,
        Topic,
        Twist2d,
    )

__all__ = ["Agent", "Message", "Param", "Point2d", "Pose2d", "Stamped", "Topic", "Twist2d"]


def __getattr__(name: str) -> Any:
    if name in __all__:
        import rsal.agents

        return getattr(rsal.agents, name)
    raise AttributeError(f"module 'rsal' has no attribute '{name}'")
