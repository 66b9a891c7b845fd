package rsal.bench.robots;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.concurrent.Executor;
import java.util.concurrent.Executors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rsal.bench.place.Cave;
import rsal.bench.robots.WanderingRobots.Kind;
import rsal.data.OccupancyGrid;

class WanderingRobotsTest {
    private static final OccupancyGrid CAVE = Cave.draw(32, 0.05, 1);

    static Kind[] kinds() {
        return new Kind[] {Kind.LASER180, Kind.SONAR16, Kind.IR12};
    }

    @ParameterizedTest
    @MethodSource("kinds")
    void wandersTheSameWayOnOneCoreAndTwo(Kind kind) {
        try (var helper = Executors.newSingleThreadExecutor()) {
            double alone = whereabouts(kind, 1, Runnable::run);
            assertThat(whereabouts(kind, 1, helper)).isEqualTo(alone);
            assertThat(whereabouts(kind, 2, helper)).isNotEqualTo(alone);
        }
    }

    private static double whereabouts(Kind kind, long seed, Executor workers) {
        try (var swarm = new WanderingRobots(CAVE, kind, 20, seed, workers)) {
            double before = swarm.whereabouts();
            swarm.advance(10);
            assertThat(swarm.whereabouts()).isNotEqualTo(before);
            assertThat(swarm.rays()).isBetween(20 * 99L * 12, 20 * 101L * 180);
            return swarm.whereabouts();
        }
    }

    @Test
    void cavesHaveRoomAndWalls() {
        int free = 0;
        for (byte cell : CAVE.cells()) {
            free += cell == OccupancyGrid.FREE ? 1 : 0;
        }
        assertThat((double) free / CAVE.cells().length).isBetween(0.4, 0.8);
        assertThat(Cave.draw(32, 0.05, 1).cells()).isEqualTo(CAVE.cells());
    }
}
