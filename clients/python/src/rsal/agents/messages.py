"""Messages of the topics that come with RSAL.

Generated from Java by `PythonValuesTest`: do not edit.
"""

from __future__ import annotations

import enum
from dataclasses import dataclass
from typing import ClassVar

from rsal.agents.values import Point2d, Pose2d, Rgb


@dataclass(frozen=True, slots=True)
class Alarm:
    """A robot sees an intruder. The robot repeats this as long as it sees the intruder.

    :param robot: id of the robot that sees the intruder
    :param map_from_intruder: position of the intruder, in the map frame [m]
    """

    topic: ClassVar[str] = "alarm"

    robot: str
    map_from_intruder: Point2d


@dataclass(frozen=True, slots=True)
class Bid:
    """A bid for a job.

    :param job: its number in the auction
    :param bidder: name of a member; empty for nobody
    :param cost: the lower, the better; +∞ for what nobody can do
    """

    job: int
    bidder: str
    cost: float


@dataclass(frozen=True, slots=True)
class Said:
    """What a member says.

    :param version: grows with every change of the sender's bids, from 1
    :param bids: by the rules of the allocation
    :param known: the version of each other member of which the sender knows, by name
    """

    version: int
    bids: list[Bid]
    known: dict[str, int]


@dataclass(frozen=True, slots=True)
class AuctionBids:
    """What a member says to the other members of an auction. Only the newest of each member counts.

    :param team: name of the agent that has the jobs
    :param auction: number of its call
    :param takes_part: whether the sender bids at all
    :param said: its bids
    """

    topic: ClassVar[str] = "auction-bids"

    team: str
    auction: int
    takes_part: bool
    said: Said


@dataclass(frozen=True, slots=True)
class Caught:
    """A prey has given up. The prey says so once.

    :param prey: id of its robot
    :param hunter: id of the robot that has caught the prey
    :param distance: distance between the two, as the prey estimates it [m]
    """

    topic: ClassVar[str] = "caught"

    prey: str
    hunter: str
    distance: float


@dataclass(frozen=True, slots=True)
class ChargerTaken:
    """A robot drives to a charger or is charged there.

    It repeats this; after ten seconds without it, the charger counts as free.

    :param robot: its id
    :param map_from_charger: where the charger is, in the map frame [m]
    """

    topic: ClassVar[str] = "charger-taken"

    robot: str
    map_from_charger: Point2d


@dataclass(frozen=True, slots=True)
class Chase:
    """A hunter chases a prey from now on.

    :param hunter: id of its robot
    :param prey: id of the prey's robot
    """

    topic: ClassVar[str] = "chase"

    hunter: str
    prey: str


@dataclass(frozen=True, slots=True)
class CollectGoal:
    """A thing lies at a place and is to be collected.

    The agent that knows the thing repeats this every few seconds; without this message for longer, agents
    forget the thing.

    :param color: its color, as cameras see it
    :param map_from_thing: where it lies, in the map frame [m]
    """

    topic: ClassVar[str] = "collect-goal"

    color: Rgb
    map_from_thing: Point2d


@dataclass(frozen=True, slots=True)
class Collected:
    """A robot has brought a thing to a depot and released it there.

    :param robot: its id
    :param goal: the thing, as it was announced
    :param map_from_depot: where the depot is, in the map frame [m]
    """

    topic: ClassVar[str] = "collected"

    robot: str
    goal: CollectGoal
    map_from_depot: Point2d


@dataclass(frozen=True, slots=True)
class Depot:
    """A robot brings things to this place. Do not collect things that lie there.

    :param robot: its id
    :param map_from_depot: middle of the depot, in the map frame [m]
    :param radius: of the depot [m]
    """

    topic: ClassVar[str] = "depot"

    robot: str
    map_from_depot: Point2d
    radius: float


@dataclass(frozen=True, slots=True)
class GoalReached:
    """A robot's drive to a goal has ended.

    :param robot: its id
    :param map_from_goal: the goal, in the map frame
    :param ending: ``reached``; ``unsure`` when the robot believes to be there, but is not localized; ``cancelled``,
        ``no path`` or ``stuck``; ``silent`` if the robot does not answer, as another agent reports
    :param why: why the goal was not reached, for people; empty when it was reached or cancelled
    """

    topic: ClassVar[str] = "goal-reached"

    robot: str
    map_from_goal: Pose2d
    ending: str
    why: str


class HelloKind(enum.Enum):
    """What an agent says about its presence."""

    HELLO = "HELLO"
    PING = "PING"
    PONG = "PONG"
    BYE = "BYE"


@dataclass(frozen=True, slots=True)
class Hello:
    """Presence of an agent: at its start, at its end, and when another agent asks.

    :param robot: id of the sender's robot; empty when it has none
    :param kind: whether the agent has started, asks who is there, answers, or ends
    :param to: name of the agent that is asked or answered; empty for all
    """

    topic: ClassVar[str] = "hello"

    robot: str
    kind: HelloKind
    to: str


@dataclass(frozen=True, slots=True)
class Lookout:
    """A robot drives to a place to look around, or has looked around there. The others can look elsewhere.

    :param robot: its id
    :param map_from_place: the place, in the map frame [m]
    :param done: whether it has looked around
    """

    topic: ClassVar[str] = "lookout"

    robot: str
    map_from_place: Point2d
    done: bool


@dataclass(frozen=True, slots=True)
class MapEndsEnd:
    """Where what is free meets what nobody has seen.

    :param length: of that [m]
    """

    map_from_middle: Point2d
    length: float


@dataclass(frozen=True, slots=True)
class MapEnds:
    """The frontiers of the map of a robot, where known free space meets unknown space. The robot repeats this.

    :param robot: its id
    :param ends: the frontiers that it can reach; empty when all is mapped
    """

    topic: ClassVar[str] = "map-ends"

    robot: str
    ends: list[MapEndsEnd]


@dataclass(frozen=True, slots=True)
class NewGoal:
    """Sends one robot or all robots to a goal.

    :param robot: its id, or ALL
    :param map_from_goal: the goal, in the map frame
    """

    topic: ClassVar[str] = "new-goal"

    robot: str
    map_from_goal: Pose2d


@dataclass(frozen=True, slots=True)
class PatrolReport:
    """What a robot that patrols does, once a second. Places have their numbers in PatrolOrder; -1 is none.

    :param robot: its id
    :param patrols: false while it does something else, as charging
    :param last: the place where it was last, or to which it is nearest
    :param next: the place where it goes
    :param remaining: time until it arrives there, about [s]
    :param note: what its strategy wants others to know (note)
    """

    topic: ClassVar[str] = "patrol-report"

    robot: str
    patrols: bool
    last: int
    next: int
    remaining: float
    note: list[int]


@dataclass(frozen=True, slots=True)
class PoseReport:
    """The estimated pose of a robot.

    :param robot: its id
    :param role: its role, as the scenario calls it
    :param map_from_base: its pose in the map frame
    """

    topic: ClassVar[str] = "pose"

    robot: str
    role: str
    map_from_base: Pose2d


@dataclass(frozen=True, slots=True)
class PoseRequest:
    """Asks one robot or all robots to report their poses now.

    :param robot: its id, or ALL
    """

    topic: ClassVar[str] = "pose-request"

    robot: str


@dataclass(frozen=True, slots=True)
class PursuitGoal:
    """A hunter drives there from now on, by its pursuit strategy. Other hunters count on it.

    :param hunter: id of its robot
    :param prey: id of the robot that it hunts; empty while it searches
    :param map_from_goal: where it drives, in the map frame; its heading does not matter
    """

    topic: ClassVar[str] = "pursuit-goal"

    hunter: str
    prey: str
    map_from_goal: Pose2d


@dataclass(frozen=True, slots=True)
class Slot:
    """The place of one robot.

    :param map_from_slot: where it should be now
    :param map_from_aim: where it should be later
    """

    map_from_slot: Pose2d
    map_from_aim: Pose2d


@dataclass(frozen=True, slots=True)
class FormationSlots:
    """Where the robots of a formation should be.

    This is repeated as the formation moves, so that one lost message has no effect.

    :param shape: for people: ``wedge``, ``column``
    :param formed: whether all robots have been at their places since these were last assigned
    :param ahead: time from the message until all should be at their places
    :param slots: the place of each robot, by the robot's id
    """

    topic: ClassVar[str] = "ranks"

    shape: str
    formed: bool
    ahead: float
    slots: dict[str, Slot]


@dataclass(frozen=True, slots=True)
class Sighting:
    """An agent has seen a robot.

    :param robot: id of the robot that was seen
    :param role: its role
    :param map_from_base: its pose in the map frame, when it was seen
    """

    topic: ClassVar[str] = "sighting"

    robot: str
    role: str
    map_from_base: Pose2d


@dataclass(frozen=True, slots=True)
class Text:
    """A text for people, and for agents that can read it.

    :param words: the text
    """

    topic: ClassVar[str] = "text"

    words: str


@dataclass(frozen=True, slots=True)
class VictimFound:
    """A robot has seen a victim.

    It repeats this every few seconds until it hears that the victim was helped (VictimHelped), and when it has
    measured the position more exactly.

    :param robot: its id
    :param victim: number of the victim's marker
    :param map_from_victim: where the victim is, in the map frame, as the robot believes [m]
    """

    topic: ClassVar[str] = "victim-found"

    robot: str
    victim: int
    map_from_victim: Point2d


@dataclass(frozen=True, slots=True)
class VictimHelped:
    """A helper was with a victim, which needs no more help.

    :param victim: number of the victim's marker
    """

    topic: ClassVar[str] = "victim-helped"

    victim: int


@dataclass(frozen=True, slots=True)
class Visited:
    """A robot was at a place that its team watches.

    :param robot: its id
    :param map_from_place: the place, in the map frame [m]
    :param idleness: times since the last visits of all places, in the order of PatrolOrder [s]. It is -1
        (UNKNOWN) for those of which the robot knows of no visit; empty when it knows of none
    """

    topic: ClassVar[str] = "visited"

    robot: str
    map_from_place: Point2d
    idleness: list[float]


@dataclass(frozen=True, slots=True)
class Watch:
    """The team watches these places from now on, instead of those before.

    :param map_from_places: the places, in the map frame [m]
    """

    topic: ClassVar[str] = "watch"

    map_from_places: list[Point2d]
