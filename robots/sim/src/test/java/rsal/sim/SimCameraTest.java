package rsal.sim;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;
import static rsal.sim.SimRun.robot;
import static rsal.sim.SimThings.RED;
import static rsal.sim.SimThings.can;

import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Executor;
import java.util.concurrent.Executors;
import org.junit.jupiter.api.Test;
import rsal.data.Pose2d;
import rsal.device.camera.Camera;
import rsal.device.camera.CameraImage;
import rsal.device.camera.CameraKind;
import rsal.robot.RobotModel;
import rsal.robot.RobotModel.Part;
import rsal.robot.RobotSpec;
import rsal.settings.Arguments;

/// A camera 0.5 m above the floor, which looks at a wall 5.9 m ahead.
class SimCameraTest {
    private static final double HEIGHT = 0.5;

    private static RobotModel with(Map<String, ?> values) {
        var all = new HashMap<String, Object>(Map.of("depthNoise", 0, "fieldOfView", 90, "columns", 100, "rows", 80));
        all.putAll(values);
        var kind = new CameraKind();
        var part = new Part.Registered(
                "camera", kind, Pose2d.ORIGIN, Arguments.of(kind.parameters(), all), Duration.ofMillis(100));
        RobotModel box = Models.box(Models.DRIVE, part);
        return new RobotModel("box", "Box", box.body(), box.drive(), box.sensors(), Map.of("camera", HEIGHT));
    }

    private static SimRun run(Map<String, ?> values) {
        return SimRun.of(SimRun.room(8, 4), robot("r1", with(values), new Pose2d(2, 2, 0)));
    }

    private static CameraImage image(Map<String, ?> values) {
        return image(run(values));
    }

    private static CameraImage image(SimRun run) {
        run.advance(0.1);
        return run.robot("r1").require(Camera.class).latest().orElseThrow().value();
    }

    @Test
    void measuresDepthAlongItsAxis() {
        CameraImage image = image(Map.of());
        assertThat(image.focalLength()).isCloseTo(50, within(1e-9)); // of 90° and 100 columns
        for (int column = 35; column < 65; column++) { // of the wall ahead, 3.8 m wide: one depth
            assertThat(image.depth(column, 39)).isCloseTo(5.9, within(0.001));
            assertThat(image.color(column, 39)).isEqualTo(0x808080);
        }
        // the wall to the left, 1.9 m away: 1.9 m / tan 45° (nearly)
        assertThat(image.depth(0, 39)).isCloseTo(1.9 * 50 / 49.5, within(0.001));
    }

    @Test
    void seesTheFloorBelowTheHorizon() {
        CameraImage image = image(Map.of());
        for (int row = 60; row < 80; row++) {
            double down = (row + 0.5 - 40) / 50;
            assertThat(image.depth(50, row)).isCloseTo(HEIGHT / down, within(0.001));
            assertThat(image.color(50, row)).isEqualTo(0xb8b4aa);
        }
    }

    @Test
    void hasNoDepthBeyondItsRange() {
        CameraImage image = image(Map.of("range", 5));
        assertThat(image.depth(50, 39)).isEqualTo(Double.POSITIVE_INFINITY);
        assertThat(image.color(50, 39)).as("it sees the wall").isEqualTo(0x808080);
    }

    /// A can 0.3 m high, 2 m ahead: from 0.2 m to 0.5 m below the camera.
    @Test
    void seesThingsWhereTheyStand() {
        SimRun run = run(Map.of());
        run.simulation.add(can("can", 4, 2, 0.1, 0.3));
        CameraImage image = image(run);
        var rows = new ArrayList<Integer>();
        for (int row = 0; row < image.height(); row++) {
            if (image.color(50, row) == RED.packed()) {
                rows.add(row);
                assertThat(image.depth(50, row)).isBetween(1.89, 2.11);
            }
        }
        assertThat(rows).isNotEmpty().allMatch(row -> row > 39);
        assertThat(image.color(20, rows.getFirst())).isNotEqualTo(RED.packed());
    }

    @Test
    void itsDepthErrsByTheSquareOfTheDepth() {
        CameraImage right = image(Map.of());
        CameraImage wrong = image(Map.of("depthNoise", 0.002));
        double sum = 0;
        int count = 0;
        for (int row = 0; row < 80; row++) {
            for (int column = 0; column < 100; column++) {
                double depth = right.depth(column, row);
                if (Double.isFinite(depth) && depth > 1) {
                    double error = (wrong.depth(column, row) - depth) / (depth * depth);
                    sum += error * error;
                    count++;
                }
            }
        }
        assertThat(Math.sqrt(sum / count)).isCloseTo(0.002, within(0.0002));
    }

    @Test
    void isTheSameOnOneThreadAndOnSeveral() {
        try (var threads = Executors.newFixedThreadPool(3)) {
            var images = new ArrayList<CameraImage>();
            for (Executor workers : List.<Executor>of(Runnable::run, threads)) {
                var specs = new ArrayList<RobotSpec>();
                for (int i = 1; i <= 6; i++) {
                    specs.add(robot("r" + i, with(Map.of("depthNoise", 0.01)), new Pose2d(i, 2, 0.3 * i)));
                }
                images.add(image(SimRun.seeded(SimRun.room(8, 4), 5, workers, specs)));
            }
            assertThat(images.getFirst()).usingRecursiveComparison().isEqualTo(images.getLast());
        }
    }

    @Test
    void anImageHasAsManyBytesAsPixels() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new CameraImage(2, 2, 5, new byte[12], new byte[7]))
                .withMessageContaining("2 × 2 px");
    }
}
