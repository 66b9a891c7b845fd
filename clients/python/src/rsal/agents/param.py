"""Parameters of agents."""

from __future__ import annotations

from typing import Any, Final


class _Required:
    def __repr__(self) -> str:
        return "required"


REQUIRED: Final = _Required()


class Parameter:
    """What is known of a parameter. Its values are checked before a run begins, by what the file says of it."""

    __slots__ = ("default", "name")

    def __init__(self, default: object) -> None:
        self.default = default
        self.name = ""

    def __set_name__(self, owner: type, name: str) -> None:
        self.name = name

    def __get__(self, agent: object, owner: type | None = None) -> Any:
        if agent is None:
            return self
        if isinstance(self.default, _Required):
            raise AttributeError(f"Parameter '{self.name}' has no value: it must be given.")
        return self.default


def Param(  # noqa: N802 - declares, as a type would
    default: Any = REQUIRED,
    *,
    min: float | None = None,  # noqa: A002, ARG001 - read from the file
    max: float | None = None,  # noqa: A002, ARG001 - read from the file
    unit: str = "",  # noqa: ARG001 - read from the file
    choices: list[str] | None = None,  # noqa: ARG001 - read from the file
    robots: bool = False,  # noqa: ARG001 - read from the file
    description: str = "",  # noqa: ARG001 - read from the file
) -> Any:
    """Declare a parameter as a class attribute with an annotation.

    An example is ``speed: float = Param(0.4, min=0, unit="m/s")``.

    All arguments are literals, since RSAL reads them without running the file. The annotation is ``float``, ``int``,
    ``str`` or ``bool``. Without a default, a scenario must give the value.

    :param min: least value of a number
    :param max: greatest value of a number
    :param unit: ``m``, ``s``, ``rad``
    :param choices: the values that a text can have
    :param robots: whether a text names robots of the scenario, by their role or by the id of one
    :param description: a sentence for people
    """
    return Parameter(default)
