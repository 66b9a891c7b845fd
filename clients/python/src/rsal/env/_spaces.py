"""Spaces of Gymnasium for the numbers of an environment."""

from __future__ import annotations

from typing import Any

import numpy as np
from gymnasium import spaces

from rsal.env._worlds import Layout


def observation_space(layout: Layout) -> spaces.Space[Any]:
    """Return the space of one learner's observations."""
    return spaces.Box(layout.low, layout.high, dtype=np.float32)


def action_space(layout: Layout) -> spaces.Space[Any]:
    """Return the space of one learner's actions."""
    if layout.choices:
        return spaces.Discrete(layout.choices)
    return spaces.Box(layout.action_low, layout.action_high, dtype=np.float32)
