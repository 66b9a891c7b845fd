package rsal.server.description;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
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
import rsal.data.Interval;
import rsal.data.LaserScan;
import rsal.data.LightState;
import rsal.data.OccupancyGrid;
import rsal.data.Odometry;
import rsal.data.Pose2d;
import rsal.data.PoseEstimate;
import rsal.data.RangeArray;
import rsal.data.Rgb;
import rsal.data.Stamped;
import rsal.data.Twist2d;
import rsal.device.Planner;
import rsal.engine.report.NavigatorState;
import rsal.engine.report.Reading;
import rsal.server.message.Messages.ReadingInfo;

class ReadingWordsTest {
    /// Of a device that nobody here knows.
    public record Weather(double temperature, int drops, double wind) {}

    private static final Pose2d AHEAD = new Pose2d(0, 0, 0);

    private static List<ReadingInfo> reported(Object value) {
        return ReadingWords.of(
                        List.of(new Reading("device", new Stamped<>(Instant.EPOCH, "r1/device", value), Duration.ZERO)))
                .readings();
    }

    private static List<String> words(Object value) {
        return reported(value).getFirst().facts().stream()
                .map(fact -> fact.name() + ": " + fact.value())
                .toList();
    }

    @Test
    void aLocalizerSaysHowSureItIs() {
        var here = new Pose2d(1, 2, 0);
        var covariance = Covariance2d.ofDeviations(0.2, 0.1, Math.toRadians(3));
        assertThat(words(new PoseEstimate(
                        here,
                        covariance,
                        List.of(
                                new PoseEstimate.Hypothesis(0.6, here, covariance),
                                new PoseEstimate.Hypothesis(0.4, AHEAD, covariance)),
                        0.584,
                        PoseEstimate.Quality.AMBIGUOUS)))
                .containsExactly("state: ambiguous, 58 % sure", "deviation: 0.20 m, 3.0°", "places it may be at: 2");
    }

    @Test
    void aNavigatorSaysWhereItGoes() {
        assertThat(words(new NavigatorState(Optional.of(new Pose2d(1, -2, Math.PI / 2)), 3.46, false)))
                .containsExactly("goal: 1.00, -2.00 m, 90°", "path left: 3.5 m", "state: on its way");
        assertThat(words(new NavigatorState(Optional.of(AHEAD), 0, true)))
                .contains("path left: none yet", "state: paused");
        assertThat(words(new NavigatorState(Optional.empty(), 0, false))).containsExactly("goal: none");
    }

    @Test
    void aPlannerSaysWhatItWasAskedLast() {
        var goal = new Pose2d(1, -2, Math.PI / 2);
        OptionalDouble none = OptionalDouble.empty();
        assertThat(words(new Planner.Asked(AHEAD, goal, 1, 1, OptionalDouble.of(4.26), OptionalDouble.of(3), "")))
                .containsExactly(
                        "asked for: a path",
                        "from: 0.00, 0.00 m",
                        "to: 1.00, -2.00 m",
                        "found: a path of 3.0 m, cost 4.3 m");
        assertThat(words(new Planner.Asked(AHEAD, goal, 1, 0, none, none, "The goal is in a wall.")))
                .endsWith("to: 1.00, -2.00 m", "found: no path: The goal is in a wall.");
        assertThat(words(new Planner.Asked(AHEAD, goal, 5, 3, OptionalDouble.of(4.26), none, "")))
                .containsExactly(
                        "asked for: costs of the paths to 5 places",
                        "from: 0.00, 0.00 m",
                        "of least cost, to: 1.00, -2.00 m",
                        "found: a path, cost 4.3 m",
                        "no path leads to: 2");
    }

    @Test
    void aGripperSaysHowItStandsAndWhatItFeels() {
        assertThat(words(new GripperState(
                        GripperState.Paddles.CLOSING, 0.4, GripperState.Lift.UP, 1, true, true, true, false, false)))
                .containsExactly(
                        "paddles: closing, 40 % closed",
                        "lift: up",
                        "holds: nothing",
                        "between the paddles: something near the tips and deep inside",
                        "touched paddles: left");
        assertThat(words(new GripperState(
                        GripperState.Paddles.OPEN,
                        Double.NaN,
                        GripperState.Lift.DOWN,
                        0,
                        false,
                        false,
                        false,
                        false,
                        true)))
                .containsExactly(
                        "paddles: open",
                        "lift: down",
                        "holds: something",
                        "between the paddles: nothing",
                        "touched paddles: none");
    }

    @Test
    void aBatteryReportsWhatIsLeftAsFarAsItCan() {
        assertThat(words(BatteryState.of(3000, 4000, -20, BatteryState.Charging.DISCHARGING)))
                .containsExactly("level: 75.0 %", "charge: 3000 of 4000 J", "power: -20.0 W", "state: discharging");
        double endless = Double.POSITIVE_INFINITY;
        assertThat(words(BatteryState.of(endless, endless, 5, BatteryState.Charging.GIVING)))
                .containsExactly("charge: never runs dry", "power: +5.0 W", "state: giving");
        double unknown = Double.NaN;
        assertThat(words(new BatteryState(unknown, unknown, unknown, unknown, 12.3, BatteryState.Charging.UNKNOWN)))
                .containsExactly("voltage: 12.3 V", "state: unknown");
    }

    @Test
    void blobsAreAsTheRobotSeesThem() {
        Rgb red = new Rgb(255, 0, 0);
        var near = new Blob(red, 10, 20, 30, 35, 20, 27, 300, 2);
        var far = new Blob(red, 40, 0, 60, 5, 50, 2, 100, Double.NaN);
        var image = new Blobs(AHEAD, 80, 60, Math.toRadians(80), List.of(near, far));
        assertThat(words(image))
                .containsExactly("#ff0000: 2.00 m, 20° left; 20 × 15 px", "#ff0000: 10° right; 20 × 5 px");
        assertThat(reported(image).getFirst().facts().getFirst().color()).contains("#ff0000");
    }

    @Test
    void ofManyOnlyTheFirstAreReported() {
        var marker = new Fiducial(OptionalInt.of(7), new Pose2d(3, 4, 0));
        var seen = new Fiducials(AHEAD, 3, 8, Collections.nCopies(50, marker));
        assertThat(words(seen)).hasSize(ReadingWords.MOST_FACTS).contains("marker 7: 5.00 m, 53° left");
        assertThat(reported(seen).getFirst().left()).isEqualTo(50 - ReadingWords.MOST_FACTS);
        var distant = new Fiducial(OptionalInt.empty(), new Pose2d(9, 0, 0));
        assertThat(words(new Fiducials(AHEAD, 3, 8, List.of(distant))))
                .containsExactly("too far to read: 9.00 m, ahead");
    }

    @Test
    void bumpersAndActuatorsAreReportedToo() {
        assertThat(words(new BumperState(List.of(AHEAD, AHEAD), List.of(false, true))))
                .containsExactly("bumper 1: free", "bumper 2: pressed");
        assertThat(words(new ActuatorState(
                        ActuatorState.Joint.ROTATIONAL,
                        Math.PI / 2,
                        0,
                        new Interval(-2, 2),
                        ActuatorState.Motion.STALLED)))
                .containsExactly("position: 90°, stalled");
    }

    @Test
    void whatMeasuresDistancesSaysWhatIsNearestAsSeenFromTheRobot() {
        var mounted = new Pose2d(0.1, 0, 0);
        float none = Float.POSITIVE_INFINITY;
        var scan = new LaserScan(mounted, -Math.PI / 2, Math.PI / 2, 0.02, 8, new float[] {none, 0.9f, 0.5f});
        assertThat(words(scan)).containsExactly("nearest: 0.51 m, 79° left", "hits: 2 of 3");
        var sonars =
                new RangeArray(List.of(mounted, Pose2d.ofDegrees(0, 0.1, 90)), 0.2, 0.1, 5, new float[] {none, 1.5f});
        assertThat(words(sonars)).containsExactly("nearest: 1.60 m, 90° left", "hits: 1 of 2");
        var blind = new LaserScan(mounted, 0, 0.1, 0.02, 8, new float[] {Float.NaN});
        assertThat(words(blind)).containsExactly("nearest: nothing", "hits: 0 of 1");
    }

    @Test
    void basesPilotsLightsAndMappersAreReportedToo() {
        var velocity = new Twist2d(0.3, 0, Math.toRadians(-12));
        assertThat(words(new Odometry(Pose2d.ofDegrees(1, -2, 90), velocity, true)))
                .containsExactly(
                        "velocity: 0.30 m/s", "turn: -12°/s", "odometry: 1.00, -2.00 m, 90°", "motors: stalled");
        assertThat(words(new Decision(new Twist2d(0, 0.1, 0), "", List.of())))
                .containsExactly("in charge: nobody", "velocity: 0.00 m/s, 0.10 m/s left", "turn: 0°/s");
        assertThat(words(new LightState(new Rgb(0, 255, 0), LightState.Signal.ON, true)))
                .containsExactly("light: shines");
        var map = new OccupancyGrid(2, 2, 0.05, 0, 0, new byte[] {0, 100, -1, -1});
        assertThat(words(map)).containsExactly("map: 2 × 2 cells", "resolution: 0.05 m", "known: 50 %");
    }

    @Test
    void ofOthersTheNumbersAreReported() {
        assertThat(words(new Weather(21.123456, 3, Double.NaN)))
                .containsExactly("temperature: 21.12", "drops: 3", "wind: none");
    }

    @Test
    void itsAgeIsReported() {
        var late = new Reading("device", new Stamped<>(Instant.EPOCH, "r1/device", 7), Duration.ofMillis(1250));
        assertThat(ReadingWords.of(List.of(late)).readings())
                .extracting(ReadingInfo::age)
                .containsExactly(1.25);
    }
}
