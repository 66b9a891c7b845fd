"""What agents are written with: :class:`Agent` and what it uses. A module is loaded when a name of it is used."""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from rsal.agents.agent import Agent, Blackboard, Entry, Message, Mind, Note, Topic
    from rsal.agents.conversations import Award, Call, Question, Refusal, Result
    from rsal.agents.devices import Device, Goal, Robot, Stamped, Subscription
    from rsal.agents.link import RsalError
    from rsal.agents.network import Network
    from rsal.agents.param import Param
    from rsal.agents.policy import PolicyAgent
    from rsal.agents.values import Point2d, Pose2d, Twist2d
    from rsal.agents.waiting import Pending

_MODULES = {
    "Agent": "agent",
    "Blackboard": "agent",
    "Entry": "agent",
    "Message": "agent",
    "Mind": "agent",
    "Note": "agent",
    "Topic": "agent",
    "Award": "conversations",
    "Call": "conversations",
    "Question": "conversations",
    "Refusal": "conversations",
    "Result": "conversations",
    "Device": "devices",
    "Goal": "devices",
    "Robot": "devices",
    "Stamped": "devices",
    "Subscription": "devices",
    "RsalError": "link",
    "Network": "network",
    "Param": "param",
    "PolicyAgent": "policy",
    "Point2d": "values",
    "Pose2d": "values",
    "Twist2d": "values",
    "Pending": "waiting",
}

__all__ = [
    "Agent",
    "Award",
    "Blackboard",
    "Call",
    "Device",
    "Entry",
    "Goal",
    "Message",
    "Mind",
    "Network",
    "Note",
    "Param",
    "Pending",
    "Point2d",
    "PolicyAgent",
    "Pose2d",
    "Question",
    "Refusal",
    "Result",
    "Robot",
    "RsalError",
    "Stamped",
    "Subscription",
    "Topic",
    "Twist2d",
]


def __getattr__(name: str) -> Any:
    if name in _MODULES:
        return getattr(import_module(f"rsal.agents.{_MODULES[name]}"), name)
    raise AttributeError(f"module 'rsal.agents' has no attribute '{name}'")
