package rsal.sim.world;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.geom.Area;
import java.awt.geom.Path2D;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.Footprint;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.testkit.DrawnMap;

class WorldTest {
    private static final Footprint BOX = RandomWorld.box(0.3, 0.2, -0.04, 0);

    /// @param speed way of one step [m]
    @ParameterizedTest
    @ValueSource(doubles = {0.01, 0.05, 0.4, 3})
    void aRobotGoesAsFarAsItCanAndTouchesNothingOnTheWay(double speed) {
        int blocked = 0;
        int free = 0;
        for (long seed = 0; seed < 800; seed++) {
            var random = new RandomWorld(seed, 0.05, 0.01);
            var world = new World(new Walls(random.map));
            Pose2d start = random.anywhere();
            if (!world.hasRoom(BOX, start, 0)) {
                continue;
            }
            Body body = world.add("r1", BOX, start);
            var arc = new Arc(start, random.random.nextDouble(-speed, speed), random.random.nextDouble(-4, 4) * speed);
            double made = world.advance(body, arc);
            assertThat(body.pose()).as("seed %d", seed).isEqualTo(arc.at(made));
            for (int i = 0; i <= 300; i++) {
                assertThat(random.hits(RandomWorld.shape(BOX, arc.at(made * i / 300))))
                        .as("seed %d, %s, part %s of %s", seed, arc, i / 300.0, made)
                        .isFalse();
            }
            if (made < 1) {
                blocked++;
                double next = made + 0.002 / arc.longestWay(body.outline.radius());
                assertThat(random.hits(RandomWorld.shape(RandomWorld.box(0.3, 0.2, -0.04, 0.002), arc.at(next))))
                        .as("seed %d, %s: there is room after %s", seed, arc, made)
                        .isTrue();
            } else {
                free++;
            }
        }
        assertThat(free).isGreaterThan(10);
        assertThat(blocked).isGreaterThan(speed < 0.4 ? 0 : 10);
    }

    @Test
    void aRobotThatTouchesCanGoBackTheWayItCame() {
        int blocked = 0;
        for (long seed = 0; seed < 600; seed++) {
            var random = new RandomWorld(seed, 0.05, 0.01);
            var world = new World(new Walls(random.map));
            Pose2d start = random.anywhere();
            if (!world.hasRoom(BOX, start, 0)) {
                continue;
            }
            Body body = world.add("r1", BOX, start);
            double length = random.random.nextDouble(-1, 1);
            double turn = random.random.nextDouble(-4, 4);
            double made = world.advance(body, new Arc(start, length, turn));
            if (made < 1 && made > 0.1) {
                blocked++;
                double back = world.advance(body, new Arc(body.pose(), -length * made / 2, -turn * made / 2));
                assertThat(back).as("seed %d", seed).isEqualTo(1);
            }
        }
        assertThat(blocked).isGreaterThan(50);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.05, 1})
    void robotsNeverOverlap(double speed) {
        var random = new RandomWorld(3, 0.1, 0);
        var world = new World(new Walls(random.map));
        var bodies = new ArrayList<Body>();
        while (bodies.size() < 12) {
            Pose2d pose = random.anywhere();
            if (world.hasRoom(BOX, pose, 0)) {
                bodies.add(world.add("r" + bodies.size(), BOX, pose));
            }
        }
        int touches = 0;
        for (int step = 0; step < 300; step++) {
            for (Body body : bodies) {
                var arc = new Arc(
                        body.pose(), random.random.nextDouble(-speed, speed), random.random.nextDouble(-2, 2) * speed);
                touches += world.advance(body, arc) < 1 && world.obstacle().isPresent() ? 1 : 0;
            }
            assertApart(bodies, "step " + step);
        }
        assertThat(touches).isGreaterThan(10);
    }

    private static void assertApart(List<Body> bodies, String when) {
        for (int i = 0; i < bodies.size(); i++) {
            for (int j = 0; j < i; j++) {
                Path2D one = RandomWorld.shape(BOX, bodies.get(i).pose());
                if (one.intersects(RandomWorld.shape(BOX, bodies.get(j).pose()).getBounds2D())) {
                    var common = new Area(one);
                    common.intersect(
                            new Area(RandomWorld.shape(BOX, bodies.get(j).pose())));
                    assertThat(common.isEmpty()).as("%s: %d and %d", when, i, j).isTrue();
                }
            }
        }
    }

    @Test
    void nobodyLeavesTheMap() {
        var world = new World(
                new Walls(DrawnMap.grid(0.5, ".....\n.....\n.....\n.....").grid()));
        Body body = world.add("r1", BOX, new Pose2d(1, 1, 0));
        assertThat(world.advance(body, new Arc(body.pose(), 100, 0))).isLessThan(0.02);
        assertThat(body.pose().x()).isBetween(2.5 - 0.11 - 0.005, 2.5 - 0.11);
    }

    @Test
    void doesNotSlipThroughWallsWhoseCellsTouchAtCorners() {
        int size = 20;
        var cells = new byte[size * size];
        for (int i = 0; i < size; i++) {
            cells[i * size + i] = OccupancyGrid.OCCUPIED;
        }
        var world = new World(new Walls(new OccupancyGrid(size, size, 0.05, 0, 0, cells)));
        var small = Footprint.box(0.01, 0.01, new Point2d(0, 0));
        Body body = world.add("r1", small, new Pose2d(0.8, 0.2, 0));
        for (int i = 0; i < 500; i++) {
            world.advance(body, new Arc(body.pose(), 0.7, 0));
            assertThat(body.pose().x())
                    .as("after %d ways", i)
                    .isGreaterThan(body.pose().y());
            world.advance(body, new Arc(body.pose(), 0, 2.4));
        }
    }
}
