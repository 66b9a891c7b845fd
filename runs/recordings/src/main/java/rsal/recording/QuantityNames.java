package rsal.recording;

import java.lang.reflect.RecordComponent;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import rsal.data.ActuatorState;
import rsal.data.Unit;

/// What people call the [Quantities] in what devices tell, and the units these have: the only place that says
/// so, as a number in Java has its unit in a comment. Parts that nobody thought of here are called as in Java
/// and have the [Unit] that is written there.
final class QuantityNames {
    private static final String ANGLE = "rad";
    private static final String TURN = "rad/s";

    private static final Map<String, Words> KNOWN = Map.ofEntries(
            known("Pose2d.x", "x", "m"),
            known("Pose2d.y", "y", "m"),
            known("Pose2d.theta", "heading", ANGLE),
            known("Point2d.x", "x", "m"),
            known("Point2d.y", "y", "m"),
            known("Twist2d.vx", "speed ahead", "m/s"),
            known("Twist2d.vy", "speed to the left", "m/s"),
            known("Twist2d.omega", "turn", TURN),
            known("Odometry.odomFromBase", "odometry", ""),
            known("Odometry.velocity", "", ""),
            known("PoseEstimate.mapFromBase", "estimate", ""),
            known("PoseEstimate.covariance", "estimate", ""),
            known("PoseEstimate.confidence", "confidence", ""),
            known("Covariance2d.xx", "variance of x", "m²"),
            known("Covariance2d.xy", "covariance of x and y", "m²"),
            known("Covariance2d.xTheta", "covariance of x and heading", "m·rad"),
            known("Covariance2d.yy", "variance of y", "m²"),
            known("Covariance2d.yTheta", "covariance of y and heading", "m·rad"),
            known("Covariance2d.thetaTheta", "variance of the heading", "rad²"),
            known("LaserScan.ranges", "distance,", "m"),
            known("RangeArray.ranges", "distance,", "m"),
            known("BatteryState.charge", "charge", "J"),
            known("BatteryState.level", "level", ""),
            known("BatteryState.power", "power", "W"),
            known("BatteryState.voltage", "voltage", "V"),
            known("Blobs.blobs", "blobs,", ""),
            known("Fiducials.fiducials", "markers,", ""),
            known("Decision.twist", "", ""),
            known("NavigatorState.mapFromGoal", "goal", ""),
            known("NavigatorState.remaining", "path left", "m"),
            known("Asked.mapFromStart", "start", ""),
            known("Asked.mapFromGoal", "goal", ""),
            known("Asked.places", "places asked about", ""),
            known("Asked.reachable", "places reachable", ""),
            known("Asked.cost", "cost", "m"),
            known("Asked.length", "length of the path", "m"));

    /// What is told with each reading and is the same in all: how a device is made and mounted. Nobody plots that.
    static final Set<String> SETTINGS = Set.of(
            "OccupancyGrid.width",
            "OccupancyGrid.height",
            "OccupancyGrid.resolution",
            "OccupancyGrid.originX",
            "OccupancyGrid.originY",
            "LaserScan.baseFromLaser",
            "LaserScan.angleMin",
            "LaserScan.angleIncrement",
            "LaserScan.rangeMin",
            "LaserScan.rangeMax",
            "RangeArray.baseFromSensors",
            "RangeArray.fieldOfView",
            "RangeArray.rangeMin",
            "RangeArray.rangeMax",
            "BumperState.baseFromBumpers",
            "BatteryState.capacity",
            "ActuatorState.limits",
            "Blobs.baseFromCamera",
            "Blobs.fieldOfView",
            "Blobs.width",
            "Blobs.height",
            "Fiducials.baseFromFinder",
            "Fiducials.fieldOfView",
            "Fiducials.rangeMax");

    private QuantityNames() {}

    /// @param title of the number, a few words; empty where its device says it all
    /// @param unit of SI; empty where it has none, or nobody knows
    record Words(String title, String unit) {
        static final Words NONE = new Words("", "");

        /// Of something in it; what has no unit of its own has that of what it is in.
        Words and(Words inner) {
            return new Words((title + " " + inner.title).strip(), inner.unit.isEmpty() ? unit : inner.unit);
        }

        Words and(String inner) {
            return and(new Words(inner, ""));
        }

        Words in(String other) {
            return new Words(title, other);
        }
    }

    /// Records and their parts that have words here: `Pose2d.x`.
    static Set<String> known() {
        return KNOWN.keySet();
    }

    private static Map.Entry<String, Words> known(String where, String title, String unit) {
        return Map.entry(where, new Words(title, unit));
    }

    /// Whether it stays the same, so that there is nothing to plot.
    static boolean isSetting(RecordComponent component) {
        Unit unit = component.getAnnotation(Unit.class);
        return SETTINGS.contains(key(component)) || (unit != null && unit.isFixed());
    }

    private static String key(RecordComponent component) {
        return component.getDeclaringRecord().getSimpleName() + "." + component.getName();
    }

    static Words of(RecordComponent component) {
        Words known = KNOWN.get(key(component));
        if (known != null) {
            return known;
        }
        Words guessed = guessed(component.getName());
        Unit unit = component.getAnnotation(Unit.class);
        return unit == null ? guessed : guessed.in(unit.value());
    }

    /// What a joint turns is an angle, else it is a length.
    static Words of(ActuatorState actuator, RecordComponent component) {
        boolean turns = actuator.joint() == ActuatorState.Joint.ROTATIONAL;
        return switch (component.getName()) {
            case "speed" -> new Words("speed", turns ? TURN : "m/s");
            case "joint", "motion" -> Words.NONE;
            default -> new Words(of(component).title(), turns ? ANGLE : "m");
        };
    }

    /// `leftContact` → `left contact`.
    private static Words guessed(String name) {
        String title = name.replaceAll("(?<=[a-z0-9])(?=[A-Z])", " ").toLowerCase(Locale.ROOT);
        boolean angle = name.equals("theta") || title.contains("angle") || name.equals("bearing");
        return new Words(title, angle ? ANGLE : name.equals("omega") ? TURN : "");
    }
}
