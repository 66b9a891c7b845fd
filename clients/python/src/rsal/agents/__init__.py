"""What agents are written with: :class:`Agent` and what it uses. A module is loaded when a name of it is used."""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from rsal.agents.agent import Agent, Blackboard, Entry, Message, Mind, Note
    from rsal.agents.boards import BoardEvent, BoardNote, BoardWatch, Found, TeamBoard
    from rsal.agents.conversations import Award, Call, Offer, Question, Refusal, Result, Sale, Subscriber
    from rsal.agents.devices import Device, Goal, Percept, Robot, Stamped, Subscription
    from rsal.agents.network import Network
    from rsal.agents.param import Param
    from rsal.agents.policy import PolicyAgent
    from rsal.agents.topics import Topic
    from rsal.agents.values import Point2d, Pose2d, Twist2d
    from rsal.agents.waiting import Pending
    from rsal.errors import RsalError

_MODULES = {
    "Agent": "agent",
    "Blackboard": "agent",
    "Entry": "agent",
    "Message": "agent",
    "Mind": "agent",
    "Note": "agent",
    "BoardEvent": "boards",
    "BoardNote": "boards",
    "BoardWatch": "boards",
    "Found": "boards",
    "TeamBoard": "boards",
    "Award": "conversations",
    "Call": "conversations",
    "Offer": "conversations",
    "Question": "conversations",
    "Refusal": "conversations",
    "Sale": "conversations",
    "Result": "conversations",
    "Subscriber": "conversations",
    "Device": "devices",
    "Goal": "devices",
    "Percept": "devices",
    "Robot": "devices",
    "Stamped": "devices",
    "Subscription": "devices",
    "Network": "network",
    "Param": "param",
    "PolicyAgent": "policy",
    "Topic": "topics",
    "Point2d": "values",
    "Pose2d": "values",
    "Twist2d": "values",
    "Pending": "waiting",
}

__all__ = [
    "Agent",
    "Award",
    "Blackboard",
    "BoardEvent",
    "BoardNote",
    "BoardWatch",
    "Call",
    "Device",
    "Entry",
    "Found",
    "Goal",
    "Message",
    "Mind",
    "Network",
    "Note",
    "Offer",
    "Param",
    "Pending",
    "Percept",
    "Point2d",
    "PolicyAgent",
    "Pose2d",
    "Question",
    "Refusal",
    "Result",
    "Robot",
    "RsalError",
    "Sale",
    "Stamped",
    "Subscriber",
    "Subscription",
    "TeamBoard",
    "Topic",
    "Twist2d",
]


def __getattr__(name: str) -> Any:
    if name == "RsalError":
        return getattr(import_module("rsal.errors"), name)
    if name in _MODULES:
        return getattr(import_module(f"rsal.agents.{_MODULES[name]}"), name)
    raise AttributeError(f"module 'rsal.agents' has no attribute '{name}'")
