package rsal.server;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.stream.IntStream;
import rsal.data.ActuatorState;
import rsal.data.BatteryState;
import rsal.data.Blobs;
import rsal.data.Blobs.Blob;
import rsal.data.BumperState;
import rsal.data.Covariance2d;
import rsal.data.Fiducials;
import rsal.data.Fiducials.Fiducial;
import rsal.data.GripperState;
import rsal.data.Point2d;
import rsal.data.PoseEstimate;
import rsal.scenario.run.Reading;
import rsal.server.Messages.Fact;
import rsal.server.Messages.ReadingInfo;
import rsal.server.Messages.Readings;

/// Says in words what devices have told that the map does not show.
final class ReadingWords {
    /// Of one device.
    static final int MOST_FACTS = 12;

    private ReadingWords() {}

    static Readings of(List<Reading> readings) {
        return new Readings(readings.stream()
                .flatMap(reading -> facts(reading.value().value()).map(facts -> info(reading.device(), facts)).stream())
                .toList());
    }

    private static ReadingInfo info(String device, List<Fact> facts) {
        return new ReadingInfo(
                device, facts.stream().limit(MOST_FACTS).toList(), Math.max(0, facts.size() - MOST_FACTS));
    }

    private static Optional<List<Fact>> facts(Object value) {
        return switch (value) {
            case GripperState gripper -> Optional.of(gripper(gripper));
            case BatteryState battery -> Optional.of(battery(battery));
            case Blobs blobs ->
                Optional.of(
                        blobs.blobs().stream().map(blob -> blob(blobs, blob)).toList());
            case Fiducials seen ->
                Optional.of(seen.fiducials().stream().map(ReadingWords::marker).toList());
            case BumperState bumpers -> Optional.of(bumpers(bumpers));
            case ActuatorState actuator -> Optional.of(List.of(actuator(actuator)));
            case PoseEstimate estimate -> Optional.of(estimate(estimate));
            default -> Optional.empty();
        };
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
        return Double.isFinite(state.closed())
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
            case ROTATIONAL -> String.format(Locale.ROOT, "%.0f°", Math.toDegrees(state.position()));
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

    /// Where something is as seen from the robot: `1.20 m, 15° left`.
    private static String place(Point2d baseFromThing) {
        return String.format(Locale.ROOT, "%.2f m, ", Math.hypot(baseFromThing.x(), baseFromThing.y()))
                + direction(Math.atan2(baseFromThing.y(), baseFromThing.x()));
    }

    private static String direction(double bearing) {
        long degrees = Math.round(Math.toDegrees(bearing));
        return degrees == 0 ? "ahead" : degrees > 0 ? degrees + "° left" : -degrees + "° right";
    }

    private static Fact fact(String name, String value) {
        return new Fact(name, value, Optional.empty());
    }
}
