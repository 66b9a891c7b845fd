"""Values of devices: SI units, radians, frames as REP 105 has them.

Generated from Java by `PythonValuesTest`: do not edit.
"""

from __future__ import annotations

import enum
from dataclasses import dataclass
from typing import ClassVar

import numpy as np
import numpy.typing as npt

from rsal.agents.geometry import PointMethods, PoseMethods, ScanMethods


@dataclass(frozen=True, slots=True)
class HealthOk:
    """It works."""

    _type: ClassVar[str] = "Ok"


@dataclass(frozen=True, slots=True)
class HealthStale:
    """No data for longer than it should take."""

    _type: ClassVar[str] = "Stale"

    reason: str


@dataclass(frozen=True, slots=True)
class HealthLost:
    """Its driver failed or its connection is gone."""

    _type: ClassVar[str] = "Lost"

    reason: str


class Joint(enum.Enum):
    """How a joint moves: its positions are in m or in rad."""

    LINEAR = "LINEAR"
    ROTATIONAL = "ROTATIONAL"


@dataclass(frozen=True, slots=True)
class Interval:
    """All numbers from one to another, both included."""

    least: float
    most: float


class Motion(enum.Enum):
    """What a joint does."""

    IDLE = "IDLE"
    MOVING = "MOVING"
    STALLED = "STALLED"


@dataclass(frozen=True, slots=True)
class ActuatorState:
    """State of a joint (an element of ``sensor_msgs/JointState``, an actuator of Player's ``actarray``).

    Lengths in m when the joint is linear, angles in rad when it is rotational.

    :param joint: whether it is linear or rotational
    :param position: within its limits [m or rad]
    :param speed: towards larger positions when positive [m/s or rad/s]
    :param limits: of its position [m or rad]
    :param motion: what it does now
    """

    joint: Joint
    position: float
    speed: float
    limits: Interval
    motion: Motion


@dataclass(frozen=True, slots=True)
class ActuatorReached:
    """It is where it was to be.

    :param position: [m or rad]
    """

    _type: ClassVar[str] = "Reached"

    position: float


@dataclass(frozen=True, slots=True)
class ActuatorCancelled:
    """The goal was cancelled, or another one took its place."""

    _type: ClassVar[str] = "Cancelled"


@dataclass(frozen=True, slots=True)
class ActuatorStuck:
    """It can't go on, or the device is lost."""

    _type: ClassVar[str] = "Stuck"

    position: float
    why: str


class Charging(enum.Enum):
    """Where energy flows."""

    UNKNOWN = "UNKNOWN"
    CHARGING = "CHARGING"
    DISCHARGING = "DISCHARGING"
    GIVING = "GIVING"
    FULL = "FULL"


@dataclass(frozen=True, slots=True)
class BatteryState:
    """State of a battery (``sensor_msgs/BatteryState``, Player ``power``). NaN when the battery cannot measure a value.

    :param charge: energy that is left [J]; +∞ when it is never empty
    :param capacity: energy of the full battery [J]; +∞ when it is never empty
    :param level: share of the capacity that is left, 0-1
    :param power: charging power less consumed power [W]; negative while it discharges
    :param voltage: [V]
    :param charging: whether it is charged
    """

    charge: float
    capacity: float
    level: float
    power: float
    voltage: float
    charging: Charging


@dataclass(frozen=True, slots=True)
class Pose2d(PoseMethods):
    """Where a frame is, seen from its parent.

    X, y [m] and heading [rad] in [-π, π). Variables name both frames, parent first (``map_from_base``), so
    that a chain checks itself by eye: ``map_from_laser = map_from_base.compose(base_from_laser)``.
    """

    x: float
    y: float
    theta: float


@dataclass(frozen=True, slots=True)
class Rgb:
    """A color, each part 0-255."""

    red: int
    green: int
    blue: int


@dataclass(frozen=True, slots=True)
class Blob:
    """A patch of one color.

    :param left: first column [px]
    :param top: first row [px]
    :param right: one past the last column [px]
    :param bottom: one past the last row [px]
    :param x: of its middle [px]; the first column reaches from 0 to 1
    :param y: of its middle [px]
    :param area: number of its pixels
    :param range: how far it is, as seen from above [m]; NaN when the camera can't tell
    """

    color: Rgb
    left: int
    top: int
    right: int
    bottom: int
    x: float
    y: float
    area: int
    range: float


@dataclass(frozen=True, slots=True)
class Blobs:
    """Patches of color in one image (Player ``blobfinder``.

    ROS has no message for them). Columns count from the left, rows from the top; neighboring columns of an
    image differ by the same angle, as in Stage.

    :param base_from_camera: where the camera is mounted, looking along its x axis
    :param width: of the image [px]
    :param height: of the image [px]
    :param field_of_view: from the left edge of the image to its right [rad]
    :param blobs: from left to right, by their first columns
    """

    base_from_camera: Pose2d
    width: int
    height: int
    field_of_view: float
    blobs: list[Blob]


@dataclass(frozen=True, slots=True)
class BumperState:
    """The state of a robot's bumpers (Player ``bumper``).

    :param base_from_bumpers: the middle of each, its x axis pointing outwards
    :param pressed: as many as bumpers
    """

    base_from_bumpers: list[Pose2d]
    pressed: list[bool]


@dataclass(frozen=True, eq=False)
class CameraImage:
    """An image of a camera without distortion (a pinhole).

    As ``sensor_msgs/Image`` in ``rgb8`` and ``16UC1``, and ``sensor_msgs/CameraInfo`` of ROS. Its optical axis
    goes through the middle of the image. Rows come from the top, columns from the left.

    :param width: number of columns [px]
    :param height: number of rows [px]
    :param focal_length: of columns and of rows [px]
    :param rgb: red, green and blue of each pixel, row by row; not to be changed
    :param depth: along the optical axis, of each pixel, row by row: two bytes each, the lower one first [mm]; 0
        where nothing is in range (REP 118 for ``16UC1``); not to be changed
    """

    width: int
    height: int
    focal_length: float
    rgb: npt.NDArray[np.int8]
    depth: npt.NDArray[np.int8]


class DockingStage(enum.Enum):
    """What it does about a goal."""

    BEGINNING = "BEGINNING"
    APPROACHING = "APPROACHING"
    DETECTING = "DETECTING"
    MOVING = "MOVING"
    WAITING = "WAITING"
    RETRYING = "RETRYING"


@dataclass(frozen=True, slots=True)
class DockingProgress:
    """How far a goal has got.

    :param retries: how many times it has tried again
    :param working: since the goal was given
    """

    stage: DockingStage
    retries: int
    working: float


@dataclass(frozen=True, slots=True)
class DockingReached:
    """It is on the dock, or off it, as was wanted."""

    _type: ClassVar[str] = "Reached"


@dataclass(frozen=True, slots=True)
class DockingCancelled:
    """The goal was cancelled, or another one took its place.

    :param why: for people
    """

    _type: ClassVar[str] = "Cancelled"

    why: str


@dataclass(frozen=True, slots=True)
class DockingFailed:
    """It gave up."""

    _type: ClassVar[str] = "Failed"

    why: str


@dataclass(frozen=True, slots=True)
class Twist2d:
    """Velocity of a planar body in its own frame: forward and left [m/s], counter-clockwise [rad/s]."""

    vx: float
    vy: float
    omega: float


@dataclass(frozen=True, slots=True)
class Odometry:
    """What the wheels measure (``nav_msgs/Odometry``).

    :param odom_from_base: pose in the odom frame, which is smooth but drifts
    :param velocity: measured, in the base frame [m/s, rad/s]
    :param stalled: whether the motors run, but the robot does not move
    """

    odom_from_base: Pose2d
    velocity: Twist2d
    stalled: bool


@dataclass(frozen=True, slots=True)
class Fiducial:
    """A marker.

    :param id: what is written on it; empty when it is too far away to be read
    :param base_from_fiducial: where it is and which way it faces, in the robot's base frame
    """

    id: int | None
    base_from_fiducial: Pose2d


@dataclass(frozen=True, slots=True)
class Fiducials:
    """Markers that a robot sees at once (Player ``fiducial``).

    :param base_from_finder: mount of the detector, which looks along its x axis
    :param field_of_view: [rad]
    :param range_max: maximum range at which it detects markers [m]
    :param fiducials: the nearest first
    """

    base_from_finder: Pose2d
    field_of_view: float
    range_max: float
    fiducials: list[Fiducial]


@dataclass(frozen=True, slots=True)
class GnssFix:
    """The measured position of a receiver.

    In the map, whose x axis points east, and on Earth, as ``sensor_msgs/NavSatFix`` of ROS.

    :param x: to the east [m]
    :param y: to the north [m]
    :param latitude: north, WGS 84 [deg]
    :param longitude: east, WGS 84 [deg]
    :param deviation: standard deviation of x and y, as the receiver estimates it [m]
    """

    x: float
    y: float
    latitude: float
    longitude: float
    deviation: float


class Paddles(enum.Enum):
    """What the paddles do."""

    OPEN = "OPEN"
    CLOSED = "CLOSED"
    OPENING = "OPENING"
    CLOSING = "CLOSING"
    STOPPED = "STOPPED"


class Lift(enum.Enum):
    """What the lift does."""

    DOWN = "DOWN"
    UP = "UP"
    RISING = "RISING"
    SINKING = "SINKING"
    STOPPED = "STOPPED"


@dataclass(frozen=True, slots=True)
class GripperState:
    """State of a gripper (Player ``gripper``, the lift as one joint of ``actarray``, the light beams as ``dio``).

    :param paddles: whether they are open, closed or moving
    :param closed: how far the paddles are closed: 0 open, 1 closed; NaN when the gripper cannot measure it
    :param lift: whether it is up, down or moving
    :param raised: how far the lift is up: 0 down, 1 up; NaN when the gripper cannot measure it; 0 without a lift
    :param inner_beam_broken: whether a thing is between the paddles, deep inside
    :param outer_beam_broken: whether a thing is between the paddles, near their tips
    :param left_contact: whether a thing touches the left paddle from inside
    :param right_contact: whether a thing touches the right paddle from inside
    :param holding: whether it has gripped a thing
    """

    paddles: Paddles
    closed: float
    lift: Lift
    raised: float
    inner_beam_broken: bool
    outer_beam_broken: bool
    left_contact: bool
    right_contact: bool
    holding: bool


@dataclass(frozen=True, slots=True)
class GripperReached:
    """Paddles or lift are where they were to be."""

    _type: ClassVar[str] = "Reached"

    state: GripperState


@dataclass(frozen=True, slots=True)
class GripperCancelled:
    """The goal was cancelled, or another one took its place."""

    _type: ClassVar[str] = "Cancelled"


@dataclass(frozen=True, slots=True)
class GripperStuck:
    """It can't go on, or the device is lost."""

    _type: ClassVar[str] = "Stuck"

    state: GripperState
    why: str


@dataclass(frozen=True, slots=True)
class ImuReading:
    """A measurement of an IMU in the plane (``sensor_msgs/Imu`` of ROS).

    It does not contain gravity, because robots stand level.

    :param orientation: heading, counter-clockwise from east (REP 103) [rad]; without a compass, the start
        heading plus the integrated rotation, so that it drifts
    :param angular_velocity: around the vertical axis, counter-clockwise [rad/s]; mean since the last reading
    :param acceleration_x: ahead [m/s²]; mean since the last reading
    :param acceleration_y: to the left [m/s²]; mean since the last reading
    """

    orientation: float
    angular_velocity: float
    acceleration_x: float
    acceleration_y: float


@dataclass(frozen=True, eq=False)
class LaserScan(ScanMethods):
    """One sweep of a planar laser scanner, counter-clockwise (``sensor_msgs/LaserScan``).

    Beam ``i`` points to ``angle_min + i · angle_increment`` [rad] in the laser's frame. Ranges [m] after REP
    117 (Rep117): -∞ too close to measure, +∞ no echo, NaN invalid.

    :param base_from_laser: pose of the scanner in the base frame
    :param angle_min: direction of the first beam, in the laser's frame [rad]
    :param angle_increment: angle from a beam to the next one [rad]
    :param range_min: shortest range it measures [m]
    :param range_max: longest range it measures [m]
    :param ranges: one for each beam [m]; handed over, not shared
    """

    base_from_laser: Pose2d
    angle_min: float
    angle_increment: float
    range_min: float
    range_max: float
    ranges: npt.NDArray[np.float32]


@dataclass(frozen=True, slots=True)
class Signal:
    """What a light may be told: to shine for a share of each period, from its begin.

    :param period: from one flash to the next
    :param duty_cycle: share of the period in which it shines, 0-1
    """

    period: float
    duty_cycle: float


@dataclass(frozen=True, slots=True)
class LightState:
    """State of a light (Player ``blinkenlight``).

    :param color: color of its light
    :param signal: the commanded signal: on, off, or blink
    :param lit: whether it shines at the time of the reading
    """

    color: Rgb
    signal: Signal
    lit: bool


@dataclass(frozen=True, slots=True)
class Covariance2d:
    """Symmetric 3x3 covariance of a pose: x, y [m²], heading [rad²] and their products."""

    xx: float
    xy: float
    x_theta: float
    yy: float
    y_theta: float
    theta_theta: float


@dataclass(frozen=True, slots=True)
class Hypothesis:
    """:param weight: share of the belief, 0-1"""

    weight: float
    map_from_base: Pose2d
    covariance: Covariance2d


class Quality(enum.Enum):
    """How well a robot is localized."""

    LOST = "LOST"
    AMBIGUOUS = "AMBIGUOUS"
    LOCALIZED = "LOCALIZED"


@dataclass(frozen=True, slots=True)
class PoseEstimate:
    """Where a localizer believes the robot to be.

    As ``geometry_msgs/PoseWithCovarianceStamped``, with more than one hypothesis.

    :param map_from_base: pose in the map frame, of the best hypothesis
    :param covariance: of x, y and yaw, of the best hypothesis [m², m·rad, rad²]
    :param hypotheses: all possible ones, the highest weight first; the sum of weights is at most 1
    :param confidence: probability that ``map_from_base`` is right, as far as the localizer knows, 0-1
    :param quality: the confidence in a word
    """

    map_from_base: Pose2d
    covariance: Covariance2d
    hypotheses: list[Hypothesis]
    confidence: float
    quality: Quality


@dataclass(frozen=True, eq=False)
class OccupancyGrid:
    """A map of square cells, row by row from the lower left one (``nav_msgs/OccupancyGrid``).

    :param width: number of columns
    :param height: number of rows
    :param resolution: side of a cell [m]
    :param origin_x: x of the lower left corner of the lower left cell, in the map frame [m]
    :param origin_y: y of that corner [m]
    :param cells: FREE, OCCUPIED or UNKNOWN, ``width · height`` of them; in a grid of costs also values
        between; handed over, not shared
    """

    width: int
    height: int
    resolution: float
    origin_x: float
    origin_y: float
    cells: npt.NDArray[np.int8]


@dataclass(frozen=True, eq=False)
class ParticleCloud:
    """Samples of a belief about a pose.

    ``poses`` holds x, y [m], heading [rad] of one particle after the other; ``weights`` sum to 1. Both arrays
    are handed over, not shared.
    """

    poses: npt.NDArray[np.float32]
    weights: npt.NDArray[np.float32]


@dataclass(frozen=True, slots=True)
class Point2d(PointMethods):
    """A place in a plane [m]."""

    x: float
    y: float


@dataclass(frozen=True, slots=True)
class End:
    """A stretch where what is free meets what nobody has seen.

    :param map_from_middle: of it, in the frame of the map
    :param map_from_stand: where the robot can be to see beyond it, looking there
    :param length: of it [m]
    :param cost: of the way to the stand from where the robot was [m], more where it is narrow
    """

    map_from_middle: Point2d
    map_from_stand: Pose2d
    length: float
    cost: float


@dataclass(frozen=True, slots=True)
class Path2d:
    """A way through the map: points [m] to pass one after the other, start and goal included."""

    points: list[Point2d]


@dataclass(frozen=True, slots=True)
class NavigatorProgress:
    """How far a goal has got.

    :param map_from_base: where the robot is
    :param remaining: length of way left [m]
    :param waypoint: the point it heads for now
    :param driving: since when, in run time, it works on this goal
    """

    map_from_base: Pose2d
    remaining: float
    waypoint: Point2d
    driving: float


@dataclass(frozen=True, slots=True)
class NavigatorReached:
    """It stands where it takes the goal to be.

    :param doubt: why it may be elsewhere: for people; empty when it is localized
    """

    _type: ClassVar[str] = "Reached"

    map_from_base: Pose2d
    doubt: str


@dataclass(frozen=True, slots=True)
class NavigatorCancelled:
    """:param why: who or what called it off: for people"""

    _type: ClassVar[str] = "Cancelled"

    why: str


@dataclass(frozen=True, slots=True)
class NavigatorNoPath:
    """No path leads there.

    :param why: for people
    """

    _type: ClassVar[str] = "NoPath"

    why: str


@dataclass(frozen=True, slots=True)
class NavigatorStuck:
    """It got no nearer for too long, or nobody knew for too long where it is.

    :param map_from_base: where, as known last; the map's origin when it was never known, which ``why`` tells
    :param tried: since when it worked on this goal
    :param why: what it tried, what is left, what is near: for people
    """

    _type: ClassVar[str] = "Stuck"

    map_from_base: Pose2d
    tried: float
    why: str


@dataclass(frozen=True, slots=True)
class Tolerance:
    """When a goal counts as reached.

    :param angle: how far the heading may be off [rad]; π or more when the heading does not matter
    """

    distance: float
    angle: float


@dataclass(frozen=True, slots=True)
class PlaceFinderFound:
    """:param map_from_places.

    As many as were asked for, each with the clearance, no two nearer than twice the clearance; from each a
    robot as wide as that gets to each
    """

    _type: ClassVar[str] = "Found"

    map_from_places: list[Point2d]


@dataclass(frozen=True, slots=True)
class PlaceFinderNone:
    """:param why: in a sentence: the start, the count or the clearance will not do"""

    _type: ClassVar[str] = "None"

    why: str


class PlaceObjective(enum.Enum):
    """What makes places for a team good. Distances are those of paths."""

    ROOMS = "ROOMS"
    APART = "APART"
    NEAR = "NEAR"
    EVENLY = "EVENLY"
    VIEW = "VIEW"


@dataclass(frozen=True, slots=True)
class PlannerFound:
    """There is a path.

    :param cost: length of the way [m], more where it is narrow: what to compare ways by
    :param off_goal: how far from the goal it ends [m], when the robot can't be there but near it; else 0
    """

    _type: ClassVar[str] = "Found"

    path: Path2d
    cost: float
    off_goal: float


@dataclass(frozen=True, slots=True)
class PlannerNoPath:
    """No path leads there.

    :param why: for people
    """

    _type: ClassVar[str] = "NoPath"

    why: str


@dataclass(frozen=True, slots=True)
class Asked:
    """A question about one place, or about what ways to several cost, and the result.

    :param map_from_start: where the way begins
    :param map_from_goal: the place; of several the one that it costs least to get to, or the first where no
        way leads anywhere
    :param places: how many were asked about; at least 1
    :param reachable: to how many of them a way leads
    :param cost: of the way to the goal [m]; empty when there is none
    :param length: of that way [m]; empty when there is none, or when only costs were asked for
    :param why: there is none, for people; empty when there is one, or when only costs were asked for
    """

    map_from_start: Pose2d
    map_from_goal: Pose2d
    places: int
    reachable: int
    cost: float | None
    length: float | None
    why: str


@dataclass(frozen=True, eq=False)
class RangeArray:
    """One round of sonars or infrared sensors, each a cone (``sensor_msgs/Range``).

    Ranges [m] after REP 117 as in LaserScan.

    :param base_from_sensors: pose of each sensor in the base frame, looking along its x axis
    :param field_of_view: full opening angle of each cone [rad]
    :param range_min: shortest range they measure [m]
    :param range_max: longest range they measure [m]
    :param ranges: one for each sensor [m]; handed over, not shared
    """

    base_from_sensors: list[Pose2d]
    field_of_view: float
    range_min: float
    range_max: float
    ranges: npt.NDArray[np.float32]


@dataclass(frozen=True, slots=True)
class Opinion:
    """What a layer wants.

    :param twist: what the robot should do as far as this layer and those under it go
    :param state: what the layer is about, for people; empty when there is nothing to tell
    """

    layer: str
    twist: Twist2d
    state: str


@dataclass(frozen=True, slots=True)
class Decision:
    """What the layers of a pilot decided.

    :param twist: velocity that the pilot commands [m/s, rad/s]
    :param in_charge: the uppermost layer that changed the velocity of the layers below it; empty without layers
    :param opinions: of all layers, the lowest first
    """

    twist: Twist2d
    in_charge: str
    opinions: list[Opinion]


@dataclass(frozen=True, slots=True)
class Placed:
    """It is there now."""

    _type: ClassVar[str] = "Placed"


@dataclass(frozen=True, slots=True)
class Refused:
    """It stays where it was.

    A wall or something else is there, it is outside of the world, the pose is not finite, or nothing has that
    name.
    """

    _type: ClassVar[str] = "Refused"

    why: str


@dataclass(frozen=True, slots=True)
class Contact:
    """A robot has touched something.

    :param time: when the touch began
    :param other: the other robot or thing, or ``wall``
    """

    time: float
    robot: str
    other: str
