package rsal.world.yaml;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Prism;
import rsal.data.Shape;
import rsal.scene.Block;
import rsal.scene.Entity;
import rsal.scene.Surface;

class RoomTest {
    private static final OccupancyGrid MAP = new OccupancyGrid(400, 400, 1, -200, -200, new byte[160_000]);

    private static Entity disc(double x, double y, double radius) {
        var shape = new Shape.Disc(new Point2d(0, 0), radius);
        return new Entity(
                "disc",
                List.of(new Block(new Prism(shape, 0, 1, Optional.empty()), Surface.PLAIN)),
                new Pose2d(x, y, 0),
                0);
    }

    /// With many and few buckets, small and large circles, it says the same as going through all of them.
    @Test
    void circlesOfAnySizeAreInTheWay() {
        var random = new SplittableRandom(1);
        for (int many : List.of(3, 40, 400)) {
            var room = new Room(MAP);
            List<Entity> others = IntStream.range(0, many)
                    .mapToObj(i -> disc(
                            random.nextDouble(-200, 200),
                            random.nextDouble(-200, 200),
                            i % 10 == 0 ? random.nextDouble(40, 70) / Math.sqrt(many) * 2 : random.nextDouble(0.1, 3)))
                    .toList();
            for (int i = 0; i < many; i++) {
                room.add(others.get(i), i % 2 == 0);
            }
            int free = 0;
            for (int k = 0; k < 2000; k++) {
                double x = random.nextDouble(-150, 150);
                double y = random.nextDouble(-150, 150);
                double radius = random.nextDouble(0.1, 5);
                boolean expected = IntStream.range(0, many).allMatch(i -> {
                    Pose2d other = others.get(i).mapFromEntity();
                    double gap = i % 2 == 0 ? 2 : 0.5;
                    return Math.hypot(other.x() - x, other.y() - y) >= radius + Room.radius(others.get(i)) + gap;
                });
                assertThat(room.isFree(x, y, radius, 0.5, 2)).isEqualTo(expected);
                free += expected ? 1 : 0;
            }
            assertThat(free).isBetween(20, 1990);
        }
    }

    @Test
    void afterTooManyLooksNothingIsFree() {
        var room = new Room(MAP, 100);
        for (int i = 0; i < 10; i++) {
            room.add(disc(1000, 1000, 100), false);
        }
        for (int i = 0; i < 11; i++) {
            assertThat(room.isExhausted()).isFalse();
            assertThat(room.isFree(0, 0, 1, 0, 0)).isTrue();
        }
        assertThat(room.isExhausted()).isTrue();
        assertThat(room.isFree(0, 0, 1, 0, 0)).isFalse();
    }
}
