"""Small networks, which need nothing but numpy: trained policies of a few hundred numbers."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import numpy.typing as npt

Numbers = npt.NDArray[np.floating[Any]]


class Network:
    """A feed-forward network with tanh in each layer, the last one too, whose outputs are spread over the limits.

    :param scale: by which each number of an observation is divided; the result is cut off at -1 and 1
    :param layers: a row for each output of a layer: weights of its inputs, then the bias
    :param low: the least value of each number of an action
    :param high: the greatest value of each number of an action
    :param choices: number of choices; the greatest output is then the action
    """

    def __init__(
        self,
        scale: Sequence[float],
        layers: Sequence[Sequence[Sequence[float]]],
        low: Sequence[float] = (),
        high: Sequence[float] = (),
        choices: int = 0,
    ) -> None:
        self.scale = np.array(scale, float)
        self.layers = [np.array(layer, float) for layer in layers]
        self.low, self.high = np.array(low, float), np.array(high, float)
        self.choices = choices
        inputs = len(self.scale)
        for number, layer in enumerate(self.layers):
            if layer.ndim != 2 or layer.shape[1] != inputs + 1:  # noqa: PLR2004 - a matrix
                raise ValueError(f"Layer {number} of a network must have rows of {inputs} weights and a bias.")
            inputs = len(layer)
        if inputs != (choices or len(self.low)):
            raise ValueError(f"The last layer of a network has {inputs} outputs, not one for each number of an action.")

    def __call__(self, observations: npt.ArrayLike) -> Numbers:
        """Return actions for observations, whose last axis has the numbers of one learner."""
        values: Numbers = np.clip(np.asarray(observations, float) / self.scale, -1.0, 1.0)
        for layer in self.layers:
            # Not by a product of matrices: its last digits would depend on how many observations there are at once.
            values = np.tanh((values[..., None, :] * layer[:, :-1]).sum(-1) + layer[:, -1])
        if self.choices:
            chosen: Numbers = values.argmax(-1)[..., None].astype(float)
            return chosen
        spread: Numbers = self.low + (values + 1.0) / 2.0 * (self.high - self.low)
        return spread
