package rsal.world;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import rsal.data.Footprint;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Prism;
import rsal.data.Shape;
import rsal.scene.Block;
import rsal.scene.Entity;
import rsal.scene.SolidRaster;
import rsal.scene.Surface;
import rsal.testkit.Rounds;
import rsal.world.Overlaps.Overlap;

class OverlapsTest {
    private static final double GRAIN = 0.01; // [m]

    private static Block block(Shape shape, double bottom, double top) {
        return new Block(new Prism(shape, bottom, top, Optional.empty()), Surface.PLAIN);
    }

    private static Entity box(String name, double x, double y, double side) {
        var shape = Shape.Polygon.of(Footprint.box(side, side, new Point2d(0, 0)));
        return new Entity(name, List.of(block(shape, 0, 1)), new Pose2d(x, y, 0), 0);
    }

    private static SolidRaster raster(int width, int height, BitSet solid) {
        return new SolidRaster(width, height, solid, -2, -2, 0.05, 0.05, 0, 0.5, false, Surface.PLAIN);
    }

    /// Counts the places of a fine grid that are in both.
    @Test
    void whatOverlapsIsFound() {
        int found = 0;
        int apart = 0;
        int barely = 0; // between the places of the grid
        int seeds = Rounds.of(25, 100);
        for (long seed = 0; seed < seeds; seed++) {
            var random = new SplittableRandom(seed);
            var solid = new BitSet();
            for (int i = 0; i < 6400; i++) {
                solid.set(i, random.nextDouble() < 0.002);
            }
            List<SolidRaster> walls = List.of(raster(80, 80, solid));
            List<Entity> things =
                    IntStream.range(0, 3).mapToObj(i -> some("t" + i, random)).toList();
            List<Entity> robots =
                    IntStream.range(0, 4).mapToObj(i -> some("r" + i, random)).toList();
            List<Overlap> overlaps = Overlaps.of(walls, things, robots);
            var before = new ArrayList<>(things);
            for (Entity robot : robots) {
                Optional<Overlap> reported =
                        overlaps.stream().filter(o -> o.robot().equals(robot)).findFirst();
                double inWalls = common(robot, walls.getFirst());
                double most = inWalls;
                for (Entity other : before) {
                    most = Math.max(most, common(robot, other));
                }
                assertThat(reported.isPresent() || most < 1e-3)
                        .as("seed %d, %s", seed, robot.name())
                        .isTrue();
                if (reported.isPresent()) {
                    double common = reported.get()
                            .other()
                            .map(other -> common(robot, other))
                            .orElse(inWalls);
                    barely += common == 0 ? 1 : 0;
                }
                apart += most == 0 ? 1 : 0;
                found += reported.isPresent() ? 1 : 0;
                before.add(robot);
            }
        }
        assertThat(found).isGreaterThan(seeds / 2);
        assertThat(apart).isGreaterThan(seeds / 2);
        assertThat(barely).isLessThan(found / 20);
    }

    private static Entity some(String name, SplittableRandom random) {
        var center = new Point2d(random.nextDouble(-0.2, 0.2), random.nextDouble(-0.2, 0.2));
        double bottom = random.nextDouble(-0.5, 0.5);
        Shape disc = new Shape.Disc(center, random.nextDouble(0.1, 0.4));
        Shape angle = new Shape.Polygon(List.of(
                new Point2d(-0.3, -0.3), new Point2d(0.3, -0.3), new Point2d(-0.2, -0.2), new Point2d(-0.3, 0.3)));
        List<Block> blocks = random.nextBoolean()
                ? List.of(block(disc, bottom, bottom + 0.5))
                : List.of(block(disc, bottom, bottom + 0.2), block(angle, 0, 0.3));
        var pose = new Pose2d(random.nextDouble(-2, 2), random.nextDouble(-2, 2), random.nextDouble(-3, 3));
        return new Entity(name, blocks, pose, random.nextDouble(0, 0.5));
    }

    /// [m²], roughly.
    private static double common(Entity robot, Entity other) {
        int count = 0;
        Pose2d around = robot.mapFromEntity();
        for (double x = around.x() - 0.8; x < around.x() + 0.8; x += GRAIN) {
            for (double y = around.y() - 0.8; y < around.y() + 0.8; y += GRAIN) {
                count += isIn(robot, other, x, y) ? 1 : 0;
            }
        }
        return count * GRAIN * GRAIN;
    }

    private static boolean isIn(Entity robot, Entity other, double x, double y) {
        return robot.blocks().stream()
                .anyMatch(block -> holds(robot, block, x, y)
                        && other.blocks().stream()
                                .anyMatch(second -> holds(other, second, x, y)
                                        && robot.height() + block.prism().bottom()
                                                < other.height()
                                                        + second.prism().top()
                                        && other.height() + second.prism().bottom()
                                                < robot.height() + block.prism().top()));
    }

    private static double common(Entity robot, SolidRaster walls) {
        int count = 0;
        Pose2d around = robot.mapFromEntity();
        for (double x = Math.max(-2, around.x() - 0.8); x < Math.min(2, around.x() + 0.8); x += GRAIN) {
            for (double y = Math.max(-2, around.y() - 0.8); y < Math.min(2, around.y() + 0.8); y += GRAIN) {
                int row = (int) Math.floor((y + 2) / walls.cellY());
                int cell = row * walls.width() + (int) Math.floor((x + 2) / walls.cellX());
                double px = x;
                double py = y;
                count += walls.solid().get(cell)
                                && robot.blocks().stream()
                                        .anyMatch(block -> holds(robot, block, px, py)
                                                && robot.height()
                                                                + block.prism().bottom()
                                                        < walls.highest()
                                                && walls.lowest()
                                                        < robot.height()
                                                                + block.prism().top())
                        ? 1
                        : 0;
            }
        }
        return count * GRAIN * GRAIN;
    }

    private static boolean holds(Entity entity, Block block, double x, double y) {
        Point2d place = entity.mapFromEntity().inverse().transform(new Point2d(x, y));
        return switch (block.prism().shape()) {
            case Shape.Disc disc -> disc.center().distanceTo(place) < disc.radius();
            case Shape.Polygon polygon -> {
                boolean in = false;
                List<Point2d> corners = polygon.corners();
                for (int i = 0; i < corners.size(); i++) {
                    Point2d a = corners.get(i);
                    Point2d b = corners.get((i + 1) % corners.size());
                    in ^= a.y() > place.y() != b.y() > place.y()
                            && place.x() < a.x() + (place.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
                }
                yield in;
            }
        };
    }

    @Test
    void whatTouchesIsNotInside() {
        List<Entity> robots = List.of(box("a", 0.1, 0, 0.2), box("b", 0.3, 0, 0.2), box("c", 0.1 + 0.2 / 3, 0.2, 0.2));
        assertThat(Overlaps.of(List.of(), List.of(box("t", -0.1, 0, 0.2)), robots))
                .isEmpty();
        var solid = new BitSet();
        solid.set(39); // from (-0.05, -2) to (0, -1.95)
        assertThat(Overlaps.of(List.of(raster(80, 80, solid)), List.of(), List.of(box("a", 0.1, -1.95, 0.2))))
                .isEmpty();
    }

    @Test
    void eachRobotIsReportedOnceAndTheFirstOfTwoIsNot() {
        List<Entity> robots = List.of(box("a", 0, 0, 0.2), box("b", 0.1, 0, 0.2), box("c", 0.05, 0, 0.2));
        assertThat(Overlaps.of(List.of(), List.of(box("t", 0.2, 0, 0.2)), robots))
                .extracting(overlap -> overlap.robot().name())
                .containsExactly("b", "c");
    }
}
