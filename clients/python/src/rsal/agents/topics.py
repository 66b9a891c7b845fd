"""Channels of messages."""

from __future__ import annotations

from dataclasses import is_dataclass
from typing import Any, Generic, TypeVar

from rsal.agents.convert import encode

M = TypeVar("M")


class Topic(Generic[M]):
    """A channel of messages. Those that come with RSAL are named by the class of their messages (``PoseReport``).

    :param name: of the channel; agents in Java hear one of your own as ``new Topic<>("bids", Map.class)``
    :param kind: ``dict``, or a dataclass of your own
    """

    def __init__(self, name: str, kind: type[M]) -> None:
        if kind is not dict and not is_dataclass(kind):
            raise TypeError(f"Messages of topic '{name}' are a dict or a dataclass, not '{kind.__name__}'.")
        self.name = name
        self.kind = kind


def topic_of(of: Any) -> tuple[str, Any]:
    """Name and type of a topic's messages."""
    if isinstance(of, Topic):
        return of.name, of.kind
    if isinstance(of, type) and hasattr(of, "topic"):
        return of.topic, of
    raise TypeError(f"'{of!r}' is no topic. Maybe a class of rsal.agents.messages, or rsal.Topic(name, dict)?")


def topic_content(of: Any, message: Any) -> tuple[str, Any]:
    """Name of a topic and the words of a message, which is the first argument where there is no second."""
    if message is None:
        name, _ = topic_of(type(of))
        return name, encode(of)
    name, kind = topic_of(of)
    if not isinstance(message, kind):
        raise TypeError(f"Topic '{name}' has messages of type '{kind.__name__}', not '{type(message).__name__}'.")
    return name, encode(message)
