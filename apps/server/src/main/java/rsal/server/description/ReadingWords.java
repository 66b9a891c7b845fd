package rsal.server.description;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.Base64;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.IntFunction;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;
import rsal.behavior.Decision;
import rsal.data.ActuatorState;
import rsal.data.BatteryState;
import rsal.data.Blobs;
import rsal.data.Blobs.Blob;
import rsal.data.BumperState;
import rsal.data.Covariance2d;
import rsal.data.Fiducials;
import rsal.data.Fiducials.Fiducial;
import rsal.data.GripperState;
import rsal.data.LaserScan;
import rsal.data.LightState;
import rsal.data.OccupancyGrid;
import rsal.data.Odometry;
import rsal.data.Picture;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.PoseEstimate;
import rsal.data.RangeArray;
import rsal.data.Twist2d;
import rsal.device.Planner;
import rsal.engine.report.NavigatorState;
import rsal.engine.report.Reading;
import rsal.server.message.Messages.Fact;
import rsal.server.message.Messages.ImageInfo;
import rsal.server.message.Messages.NumberInfo;
import rsal.server.message.Messages.ReadingInfo;
import rsal.server.message.Messages.Readings;

/// Says in words what devices have told. Of those that nobody thought of here it tells the numbers; see
/// [PlottableNumbers].
public final class ReadingWords {
    /// Of one device.
    static final int MOST_FACTS = 12;

    private static final int MOST_PIXELS = 200; // of an image, each way

    private static final Point2d HERE = new Point2d(0, 0);
    private static final MathContext FOUR_DIGITS = new MathContext(4);

    private ReadingWords() {}

    public static Readings of(List<Reading> readings) {
        return new Readings(readings.stream().map(ReadingWords::info).toList());
    }

    private static ReadingInfo info(Reading reading) {
        Object reported = reading.value().value();
        List<Fact> facts = facts(reported);
        return new ReadingInfo(
                reading.device(),
                facts.stream().limit(MOST_FACTS).toList(),
                Math.max(0, facts.size() - MOST_FACTS),
                reading.age().toMillis() / 1e3,
                reported instanceof Picture picture ? Optional.of(image(picture)) : Optional.empty());
    }

    /// Every n-th pixel each way, so that it is small enough to be sent several times a second.
    private static ImageInfo image(Picture picture) {
        int step = Math.max(1, Math.ceilDiv(Math.max(picture.width(), picture.height()), MOST_PIXELS));
        int width = Math.ceilDiv(picture.width(), step);
        int height = Math.ceilDiv(picture.height(), step);
        byte[] rgb = new byte[3 * width * height];
        int at = 0;
        for (int row = 0; row < height; row++) {
            for (int column = 0; column < width; column++) {
                int color = picture.color(column * step, row * step);
                rgb[at++] = (byte) (color >> 16);
                rgb[at++] = (byte) (color >> 8);
                rgb[at++] = (byte) color;
            }
        }
        return new ImageInfo(width, height, Base64.getEncoder().encodeToString(rgb));
    }

    private static List<Fact> facts(Object value) {
        return switch (value) {
            case LaserScan scan -> scan(scan);
            case RangeArray ranges -> ranges(ranges);
            case Odometry odometry -> odometry(odometry);
            case GripperState gripper -> gripper(gripper);
            case BatteryState battery -> battery(battery);
            case Blobs blobs ->
                blobs.blobs().stream().map(blob -> blob(blobs, blob)).toList();
            case Fiducials seen ->
                seen.fiducials().stream().map(ReadingWords::marker).toList();
            case BumperState bumpers -> bumpers(bumpers);
            case ActuatorState actuator -> List.of(actuator(actuator));
            case PoseEstimate estimate -> estimate(estimate);
            case LightState light -> light(light);
            case OccupancyGrid map -> map(map);
            case Decision decision -> decision(decision);
            case NavigatorState navigator -> navigator(navigator);
            case Planner.Asked asked -> asked(asked);
            case Picture picture -> List.of(fact("image", "%d × %d px".formatted(picture.width(), picture.height())));
            default ->
                PlottableNumbers.of(value).stream().map(ReadingWords::number).toList();
        };
    }

    private static List<Fact> scan(LaserScan scan) {
        return hits(
                scan.count(),
                scan::isHit,
                beam -> scan.baseFromLaser().compose(Pose2d.polar(scan.ranges()[beam], scan.angle(beam))));
    }

    private static List<Fact> ranges(RangeArray array) {
        return hits(
                array.count(),
                array::isHit,
                sensor -> array.baseFromSensors().get(sensor).compose(Pose2d.polar(array.ranges()[sensor], 0)));
    }

    /// @param hit where one met something, as seen from the robot
    private static List<Fact> hits(int count, IntPredicate isHit, IntFunction<Pose2d> hit) {
        List<Point2d> hits = IntStream.range(0, count)
                .filter(isHit)
                .mapToObj(i -> hit.apply(i).position())
                .toList();
        String nearest = hits.stream()
                .min(Comparator.comparingDouble(HERE::distanceTo))
                .map(ReadingWords::place)
                .orElse("nothing");
        return List.of(fact("nearest", nearest), fact("hits", "%d of %d".formatted(hits.size(), count)));
    }

    private static List<Fact> odometry(Odometry odometry) {
        Pose2d pose = odometry.odomFromBase();
        var facts = new ArrayList<Fact>(velocity(odometry.velocity()));
        facts.add(fact("odometry", position(pose)));
        if (odometry.stalled()) {
            facts.add(fact("motors", "stalled"));
        }
        return facts;
    }

    private static List<Fact> velocity(Twist2d velocity) {
        String along = String.format(Locale.ROOT, "%.2f m/s", velocity.vx());
        String sideways = velocity.vy() == 0 ? "" : String.format(Locale.ROOT, ", %.2f m/s left", velocity.vy());
        return List.of(fact("velocity", along + sideways), fact("turn", degrees(velocity.omega()) + "/s"));
    }

    private static List<Fact> light(LightState light) {
        return List.of(new Fact(
                "light",
                light.lit() ? "shines" : "dark",
                Optional.of(light.color().toString())));
    }

    private static List<Fact> map(OccupancyGrid map) {
        int known = 0;
        for (byte cell : map.cells()) {
            known += cell == OccupancyGrid.UNKNOWN ? 0 : 1;
        }
        return List.of(
                fact("map", "%d × %d cells".formatted(map.width(), map.height())),
                fact("resolution", String.format(Locale.ROOT, "%.2f m", map.resolution())),
                fact("known", String.format(Locale.ROOT, "%.0f %%", 100.0 * known / Math.max(1, map.cells().length))));
    }

    private static List<Fact> decision(Decision decision) {
        var facts = new ArrayList<Fact>();
        facts.add(fact("in charge", decision.inCharge().isEmpty() ? "nobody" : decision.inCharge()));
        facts.addAll(velocity(decision.twist()));
        return facts;
    }

    private static List<Fact> navigator(NavigatorState navigator) {
        return navigator
                .mapFromGoal()
                .map(goal -> List.of(
                        fact("goal", position(goal)),
                        fact(
                                "path left",
                                navigator.remaining() == 0
                                        ? "none yet"
                                        : String.format(Locale.ROOT, "%.1f m", navigator.remaining())),
                        fact("state", navigator.paused() ? "paused" : "on its way")))
                .orElse(List.of(fact("goal", "none")));
    }

    private static List<Fact> asked(Planner.Asked asked) {
        var facts = new ArrayList<Fact>();
        boolean one = asked.places() == 1;
        facts.add(fact("asked for", one ? "a path" : "costs of the paths to %d places".formatted(asked.places())));
        facts.add(fact("from", spot(asked.mapFromStart())));
        facts.add(fact(one || asked.cost().isEmpty() ? "to" : "of least cost, to", spot(asked.mapFromGoal())));
        if (asked.cost().isEmpty()) {
            facts.add(fact("found", asked.why().isEmpty() ? "no path" : "no path: " + asked.why()));
            return facts;
        }
        String cost = String.format(Locale.ROOT, "cost %.1f m", asked.cost().getAsDouble());
        facts.add(fact(
                "found",
                asked.length().isEmpty()
                        ? "a path, " + cost
                        : String.format(
                                        Locale.ROOT,
                                        "a path of %.1f m, ",
                                        asked.length().getAsDouble())
                                + cost));
        if (asked.reachable() < asked.places()) {
            facts.add(fact("no path leads to", String.valueOf(asked.places() - asked.reachable())));
        }
        return facts;
    }

    /// One of a device that nobody thought of here.
    private static Fact number(NumberInfo number) {
        return fact(
                number.title(),
                number.value()
                        .map(value -> new BigDecimal(value, FOUR_DIGITS)
                                        .stripTrailingZeros()
                                        .toPlainString()
                                + (number.unit().isEmpty() || number.unit().startsWith("°") ? "" : " ")
                                + number.unit())
                        .orElse("none"));
    }

    private static List<Fact> gripper(GripperState state) {
        var between = new ArrayList<String>();
        if (state.outerBeamBroken()) {
            between.add("near the tips");
        }
        if (state.innerBeamBroken()) {
            between.add("deep inside");
        }
        var touched = new ArrayList<String>();
        if (state.leftContact()) {
            touched.add("left");
        }
        if (state.rightContact()) {
            touched.add("right");
        }
        return List.of(
                fact("paddles", word(state.paddles()) + closed(state)),
                fact("lift", word(state.lift())),
                fact("holds", state.holding() ? "something" : "nothing"),
                fact(
                        "between the paddles",
                        between.isEmpty() ? "nothing" : "something " + String.join(" and ", between)),
                fact("touched paddles", touched.isEmpty() ? "none" : String.join(" and ", touched)));
    }

    private static String closed(GripperState state) {
        return state.closed() > 0 && state.closed() < 1
                ? String.format(Locale.ROOT, ", %.0f %% closed", 100 * state.closed())
                : "";
    }

    private static String word(Enum<?> state) {
        return state.name().toLowerCase(Locale.ROOT);
    }

    private static List<Fact> battery(BatteryState state) {
        var facts = new ArrayList<Fact>();
        if (state.capacity() == Double.POSITIVE_INFINITY) {
            facts.add(fact("charge", "never runs dry"));
        } else if (Double.isFinite(state.level())) {
            facts.add(fact("level", String.format(Locale.ROOT, "%.1f %%", 100 * state.level())));
        }
        if (Double.isFinite(state.charge()) && Double.isFinite(state.capacity())) {
            facts.add(fact("charge", String.format(Locale.ROOT, "%.0f of %.0f J", state.charge(), state.capacity())));
        }
        if (Double.isFinite(state.power())) {
            facts.add(fact("power", String.format(Locale.ROOT, "%+.1f W", state.power())));
        }
        if (Double.isFinite(state.voltage())) {
            facts.add(fact("voltage", String.format(Locale.ROOT, "%.1f V", state.voltage())));
        }
        facts.add(fact("state", word(state.charging())));
        return facts;
    }

    private static Fact blob(Blobs image, Blob blob) {
        String where = image.baseFromBlob(blob)
                .map(ReadingWords::place)
                .orElseGet(() -> direction(image.baseFromCamera().theta() + image.bearing(blob)));
        return new Fact(
                blob.color().toString(),
                "%s; %d × %d px".formatted(where, blob.right() - blob.left(), blob.bottom() - blob.top()),
                Optional.of(blob.color().toString()));
    }

    private static Fact marker(Fiducial marker) {
        OptionalInt id = marker.id();
        return fact(
                id.isPresent() ? "marker " + id.getAsInt() : "too far to read",
                place(marker.baseFromFiducial().position()));
    }

    private static List<Fact> bumpers(BumperState state) {
        return IntStream.range(0, state.pressed().size())
                .mapToObj(i -> fact("bumper " + (i + 1), state.pressed().get(i) ? "pressed" : "free"))
                .toList();
    }

    private static Fact actuator(ActuatorState state) {
        String position = switch (state.joint()) {
            case LINEAR -> String.format(Locale.ROOT, "%.2f m", state.position());
            case ROTATIONAL -> degrees(state.position());
        };
        return fact("position", "%s, %s".formatted(position, word(state.motion())));
    }

    private static List<Fact> estimate(PoseEstimate estimate) {
        Covariance2d covariance = estimate.covariance();
        var facts = new ArrayList<Fact>();
        facts.add(fact(
                "state",
                String.format(Locale.ROOT, "%s, %.0f %% sure", word(estimate.quality()), 100 * estimate.confidence())));
        facts.add(fact(
                "deviation",
                String.format(
                        Locale.ROOT,
                        "%.2f m, %.1f°",
                        covariance.positionDeviation(),
                        Math.toDegrees(Math.sqrt(Math.max(0, covariance.thetaTheta()))))));
        if (estimate.hypotheses().size() > 1) {
            facts.add(fact(
                    "places it may be at", String.valueOf(estimate.hypotheses().size())));
        }
        return facts;
    }

    private static String position(Pose2d pose) {
        return spot(pose) + ", " + degrees(pose.theta());
    }

    /// Of which the heading does not matter.
    private static String spot(Pose2d pose) {
        return String.format(Locale.ROOT, "%.2f, %.2f m", pose.x(), pose.y());
    }

    /// Where something is as seen from the robot: `1.20 m, 15° left`.
    private static String place(Point2d baseFromThing) {
        return String.format(Locale.ROOT, "%.2f m, ", Math.hypot(baseFromThing.x(), baseFromThing.y()))
                + direction(Math.atan2(baseFromThing.y(), baseFromThing.x()));
    }

    private static String direction(double bearing) {
        long degrees = Math.round(Math.toDegrees(bearing));
        return degrees == 0 ? "ahead" : degrees > 0 ? degrees + "° left" : -degrees + "° right";
    }

    /// In whole ones, and never -0.
    private static String degrees(double radians) {
        return Math.round(Math.toDegrees(radians)) + "°";
    }

    private static Fact fact(String name, String value) {
        return new Fact(name, value, Optional.empty());
    }
}
