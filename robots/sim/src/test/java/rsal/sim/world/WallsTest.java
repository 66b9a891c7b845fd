package rsal.sim.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.Pose2d;
import rsal.testkit.DrawnMap;
import rsal.testkit.Rays;

class WallsTest {
    @ParameterizedTest
    @ValueSource(doubles = {0.001, 0.01, 0.1, 0.4})
    void raysEndWhereTheSlowOnesDo(double density) {
        for (long seed = 0; seed < 60; seed++) {
            var world = new RandomWorld(seed, 0.05, density);
            var walls = new Walls(world.map);
            var slow = new Rays(world.map);
            for (int i = 0; i < 50; i++) {
                Pose2d pose = world.anywhere();
                if (i % 5 == 0) { // along the axes
                    pose = new Pose2d(pose.x(), pose.y(), Math.rint(pose.theta() / (Math.PI / 2)) * Math.PI / 2);
                }
                double dx = Math.abs(Math.cos(pose.theta())) < 1e-9 ? 0 : Math.cos(pose.theta());
                double dy = Math.abs(Math.sin(pose.theta())) < 1e-9 ? 0 : Math.sin(pose.theta());
                assertThat(RandomWorld.ray(walls, pose.x(), pose.y(), dx, dy, 100))
                        .as("seed %d, ray %d from %s", seed, i, pose)
                        .isCloseTo(slow.range(pose), within(1e-9));
            }
        }
    }

    @Test
    void raysEndAtTheirReach() {
        var walls = new Walls(DrawnMap.grid(0.5, "......#").grid());
        assertThat(RandomWorld.ray(walls, 0.5, 0.25, 1, 0, 2.6)).isEqualTo(2.5);
        assertThat(RandomWorld.ray(walls, 0.5, 0.25, 1, 0, 2.4)).isEqualTo(Double.POSITIVE_INFINITY);
    }

    @Test
    void raysFromOutsideTheMapMeetNothing() {
        var walls = new Walls(DrawnMap.grid(0.5, "######").grid());
        assertThat(RandomWorld.ray(walls, -5, 0.25, 1, 0, 100)).isEqualTo(Double.POSITIVE_INFINITY);
        assertThat(RandomWorld.ray(walls, Double.NaN, 0.25, 1, 0, 100)).isEqualTo(Double.POSITIVE_INFINITY);
    }

    @Test
    void unknownCellsAreNoWalls() {
        var walls = new Walls(DrawnMap.grid(0.5, ".???#").grid());
        assertThat(RandomWorld.ray(walls, 0.25, 0.25, 1, 0, 100)).isEqualTo(1.75);
    }

    @Test
    void whatIsSaidToBeEmptyIs() {
        for (long seed = 0; seed < 50; seed++) {
            var world = new RandomWorld(seed, 0.1, 0.01);
            var walls = new Walls(world.map);
            var slow = new Rays(world.map);
            Pose2d place = world.anywhere();
            assertThat(walls.emptyAround(place.x(), place.y()))
                    .as("seed %d", seed)
                    .isLessThanOrEqualTo(slow.clearance(place.x(), place.y()));
        }
    }
}
