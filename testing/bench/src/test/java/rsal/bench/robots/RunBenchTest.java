package rsal.bench.robots;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import org.assertj.core.data.Percentage;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rsal.bench.place.Cave;
import rsal.bench.robots.WanderingRobots.Kind;
import rsal.data.OccupancyGrid;
import rsal.robot.RobotModel;
import rsal.robot.RobotModel.Part;
import rsal.scenario.RunOptions;
import rsal.scenario.Scenario;

class RunBenchTest {
    static Kind[] kinds() {
        return new Kind[] {Kind.LASER180, Kind.SONAR16, Kind.IR12};
    }

    /// Otherwise their costs could not be compared.
    @ParameterizedTest
    @MethodSource("kinds")
    void itsWorldsHaveTheRobotsOfTheSimulatorsBenchmark(Kind kind, @TempDir Path folder) throws IOException {
        Path file = folder.resolve("robots.world.yaml");
        Files.writeString(file, RunBench.world(kind, 3));
        var plan = Scenario.load(file.toString()).plan(RunOptions.NONE);
        assertThat(plan.robots()).hasSize(3).allSatisfy(robot -> {
            RobotModel model = robot.spec().model();
            assertThat(model.footprint()).isEqualTo(kind.model().footprint());
            assertThat(model.drive().forward().speed())
                    .isEqualTo(kind.model().drive().forward().speed());
            assertThat(model.sensors().values().iterator().next()).satisfies(part -> assertSame(kind, part));
        });
    }

    @Test
    void itsWorldsHaveTheWallsOfTheSimulatorsBenchmark() {
        OccupancyGrid map = Scenario.load("swarm").plan(RunOptions.NONE).map(); // also the map 'cave'
        byte[] cells = Cave.draw(128, map.resolution(), 1).cells();
        assertThat(Arrays.equals(map.cells(), cells)).isTrue(); // a message of all cells would be too long
    }

    private static void assertSame(Kind kind, Part part) {
        Part wanted = kind.model().sensors().values().iterator().next();
        assertThat(part.getClass()).isEqualTo(wanted.getClass());
        if (part instanceof Part.Laser laser && wanted instanceof Part.Laser other) {
            assertThat(laser.samples()).isEqualTo(other.samples());
            assertThat(laser.rangeMax()).isEqualTo(other.rangeMax());
            assertThat(laser.period()).isEqualTo(other.period());
            assertThat(laser.angleIncrement()).isCloseTo(other.angleIncrement(), Percentage.withPercentage(1e-9));
        } else if (part instanceof Part.Sonars ring && wanted instanceof Part.Sonars other) {
            assertThat(ring.baseFromSensors()).hasSameSizeAs(other.baseFromSensors());
            assertThat(ring.rangeMax()).isEqualTo(other.rangeMax());
            assertThat(ring.period()).isEqualTo(other.period());
            assertThat(ring.fieldOfView()).isCloseTo(other.fieldOfView(), Percentage.withPercentage(1e-9));
        }
    }
}
