package rsal.scenario.condition;

import java.util.List;
import rsal.metric.NameKind;
import rsal.metric.QuantityType;
import rsal.metric.SignalType;

/// What every run knows of itself, whatever its agents do. [rsal.metric.MetricType] adds others.
public final class RunQuantities {
    public static final QuantityType TIME = QuantityType.of("time", "s", "since the start");
    public static final QuantityType COLLISIONS =
            QuantityType.of("collisions", "", "collisions so far of simulated robots, with walls and with each other");
    public static final QuantityType WALL_COLLISIONS =
            QuantityType.of("wallCollisions", "", "collisions so far of simulated robots with walls");
    public static final QuantityType ARRIVED = QuantityType.of(
                    "arrived", "", "robots that have reached the goal they were sent to last", NameKind.ROLE)
            .countingAll();
    public static final QuantityType GONE =
            QuantityType.of("gone", "", "robots that are gone now, by a fault", NameKind.ROLE);
    public static final QuantityType FAULTS =
            QuantityType.of("faults", "", "faults that have begun so far, each counted for each that has it");
    public static final QuantityType MESSAGES = QuantityType.of(
                    "sentMessages", "", "messages sent so far", NameKind.TOPIC)
            .orWithoutNames();
    public static final QuantityType HEARD_MESSAGES = QuantityType.of(
                    "receivedMessages", "", "messages received so far, each counted for each receiver", NameKind.TOPIC)
            .orWithoutNames();
    public static final QuantityType LOST_MESSAGES = QuantityType.of(
                    "lostMessages", "", "messages lost so far, each counted for each receiver", NameKind.TOPIC)
            .orWithoutNames();
    public static final QuantityType EXPLORED =
            QuantityType.of("explored", "", "share of the reachable floor that is on maps, 0 to 1");
    public static final QuantityType EXPLORING = QuantityType.of(
            "exploring", "", "robots that draw a map and can still get to where it ends", NameKind.ROLE);
    public static final QuantityType COLLECTED = QuantityType.of(
                    "collected", "", "things that lie in their depot", NameKind.THINGS_TO_COLLECT)
            .countingAll();
    public static final QuantityType REACHED = QuantityType.of(
                    "reached", "", "things that a robot has got to", NameKind.THINGS_TO_REACH)
            .countingAll();
    public static final QuantityType DISTANCE = QuantityType.of(
            "distance", "m", "distance of the two nearest robots of two roles", NameKind.ROLE, NameKind.ROLE);
    public static final QuantityType WITHIN =
            QuantityType.of("within", "", "robots that are in a place", NameKind.ROLE, NameKind.PLACE);
    public static final QuantityType VISITS =
            QuantityType.of("visits", "", "how often robots have come into a place", NameKind.ROLE, NameKind.PLACE);
    public static final QuantityType METRIC =
            QuantityType.of("metric", "", "what an agent has published last under a name", NameKind.PUBLISHED);

    /// In the order in which people are told.
    public static final List<QuantityType> ALL = List.of(
            TIME,
            COLLISIONS,
            WALL_COLLISIONS,
            ARRIVED,
            GONE,
            FAULTS,
            MESSAGES,
            HEARD_MESSAGES,
            LOST_MESSAGES,
            EXPLORED,
            EXPLORING,
            COLLECTED,
            REACHED,
            DISTANCE,
            WITHIN,
            VISITS,
            METRIC);

    public static final SignalType POSE_ERROR = SignalType.ofRobots(
            "poseError", "m", "distance of a robot and where its localizer says it is, at each of its readings");
    public static final SignalType BATTERY_LEVEL =
            SignalType.ofRobots("batteryLevel", "", "share of its battery that is left to a robot, 0 to 1");

    public static final List<SignalType> SIGNALS = List.of(POSE_ERROR, BATTERY_LEVEL);

    private RunQuantities() {}
}
