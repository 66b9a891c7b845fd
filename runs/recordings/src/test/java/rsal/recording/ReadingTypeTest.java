package rsal.recording;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rsal.behavior.Decision;
import rsal.behavior.Decision.Opinion;
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
import rsal.data.PoseEstimate.Hypothesis;
import rsal.data.RangeArray;
import rsal.data.Rgb;
import rsal.data.Stamped;
import rsal.data.Twist2d;
import rsal.device.Planner;
import rsal.engine.report.NavigatorState;
import rsal.mcap.ByteSink;
import rsal.recording.proto.ProtoWriter;

class ReadingTypeTest {
    private static final Pose2d POSE = new Pose2d(1.5, -2, 0.25);
    private static final Twist2d TWIST = new Twist2d(0.5, 0, -0.25);

    /// With much that is 0, empty or unknown, which messages leave out.
    static List<Record> values() {
        return List.of(
                new ActuatorState(
                        ActuatorState.Joint.ROTATIONAL, 0, -0.5, Interval.around0(1), ActuatorState.Motion.MOVING),
                BatteryState.of(20, Double.POSITIVE_INFINITY, -3, BatteryState.Charging.DISCHARGING),
                new Blobs(POSE, 80, 60, 1.25, List.of()),
                new Blobs(
                        Pose2d.ORIGIN,
                        80,
                        60,
                        1.25,
                        List.of(
                                new Blob(new Rgb(255, 0, 16), 0, 0, 4, 3, 2, 1.5, 12, 3.5),
                                new Blob(new Rgb(0, 0, 0), -1, 7, 80, 60, 40, 30, 4000, Double.NaN))),
                new BumperState(List.of(POSE, Pose2d.ORIGIN), List.of(false, true)),
                new Decision(
                        TWIST,
                        "avoid",
                        List.of(new Opinion("avoid", TWIST, ""), new Opinion("", Twist2d.STOP, "turns"))),
                new Decision(Twist2d.STOP, "", List.of()),
                new Fiducials(
                        POSE,
                        1,
                        5,
                        List.of(
                                new Fiducial(OptionalInt.of(0), POSE),
                                new Fiducial(OptionalInt.empty(), Pose2d.ORIGIN))),
                new GripperState(
                        GripperState.Paddles.CLOSING,
                        Double.NaN,
                        GripperState.Lift.UP,
                        1,
                        true,
                        false,
                        true,
                        false,
                        true),
                new GripperState(
                        GripperState.Paddles.OPEN, 0, GripperState.Lift.DOWN, 0, false, true, false, true, false),
                new LightState(new Rgb(1, 2, 3), new LightState.Signal(Duration.ofMillis(300), 0.5), true),
                new Odometry(POSE, TWIST, true),
                new PoseEstimate(
                        POSE,
                        new Covariance2d(1, 0.5, 0, 2, 0, 0),
                        List.of(
                                new Hypothesis(0.5, POSE, new Covariance2d(1, 0.5, 0, 2, 0, 0)),
                                new Hypothesis(0.25, Pose2d.ORIGIN, new Covariance2d(3, 0, 0, 4, 0, 0.5))),
                        0.25,
                        PoseEstimate.Quality.AMBIGUOUS),
                PoseEstimate.of(POSE, new Covariance2d(1, 0.5, 0, 2, 0, 0)),
                new Planner.Asked(POSE, Pose2d.ORIGIN, 1, 1, OptionalDouble.of(2.5), OptionalDouble.of(2), ""),
                new Planner.Asked(POSE, Pose2d.ORIGIN, 7, 0, OptionalDouble.empty(), OptionalDouble.empty(), "Walls."),
                new Quantities(List.of(
                        new RecordedQuantity("wind.speed", "wind speed", "m/s", 3.5),
                        new RecordedQuantity("", "", "", 0),
                        new RecordedQuantity("pressure", "pressure", "", Double.NaN))),
                new NavigatorState(Optional.of(Pose2d.ORIGIN), 3.5, false),
                new NavigatorState(Optional.empty(), 0, true));
    }

    @ParameterizedTest
    @MethodSource("values")
    void whatIsWrittenIsRead(Record value) throws IOException {
        ReadingType<?> type = ReadingType.of(value).orElseThrow();
        var taken = Instant.ofEpochMilli(2500);
        assertThat(ReadingType.named(type.message().name())).contains(type);
        assertThat(type.read(written(type, value), taken)).isEqualTo(new Stamped<>(taken, "r1/there", value));
    }

    /// With arrays, which are equal when what is in them is; and a laser's limits, which its channel tells.
    @Test
    void whatIsWrittenOfRangesIsRead() throws IOException {
        for (Record value : ranges()) {
            ReadingType<?> any = ReadingType.of(value).orElseThrow();
            Map<String, String> about = value instanceof LaserScan scan ? ReadingType.limits(scan) : Map.of();
            ReadingType<?> type = ReadingType.of(any.message().name(), about).orElseThrow();
            assertThat(type.read(written(type, value), Instant.EPOCH).value())
                    .usingRecursiveComparison()
                    .withComparatorForType((a, b) -> Math.abs(a - b) < 1e-12 ? 0 : Double.compare(a, b), Double.class)
                    .isEqualTo(value);
        }
    }

    private static List<Record> ranges() {
        float[] ranges = {1.5F, Float.POSITIVE_INFINITY, 0, Float.NEGATIVE_INFINITY};
        return List.of(
                new LaserScan(POSE, -1, 0.1, 0.02, 5.6, ranges),
                new RangeArray(List.of(POSE, POSE, Pose2d.ORIGIN, POSE), 0.3, 0.1, 5, ranges),
                new OccupancyGrid(2, 3, 0.05, -1, 2, new byte[] {0, 100, OccupancyGrid.UNKNOWN, 0, 0, 50}));
    }

    @Test
    void allTypesAreTried() {
        Set<String> tried = Stream.concat(values().stream(), ranges().stream())
                .map(value -> ReadingType.of(value).orElseThrow().message().name())
                .collect(Collectors.toSet());
        assertThat(ReadingType.WRITTEN)
                .extracting(type -> type.message().name())
                .hasSameElementsAs(tried);
    }

    /// A file may be from anywhere.
    @Test
    void whatNoDeviceReportsIsRefused() {
        assertThat(ReadingType.ALL.stream()
                        .filter(type -> Stream.of("Actuator", "Battery", "Gripper", "Light")
                                .anyMatch(type.message().name()::contains)))
                .hasSize(4)
                .allSatisfy(type -> assertThatThrownBy(() -> type.read(empty(type), Instant.EPOCH))
                        .isInstanceOf(IllegalArgumentException.class));
    }

    private static MessageFields empty(ReadingType<?> type) throws IOException {
        return MessageFields.read(type.message(), new ByteSink(1).written());
    }

    private static MessageFields written(ReadingType<?> type, Record value) throws IOException {
        var out = new ProtoWriter(new ByteSink(16));
        out.string(2, "r1/there");
        type.write(out, value);
        return MessageFields.read(type.message(), out.sink().written());
    }
}
