"""Devices of robots. Each is asked by four verbs: *latest*, *subscribe*, *command* and *goal*.

Units are SI, angles in radians, frames as REP 105 has them. A goal is a :class:`Goal`: ``await`` it, or give it a
listener.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar, Generic, TypeVar

import numpy as np
import numpy.typing as npt

from rsal.agents import values as v
from rsal.agents.convert import decoder, encode
from rsal.agents.waiting import Pending

if TYPE_CHECKING:
    from rsal.agents.agent import Agent

T = TypeVar("T")
F = TypeVar("F")
R = TypeVar("R")
D = TypeVar("D", bound="Device")


@dataclass(frozen=True)
class Stamped(Generic[T]):
    """A reading.

    :param time: when it was taken, in the time of the run [s]
    :param frame: in which its places are (``map``, ``hunter-1/odom``)
    """

    time: float
    frame: str
    value: T


class Subscription:
    """An interest in something, until it is cancelled. It ends with its agent."""

    def __init__(self, agent: Agent, number: int) -> None:
        self._agent = agent
        self._number = number

    def cancel(self) -> None:
        """No callback comes after this. Cancelling twice does nothing."""
        self._agent._link.cancel(self._number)


class Goal(Pending[R], Generic[F, R]):
    """A goal under way: ``result = await goal``. A failure is a result, no exception.

    Only when the robot's system cannot even say how it ended, as when it is gone, ``await`` raises :class:`RsalError`.
    """

    def __init__(self, agent: Agent, feedback: Any) -> None:
        super().__init__(agent._run)
        self._agent = agent
        self._reports: list[int] = []
        self._feedback = feedback
        self._number = 0

    def cancel(self) -> None:
        """Asks for an early end. After the end it does nothing."""
        if not self.done:
            self._agent._link.do("cancelGoal", self._number)

    def on_feedback(self, listener: Callable[[Stamped[F]], object]) -> None:
        """Call a method with each report of progress, until the goal has ended."""
        if self.done:
            return
        decode = decoder(self._feedback)
        run = self._agent._run

        def heard(words: Any, arrays: memoryview) -> None:
            run(listener, Stamped(words["time"], words["frame"], decode(words["value"], arrays)))

        number = self._agent._link.listen(heard)
        self._reports.append(number)
        self._agent._link.do("feedback", self._number, number)

    def _forget_reports(self) -> None:
        for number in self._reports:
            self._agent._link.cancel(number)
        self._reports.clear()

    def _end(self, value: R) -> None:
        self._forget_reports()
        super()._end(value)

    def _fail(self, why: str, place: str) -> None:
        self._forget_reports()
        super()._fail(why, place)


class Device:
    """Something of a robot that can be asked or commanded."""

    contract: ClassVar[str] = "Device"

    def __init__(self, agent: Agent, index: int, name: str) -> None:
        self._agent = agent
        self._index = index
        self.name = name

    def _do(self, method: str, *arguments: Any) -> None:
        self._agent._link.do("call", 0, self._index, method, [encode(each) for each in arguments])

    def _ask(self, kind: Any, method: str, *arguments: Any) -> Any:
        words, arrays = self._agent._link.ask("call", self._index, method, [encode(each) for each in arguments])
        return decoder(kind)(words, arrays)

    def _later(self, pending: Any, kind: Any, method: str, *arguments: Any) -> Any:
        link = self._agent._link
        decode = decoder(kind)

        def heard(words: Any, arrays: memoryview) -> None:
            del link.heard[number]
            if "error" in words:
                pending._fail(words["error"], words["place"])
            else:
                pending._end(decode(words["value"], arrays))

        number = link.listen(heard)
        pending._number = number
        link.do("call", number, self._index, method, [encode(each) for each in arguments])
        return pending

    def _goal(self, feedback: Any, result: Any, method: str, *arguments: Any) -> Any:
        return self._later(Goal(self._agent, feedback), result, method, *arguments)

    @property
    def health(self) -> v.HealthOk | v.HealthStale | v.HealthLost:
        """How it is now."""
        found: v.HealthOk | v.HealthStale | v.HealthLost = self._ask(
            v.HealthOk | v.HealthStale | v.HealthLost, "health"
        )
        return found


class Sensor(Device, Generic[T]):
    """A device with readings."""

    reading: ClassVar[Any] = None

    @property
    def latest(self) -> Stamped[T] | None:
        """The newest reading; ``None`` before the first."""
        words, arrays = self._agent._link.ask("latest", self._index)
        if words is None:
            return None
        return Stamped(words["time"], words["frame"], decoder(self.reading)(words["value"], arrays))

    def subscribe(self, listener: Callable[[Stamped[T]], object]) -> Subscription:
        """Call a method with each new reading. In real time, a slow agent gets the newest one."""
        decode = decoder(self.reading)
        run = self._agent._run

        def heard(words: Any, arrays: memoryview) -> None:
            run(listener, Stamped(words["time"], words["frame"], decode(words["value"], arrays)))

        number = self._agent._link.listen(heard)
        self._agent._link.do("read", number, self._index)
        return Subscription(self._agent, number)


class DriveBase(Sensor[v.Odometry]):
    """Motors and wheels. Frame of its readings: ``<robot>/odom``."""

    contract = "DriveBase"
    reading = v.Odometry

    def command(self, forward: float = 0.0, turn: float = 0.0, left: float = 0.0) -> None:
        """Move at this velocity until the next command.

        :param forward: ahead [m/s]
        :param turn: counter-clockwise [rad/s]
        :param left: to the left [m/s]

        Without a new command the base stops by itself after 0.5 s.
        """
        velocity = {"vx": float(forward), "vy": float(left), "omega": float(turn)}  # Twist2d, without making one
        self._agent._link.do("call", 0, self._index, "command", [velocity])

    def stop(self) -> None:
        """Command a velocity of 0."""
        self.command()

    def enable(self, enabled: bool) -> None:
        """Switches the motors of wheels, grippers and actuators."""
        self._do("enable", enabled)

    @property
    def enabled(self) -> bool:
        """Whether the motors are on."""
        return bool(self._ask(bool, "enabled"))

    def reset_odometry(self, odom_from_base: v.Pose2d) -> None:
        """Set the pose in the odometry. The robot does not move."""
        self._do("resetOdometry", odom_from_base)


class LaserScanner(Sensor[v.LaserScan]):
    """A planar laser scanner."""

    contract = "LaserScanner"
    reading = v.LaserScan


class SonarArray(Sensor[v.RangeArray]):
    """Single-range sensors around a robot."""

    contract = "SonarArray"
    reading = v.RangeArray


class Localizer(Sensor[v.PoseEstimate]):
    """Finds the robot on a map. Frame of its readings: ``map``."""

    contract = "Localizer"
    reading = v.PoseEstimate

    def relocalize(self, belief: v.PoseEstimate) -> Pending[None]:
        """Start again from an estimate; ends when the next reading follows it."""
        found: Pending[None] = self._later(Pending(self._agent._run), None, "relocalize", belief)
        return found

    @property
    def given_map(self) -> v.OccupancyGrid | None:
        """The map it localizes on; ``None`` without one."""
        found: v.OccupancyGrid | None = self._ask(v.OccupancyGrid | None, "givenMap")
        return found

    @property
    def particles(self) -> v.ParticleCloud | None:
        """Its particles in the map frame; ``None`` if it has none."""
        words, arrays = self._agent._link.ask("call", self._index, "particles", [])
        return None if words is None else decoder(v.ParticleCloud)(words["value"], arrays)


class Navigator(Device):
    """Drives the robot to goals on the map."""

    contract = "Navigator"

    Reached = v.NavigatorReached
    Cancelled = v.NavigatorCancelled
    NoPath = v.NavigatorNoPath
    Stuck = v.NavigatorStuck
    Result = v.NavigatorReached | v.NavigatorCancelled | v.NavigatorNoPath | v.NavigatorStuck

    def go_to(
        self, map_from_goal: v.Pose2d, distance: float = 0.4, angle: float = 0.17453292519943295
    ) -> Goal[v.NavigatorProgress, v.NavigatorReached | v.NavigatorCancelled | v.NavigatorNoPath | v.NavigatorStuck]:
        """Drives to a goal. A new goal cancels the one under way.

        :param distance: how far it may end from the goal [m]
        :param angle: how far the heading may be off [rad]; π or more when it does not matter
        """
        goal: Goal[
            v.NavigatorProgress, v.NavigatorReached | v.NavigatorCancelled | v.NavigatorNoPath | v.NavigatorStuck
        ] = self._goal(v.NavigatorProgress, self.Result, "goTo", map_from_goal, v.Tolerance(distance, angle))
        return goal

    def pause(self) -> None:
        """Stands still and keeps the goal."""
        self._do("pause")

    def resume(self) -> None:
        """Resume after a pause."""
        self._do("resume")

    @property
    def paused(self) -> bool:
        """Whether it is paused."""
        return bool(self._ask(bool, "paused"))

    @property
    def goal(self) -> v.Pose2d | None:
        """The present goal."""
        found: v.Pose2d | None = self._ask(v.Pose2d | None, "goal")
        return found

    @property
    def path(self) -> v.Path2d:
        """The planned path from here; empty without a goal."""
        found: v.Path2d = self._ask(v.Path2d, "path")
        return found

    @property
    def local_path(self) -> v.Path2d:
        """The path that the controller predicts for the next seconds, in the map frame [m]; empty without a goal."""
        found: v.Path2d = self._ask(v.Path2d, "localPath")
        return found

    @property
    def cost_map(self) -> v.OccupancyGrid | None:
        """The costs by which it plans; ``None`` if it plans without a map."""
        found: v.OccupancyGrid | None = self._ask(v.OccupancyGrid | None, "costMap")
        return found


class Planner(Device):
    """Plans paths. A request moves no robot."""

    contract = "Planner"

    Found = v.PlannerFound
    NoPath = v.PlannerNoPath

    def plan(self, map_from_start: v.Pose2d, map_from_goal: v.Pose2d) -> Pending[v.PlannerFound | v.PlannerNoPath]:
        """Plan a path between two poses in the map frame."""
        found: Pending[v.PlannerFound | v.PlannerNoPath] = self._later(
            Pending(self._agent._run), v.PlannerFound | v.PlannerNoPath, "plan", map_from_start, map_from_goal
        )
        return found

    def costs(
        self, map_from_start: v.Pose2d, map_from_goals: list[v.Pose2d], near: float = float("inf")
    ) -> Pending[list[float]]:
        """Costs of the paths to several places, in their order [m]; ``inf`` where there is none."""
        found: Pending[list[float]] = self._later(
            Pending(self._agent._run), list[float], "costs", map_from_start, map_from_goals, near
        )
        return found


@dataclass(frozen=True, eq=False)
class Percept:
    """What a robot senses, for a behavior.

    :param time: when [s]
    :param ranges: distance from the base to the nearest thing in each of 180 equal sectors [m], counter-clockwise from
        straight behind; ``inf`` where nothing is, NaN where no sensor looks
    """

    time: float
    odometry: v.Odometry
    ranges: npt.NDArray[np.float32]

    def nearest(self, right: float = -math.pi, left: float = math.pi) -> float:
        """Return the least distance between two directions [m].

        Directions are in the robot's frame [rad], 0 ahead, positive to the left. ``inf`` where nothing is.
        """
        width = 2 * math.pi / len(self.ranges)
        begin = max(0, math.floor((right + math.pi) / width))
        ranges = self.ranges[begin : max(begin, math.floor((left + math.pi) / width)) + 1]
        known = ranges[~np.isnan(ranges)]
        return float(known.min()) if len(known) else math.inf


class Pilot(Sensor[v.Decision]):
    """Drives the robot by behaviors, which keep it off obstacles. Readings are what the layers of behaviors decided."""

    contract = "Pilot"
    reading = v.Decision
    _own = 0

    def engage(self, behavior: str | Callable[[Percept], v.Twist2d | None], name: str = "own") -> None:
        """Let a behavior drive from now on, in place of the one before.

        :param behavior: one that RSAL has, ``wander`` or ``wall-follow``; or a method of your own, which is called ten
            times a second with what the robot senses, and returns how it should move, or ``None`` to stand still
        :param name: of your own, for people

        Layers above it avoid collisions, free the robot when it is stuck, and limit speeds. The robot moves by what the
        method returned 0.1 s before; it stands when the method did not return for 0.5 s.
        """
        link = self._agent._link
        link.heard.pop(self._own, None)
        self._own = 0
        if isinstance(behavior, str):
            link.do("engage", 0, self._index, behavior)
            return
        decode = decoder(Percept)

        def heard(words: Any, arrays: memoryview) -> None:
            wanted = behavior(decode(words, arrays))
            if wanted is not None and not isinstance(wanted, v.Twist2d):
                raise TypeError(f"A behavior returns a Twist2d or None, not '{type(wanted).__name__}'.")
            link.do("velocity", number, encode(wanted or v.Twist2d(0.0, 0.0, 0.0)))

        number = self._own = link.listen(heard)
        link.do("engage", number, self._index, name)

    def release(self) -> None:
        """Stand still, and let others drive."""
        self._do("release")

    @property
    def engaged(self) -> bool:
        """Whether a behavior drives."""
        return bool(self._ask(bool, "engaged"))

    def pause(self) -> None:
        """Stand still and keep the behavior."""
        self._do("pause")

    def resume(self) -> None:
        """Resume after a pause."""
        self._do("resume")

    @property
    def paused(self) -> bool:
        """Whether it stands still by :meth:`pause`."""
        return bool(self._ask(bool, "paused"))


class PlaceFinder(Device):
    """Finds places for a team on the map."""

    contract = "PlaceFinder"

    Found = v.PlaceFinderFound
    NoPlace = v.PlaceFinderNone

    def find(
        self,
        map_from_start: v.Pose2d,
        count: int,
        clearance: float,
        objective: v.PlaceObjective = v.PlaceObjective.EVENLY,
    ) -> Pending[v.PlaceFinderFound | v.PlaceFinderNone]:
        """Find places in the map frame that a robot can reach, ``clearance`` [m] from all cells that are not free."""
        found: Pending[v.PlaceFinderFound | v.PlaceFinderNone] = self._later(
            Pending(self._agent._run),
            v.PlaceFinderFound | v.PlaceFinderNone,
            "find",
            map_from_start,
            count,
            float(clearance),
            objective,
        )
        return found


class Docking(Device):
    """Drives the robot onto docks, such as charging stations, and off them."""

    contract = "Docking"

    Reached = v.DockingReached
    Cancelled = v.DockingCancelled
    Failed = v.DockingFailed
    Result = v.DockingReached | v.DockingCancelled | v.DockingFailed

    def dock(
        self, dock: str | v.Pose2d, kind: str = ""
    ) -> Goal[v.DockingProgress, v.DockingReached | v.DockingCancelled | v.DockingFailed]:
        """Drives onto a dock: by its name, or by its pose and type."""
        arguments = (dock,) if isinstance(dock, str) else (dock, kind)
        goal: Goal[v.DockingProgress, v.DockingReached | v.DockingCancelled | v.DockingFailed] = self._goal(
            v.DockingProgress, self.Result, "dock", *arguments
        )
        return goal

    def undock(self) -> Goal[v.DockingProgress, v.DockingReached | v.DockingCancelled | v.DockingFailed]:
        """Drive off the dock."""
        goal: Goal[v.DockingProgress, v.DockingReached | v.DockingCancelled | v.DockingFailed] = self._goal(
            v.DockingProgress, self.Result, "undock"
        )
        return goal


class Gripper(Sensor[v.GripperState]):
    """Two paddles that close around things, and possibly a lift."""

    contract = "Gripper"
    reading = v.GripperState

    Reached = v.GripperReached
    Cancelled = v.GripperCancelled
    Stuck = v.GripperStuck
    Result = v.GripperReached | v.GripperCancelled | v.GripperStuck

    def _move(self, method: str) -> Goal[v.GripperState, v.GripperReached | v.GripperCancelled | v.GripperStuck]:
        goal: Goal[v.GripperState, v.GripperReached | v.GripperCancelled | v.GripperStuck] = self._goal(
            v.GripperState, self.Result, method
        )
        return goal

    def open(self) -> Goal[v.GripperState, v.GripperReached | v.GripperCancelled | v.GripperStuck]:
        """Open the paddles."""
        return self._move("open")

    def close(self) -> Goal[v.GripperState, v.GripperReached | v.GripperCancelled | v.GripperStuck]:
        """Close the paddles."""
        return self._move("close")

    def lift(self) -> Goal[v.GripperState, v.GripperReached | v.GripperCancelled | v.GripperStuck]:
        """Raise the lift."""
        return self._move("lift")

    def lower(self) -> Goal[v.GripperState, v.GripperReached | v.GripperCancelled | v.GripperStuck]:
        """Lower the lift."""
        return self._move("lower")

    def close_and_lift(self) -> Goal[v.GripperState, v.GripperReached | v.GripperCancelled | v.GripperStuck]:
        """Close the paddles, then raise the lift."""
        return self._move("closeAndLift")

    def lower_and_open(self) -> Goal[v.GripperState, v.GripperReached | v.GripperCancelled | v.GripperStuck]:
        """Lower the lift, then open the paddles."""
        return self._move("lowerAndOpen")


class Actuator(Sensor[v.ActuatorState]):
    """A joint that is moved by a motor."""

    contract = "Actuator"
    reading = v.ActuatorState

    Reached = v.ActuatorReached
    Cancelled = v.ActuatorCancelled
    Stuck = v.ActuatorStuck
    Result = v.ActuatorReached | v.ActuatorCancelled | v.ActuatorStuck

    def go_to(
        self, position: float
    ) -> Goal[v.ActuatorState, v.ActuatorReached | v.ActuatorCancelled | v.ActuatorStuck]:
        """Move to a position [m or rad] and hold it."""
        goal: Goal[v.ActuatorState, v.ActuatorReached | v.ActuatorCancelled | v.ActuatorStuck] = self._goal(
            v.ActuatorState, self.Result, "goTo", float(position)
        )
        return goal

    def home(self) -> Goal[v.ActuatorState, v.ActuatorReached | v.ActuatorCancelled | v.ActuatorStuck]:
        """Move to the home position."""
        goal: Goal[v.ActuatorState, v.ActuatorReached | v.ActuatorCancelled | v.ActuatorStuck] = self._goal(
            v.ActuatorState, self.Result, "home"
        )
        return goal

    def command(self, speed: float) -> None:
        """Move at a speed [m/s or rad/s], at most for 0.5 s without a new command."""
        self._do("command", float(speed))


class Light(Sensor[v.LightState]):
    """A light that others can see."""

    contract = "Light"
    reading = v.LightState

    def show(self, signal: v.Signal) -> None:
        """Shines with this signal until the next one."""
        self._do("show", signal)

    def on(self) -> None:
        """Switch the light on."""
        self._do("on")

    def off(self) -> None:
        """Switch the light off."""
        self._do("off")


class Mapper(Sensor[v.OccupancyGrid]):
    """Draws a map while its robot drives."""

    contract = "Mapper"
    reading = v.OccupancyGrid

    @property
    def complete(self) -> bool:
        """Whether the map is complete."""
        return bool(self._ask(bool, "isComplete"))

    @property
    def ends(self) -> list[v.End]:
        """The frontiers of the map that its robot can reach."""
        found: list[v.End] = self._ask(list[v.End], "ends")
        return found

    def leave_alone(self, end: v.End) -> None:
        """Leave a frontier out of the exploration for a while."""
        self._do("leaveAlone", end)

    def pause(self) -> None:
        """Pause."""
        self._do("pause")

    def resume(self) -> None:
        """Resume after a pause."""
        self._do("resume")

    @property
    def paused(self) -> bool:
        """Whether it is paused."""
        return bool(self._ask(bool, "paused"))


class BlobFinder(Sensor[v.Blobs]):
    """A camera that detects patches of color."""

    contract = "BlobFinder"
    reading = v.Blobs


class FiducialFinder(Sensor[v.Fiducials]):
    """Detects markers."""

    contract = "FiducialFinder"
    reading = v.Fiducials


class Bumper(Sensor[v.BumperState]):
    """Detects contacts of the robot."""

    contract = "Bumper"
    reading = v.BumperState


class Battery(Sensor[v.BatteryState]):
    """A robot's store of energy."""

    contract = "Battery"
    reading = v.BatteryState


class Camera(Sensor[v.CameraImage]):
    """A camera that sees colors and depth."""

    contract = "Camera"
    reading = v.CameraImage


class Gnss(Sensor[v.GnssFix]):
    """A receiver of satellite navigation."""

    contract = "Gnss"
    reading = v.GnssFix


class Imu(Sensor[v.ImuReading]):
    """An inertial measurement unit."""

    contract = "Imu"
    reading = v.ImuReading


class Simulation(Device):
    """The truth of a simulated world. It is for metrics and for preparing worlds, not for navigation."""

    contract = "SimulationControl"

    Placed = v.Placed
    Refused = v.Refused

    @property
    def entities(self) -> list[str]:
        """Names of the things that can be read and placed, robots among them."""
        found: list[str] = self._ask(list[str], "entities")
        return found

    def truth(self, entity: str) -> v.Pose2d | None:
        """Return the true pose of a thing [m, rad], in the map frame; ``None`` if there is none of that name."""
        found: v.Pose2d | None = self._ask(v.Pose2d | None, "truth", entity)
        return found

    def place(self, entity: str, map_from_entity: v.Pose2d) -> v.Placed | v.Refused:
        """Move a thing to a pose, at which it stands still."""
        found: v.Placed | v.Refused = self._ask(v.Placed | v.Refused, "place", entity, map_from_entity)
        return found

    @property
    def contacts(self) -> list[v.Contact]:
        """Collisions so far."""
        found: list[v.Contact] = self._ask(list[v.Contact], "contacts")
        return found


CONTRACTS: dict[str, type[Device]] = {
    kind.contract: kind
    for kind in (
        DriveBase, LaserScanner, SonarArray, Localizer, Navigator, Pilot, Planner, PlaceFinder, Docking, Gripper,
        Actuator, Light, Mapper, BlobFinder, FiducialFinder, Bumper, Battery, Camera, Gnss, Imu,
    )
}  # fmt: skip


class Robot:
    """The robot of an agent: its devices, by name, by type, or by what they are called here."""

    def __init__(self, agent: Agent, words: dict[str, Any]) -> None:
        self.id: str = words["id"]
        self.role: str = words["role"]
        self.model: str = words["model"]
        self.devices: list[Device] = [
            CONTRACTS.get(each["contract"], Device)(agent, each["index"], each["name"]) for each in words["devices"]
        ]

    def __getattr__(self, name: str) -> Any:
        import difflib  # noqa: PLC0415 - for errors only

        known = [each for each in dir(type(self)) if not each.startswith("_")]
        robot = self.__dict__.get("id", "")
        near = difflib.get_close_matches(name, known, 1)
        hint = f"Maybe '{near[0]}'?" if near else f"Known are: {', '.join(known)}."
        devices = ", ".join(each.name for each in self.__dict__.get("devices", []))
        raise AttributeError(f"Robot '{robot}' has no attribute '{name}'. {hint} Its devices: {devices or 'none'}.")

    def find(self, kind: type[D], name: str = "") -> D | None:
        """Return the first device of a type, or the one of a name; ``None`` when there is none."""
        for device in self.devices:
            if isinstance(device, kind) and name in ("", device.name):
                return device
        return None

    def require(self, kind: type[D], name: str = "") -> D:
        """As :meth:`find`.

        :raises LookupError: when the robot has none
        """
        device = self.find(kind, name)
        if device is None:
            wanted = f"{kind.contract} '{name}'" if name else kind.contract
            raise LookupError(f"Robot '{self.id}' has no {wanted}; it has {[each.name for each in self.devices]}.")
        return device

    @property
    def base(self) -> DriveBase:
        """The first drive base; ``LookupError`` if the robot has none."""
        return self.require(DriveBase)

    @property
    def laser(self) -> LaserScanner:
        """The first device of this type; ``LookupError`` if the robot has none."""
        return self.require(LaserScanner)

    @property
    def sonar(self) -> SonarArray:
        """The first device of this type; ``LookupError`` if the robot has none."""
        return self.require(SonarArray)

    @property
    def localizer(self) -> Localizer:
        """The first device of this type; ``LookupError`` if the robot has none."""
        return self.require(Localizer)

    @property
    def navigator(self) -> Navigator:
        """The first device of this type; ``LookupError`` if the robot has none."""
        return self.require(Navigator)

    @property
    def pilot(self) -> Pilot:
        """The first device of this type; ``LookupError`` if the robot has none."""
        return self.require(Pilot)

    @property
    def planner(self) -> Planner:
        """The first device of this type; ``LookupError`` if the robot has none."""
        return self.require(Planner)

    @property
    def gripper(self) -> Gripper:
        """The first device of this type; ``LookupError`` if the robot has none."""
        return self.require(Gripper)

    @property
    def light(self) -> Light:
        """The first device of this type; ``LookupError`` if the robot has none."""
        return self.require(Light)

    @property
    def camera(self) -> Camera:
        """The first device of this type; ``LookupError`` if the robot has none."""
        return self.require(Camera)

    @property
    def battery(self) -> Battery:
        """The first device of this type; ``LookupError`` if the robot has none."""
        return self.require(Battery)
