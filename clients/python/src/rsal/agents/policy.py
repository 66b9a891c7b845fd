"""Trained policies as agents: with the observations and actions of the environment that they were trained in."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, ClassVar

import numpy as np
import numpy.typing as npt

from rsal.agents.agent import Agent
from rsal.agents.convert import _array
from rsal.agents.network import Network, Numbers


class PolicyAgent(Agent):
    """Lets a trained policy drive a robot, simulated or real.

    Write a class that inherits from this with ``observe``, ``act`` and ``period`` as they were in training, and either
    a ``network``, or a ``model`` in ONNX, or a method :meth:`decide` of its own. RSAL computes the observations by the
    same code as in an environment. Observations of the truth of a simulation do not exist here, except for the robot's
    own pose in a simulation.
    """

    observe: ClassVar[Sequence[str | Mapping[str, Any]]] = ("ranges", "velocity")
    """What it observes (``rsal.env.Observe``)."""
    act: ClassVar[str | Mapping[str, Any]] = "velocity"
    """How it acts (``rsal.env.Act``)."""
    period: ClassVar[float] = 0.1
    """Time between two decisions [s]: steps of the environment times 0.1 s."""
    network: ClassVar[Network | None] = None
    """A small network, which needs only numpy."""
    model: ClassVar[str] = ""
    """The file of a model in ONNX with one input and one output of shape (1, n). It needs the package onnxruntime."""

    _model: Model | None = None
    _first = 0.1  # s, after which all sensors have measured, as in environments

    def on_start(self) -> Any:
        """Begin to observe and to act."""
        if self.model:
            self._model = Model(self.model)
        number = self._link.listen(lambda words, arrays: self._decide(_array(words, arrays)))
        observe = [{"type": each} if isinstance(each, str) else dict(each) for each in self.observe]
        act = {"type": self.act} if isinstance(self.act, str) else dict(self.act)
        self._link.do("observe", number, observe, act, self._first, float(self.period))

    def _decide(self, observation: npt.NDArray[np.float32]) -> None:
        action = np.asarray(self.decide(observation), np.float32).ravel()
        self._link.do("act", action.tolist())

    def decide(self, observation: npt.NDArray[np.float32]) -> Numbers:
        """Return the action for an observation: by the network or the model, unless you write it yourself."""
        if self._model is not None:
            return self._model(observation)
        if self.network is None:
            raise TypeError(f"'{type(self).__name__}' has no 'network', no 'model' and no method 'decide'.")
        return self.network(observation)


class Model:
    """A model in ONNX, on one thread: so that it computes the same each time.

    :param file: its file
    """

    def __init__(self, file: str) -> None:
        try:
            import onnxruntime  # noqa: PLC0415 - it is large
        except ImportError as error:
            raise RuntimeError(f"The model '{file}' needs onnxruntime: 'pip install onnxruntime' ({error}).") from error
        if not Path(file).is_file():
            raise FileNotFoundError(f"There is no model '{file}' (from folder '{Path.cwd()}').")
        options = onnxruntime.SessionOptions()
        options.intra_op_num_threads = options.inter_op_num_threads = 1
        self._session = onnxruntime.InferenceSession(file, options, providers=["CPUExecutionProvider"])
        self._input = self._session.get_inputs()[0].name

    def __call__(self, observation: npt.NDArray[np.float32]) -> Numbers:
        """Return the action for one observation."""
        action: Numbers = self._session.run(None, {self._input: observation[None, :]})[0][0]
        return action
