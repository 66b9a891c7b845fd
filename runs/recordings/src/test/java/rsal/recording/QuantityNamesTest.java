package rsal.recording;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import rsal.behavior.Decision;
import rsal.data.ActuatorState;
import rsal.data.BatteryState;
import rsal.data.Blobs;
import rsal.data.BumperState;
import rsal.data.Covariance2d;
import rsal.data.Fiducials;
import rsal.data.Interval;
import rsal.data.LaserScan;
import rsal.data.OccupancyGrid;
import rsal.data.Odometry;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.PoseEstimate;
import rsal.data.RangeArray;
import rsal.data.Twist2d;
import rsal.device.Planner;
import rsal.engine.report.NavigatorState;

class QuantityNamesTest {
    /// Whatever is renamed there would be called as in Java, without a unit.
    @Test
    void whatHasWordsIsThere() {
        Set<String> parts = Stream.of(
                        ActuatorState.class,
                        BatteryState.class,
                        Blobs.class,
                        Covariance2d.class,
                        Decision.class,
                        Fiducials.class,
                        Interval.class,
                        LaserScan.class,
                        NavigatorState.class,
                        Odometry.class,
                        Planner.Asked.class,
                        Point2d.class,
                        Pose2d.class,
                        PoseEstimate.class,
                        RangeArray.class,
                        Twist2d.class)
                .flatMap(type -> Arrays.stream(type.getRecordComponents())
                        .map(part -> type.getSimpleName() + "." + part.getName()))
                .collect(Collectors.toSet());
        assertThat(parts).containsAll(QuantityNames.known());
    }

    /// Or they would be offered again when somebody calls them otherwise.
    @Test
    void whatStaysTheSameIsThere() {
        List<Class<? extends Record>> records = List.of(
                OccupancyGrid.class,
                LaserScan.class,
                RangeArray.class,
                BumperState.class,
                BatteryState.class,
                ActuatorState.class,
                Blobs.class,
                Fiducials.class);
        assertThat(records.stream()
                        .flatMap(record -> Arrays.stream(record.getRecordComponents()))
                        .filter(QuantityNames::isSetting)
                        .map(part -> part.getDeclaringRecord().getSimpleName() + "." + part.getName()))
                .containsExactlyInAnyOrderElementsOf(QuantityNames.SETTINGS);
    }
}
