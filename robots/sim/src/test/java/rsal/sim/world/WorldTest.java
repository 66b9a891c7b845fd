package rsal.sim.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.geom.Area;
import java.awt.geom.Path2D;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.Fan;
import rsal.data.Footprint;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.scene.Surface;
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
            var world = new World(RasterWalls.of(random.map));
            Pose2d start = random.anywhere();
            if (!world.hasRoom(CollisionShape.of(BOX), start, 0)) {
                continue;
            }
            Body body = world.add("r1", CollisionShape.of(BOX), start, 0);
            var arc =
                    Arc.ahead(start, random.random.nextDouble(-speed, speed), random.random.nextDouble(-4, 4) * speed);
            double made = world.advance(body, arc);
            assertThat(body.pose()).as("seed %d", seed).isEqualTo(arc.at(made));
            for (int i = 0; i <= 300; i++) {
                assertThat(random.hits(RandomWorld.shape(BOX, arc.at(made * i / 300))))
                        .as("seed %d, %s, part %s of %s", seed, arc, i / 300.0, made)
                        .isFalse();
            }
            if (made < 1) {
                blocked++;
                double next = made + 0.002 / arc.longestDistance(body.figure.radius());
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

    /// @param speed way of one step [m]
    @ParameterizedTest
    @ValueSource(doubles = {0.01, 0.1, 3})
    void aRobotThatSlidesGoesOnAlongWhatItTouchesAndThroughNothing(double speed) {
        int slid = 0;
        for (long seed = 0; seed < 400; seed++) {
            var random = new RandomWorld(seed, 0.05, 0.01);
            var world = new World(RasterWalls.of(random.map));
            Pose2d start = random.anywhere();
            if (!world.hasRoom(CollisionShape.of(BOX), start, 0)) {
                continue;
            }
            Body body = world.add("r1", CollisionShape.of(BOX), start, 0);
            for (int step = 0; step < 40; step++) {
                Pose2d from = body.pose();
                var arc = Arc.ahead(from, speed, random.random.nextDouble(-0.2, 0.2));
                double made = world.advance(body, arc);
                if (made < 1 && world.slide(body, arc, made)) {
                    slid++;
                }
                assertThat(random.hits(RandomWorld.shape(BOX, body.pose())))
                        .as("seed %d, step %d, from %s to %s", seed, step, from, body.pose())
                        .isFalse();
                assertThat(body.pose().distanceTo(from)).isLessThanOrEqualTo(speed * 1.01);
            }
        }
        assertThat(slid).isGreaterThan(500);
    }

    @Test
    void aRobotSlidesAlongAWallAsFarAsItsWayLeadsPastIt() {
        var world = new World(RasterWalls.of(
                DrawnMap.grid(1, "#######\n.......\n.......\n#######").grid()));
        double angle = Math.toRadians(30);
        var start = new Pose2d(1, 2, angle);
        Body body = world.add("r1", CollisionShape.of(Footprint.box(0.4, 0.4, new Point2d(0, 0))), start, 0);
        var arc = Arc.ahead(start, 4, 0);
        double made = world.advance(body, arc);
        assertThat(made).isBetween(0.1, 0.9);
        assertThat(world.slide(body, arc, made)).isTrue();
        assertThat(body.pose().x()).isCloseTo(1 + 4 * Math.cos(angle), within(0.001));
        assertThat(body.pose().y()).isCloseTo(3 - 0.2 * (Math.cos(angle) + Math.sin(angle)), within(0.005));
        assertThat(body.pose().theta()).isEqualTo(angle);
        assertThat(world.obstacle()).as("a wall").isEmpty();
    }

    @Test
    void aRobotThatDrivesStraightIntoAWallDoesNotSlide() {
        var world = new World(RasterWalls.of(DrawnMap.grid(1, "....#").grid()));
        for (double angle : new double[] {0, 0.05, -0.05}) {
            var start = new Pose2d(2, 0.5, angle);
            Body body = world.add("r", CollisionShape.of(Footprint.box(0.4, 0.3, new Point2d(0, 0))), start, 0);
            var arc = Arc.ahead(start, 4, 0);
            double made = world.advance(body, arc);
            Pose2d there = body.pose();
            assertThat(world.slide(body, arc, made)).as("%s rad", angle).isFalse();
            assertThat(body.pose()).isEqualTo(there);
            world.remove(body);
        }
    }

    @Test
    void aRobotThatDrivesIntoAWallCanStillTurn() {
        var world = new World(RasterWalls.of(DrawnMap.grid(1, "....#").grid()));
        var start = new Pose2d(2, 0.5, 0);
        Body body = world.add(
                "r", List.of(new CollisionShape.Cylinder(new Point2d(0, 0), 0.2, 0, 1, Surface.PLAIN)), start, 0);
        var arc = Arc.ahead(start, 4, 0.5);
        double made = world.advance(body, arc);
        assertThat(world.slide(body, arc, made)).isTrue();
        assertThat(body.pose().theta()).isCloseTo(0.5, within(1e-9));
    }

    @Test
    void aRobotThatTouchesCanGoBackTheWayItCame() {
        int blocked = 0;
        for (long seed = 0; seed < 600; seed++) {
            var random = new RandomWorld(seed, 0.05, 0.01);
            var world = new World(RasterWalls.of(random.map));
            Pose2d start = random.anywhere();
            if (!world.hasRoom(CollisionShape.of(BOX), start, 0)) {
                continue;
            }
            Body body = world.add("r1", CollisionShape.of(BOX), start, 0);
            double length = random.random.nextDouble(-1, 1);
            double turn = random.random.nextDouble(-4, 4);
            double made = world.advance(body, Arc.ahead(start, length, turn));
            if (made < 1 && made > 0.1) {
                blocked++;
                double back = world.advance(body, Arc.ahead(body.pose(), -length * made / 2, -turn * made / 2));
                assertThat(back).as("seed %d", seed).isEqualTo(1);
            }
        }
        assertThat(blocked).isGreaterThan(50);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.05, 1})
    void robotsNeverOverlap(double speed) {
        var random = new RandomWorld(3, 0.1, 0);
        var world = new World(RasterWalls.of(random.map));
        var bodies = new ArrayList<Body>();
        while (bodies.size() < 12) {
            Pose2d pose = random.anywhere();
            if (world.hasRoom(CollisionShape.of(BOX), pose, 0)) {
                bodies.add(world.add("r" + bodies.size(), CollisionShape.of(BOX), pose, 0));
            }
        }
        int touches = 0;
        for (int step = 0; step < 300; step++) {
            for (Body body : bodies) {
                var arc = Arc.ahead(
                        body.pose(), random.random.nextDouble(-speed, speed), random.random.nextDouble(-2, 2) * speed);
                touches += world.advance(body, arc) < 1 && world.obstacle().isPresent() ? 1 : 0;
            }
            assertApart(bodies, "step " + step);
        }
        assertThat(touches).isGreaterThan(10);
    }

    /// Robots that all push on for a while, so that many are stuck, some of them only until another is out of their
    /// way.
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4})
    void whoCanMakeNothingOfHisWayHasSomethingRightBeforeHim(long seed) {
        var random = new RandomWorld(seed, 0.1, 0.02);
        var world = new World(RasterWalls.of(random.map));
        var bodies = new ArrayList<Body>();
        for (int i = 0; i < 400; i++) {
            Pose2d pose = random.anywhere();
            if (world.hasRoom(CollisionShape.of(BOX), pose, 0)) {
                bodies.add(world.add("r" + bodies.size(), CollisionShape.of(BOX), pose, 0));
            }
        }
        int stuck = 0;
        int freed = 0;
        var wavefront = new Pose2d[bodies.size()];
        var before = new boolean[bodies.size()];
        for (int step = 0; step < 120; step++) {
            for (int i = 0; i < bodies.size(); i++) {
                Body body = bodies.get(i);
                if (step % 30 == 0 || wavefront[i] == null) {
                    wavefront[i] =
                            new Pose2d(random.random.nextDouble(-0.05, 0.05), 0, random.random.nextDouble(-0.1, 0.1));
                    before[i] = false;
                }
                Pose2d from = body.pose();
                var arc = Arc.ahead(from, wavefront[i].x(), wavefront[i].theta());
                boolean moved = world.advance(body, arc) > 0;
                if (!moved) {
                    assertThat(body.pose()).isEqualTo(from);
                    Pose2d next = arc.at(0.001 / arc.longestDistance(body.radius()));
                    assertThat(world.place(body, next))
                            .as("seed %d, step %d: %s", seed, step, body.name())
                            .isFalse();
                }
                stuck += moved ? 0 : 1;
                freed += moved && before[i] ? 1 : 0;
                before[i] = !moved;
            }
        }
        assertThat(stuck).isGreaterThan(1000);
        assertThat(freed).isGreaterThan(10);
    }

    @ParameterizedTest
    @ValueSource(strings = {"drives away", "is put elsewhere", "is hidden", "is taken out", "is picked up"})
    void whoIsStuckGoesOnAsSoonAsNothingIsInHisWay(String what) {
        var world = new World(RasterWalls.of(
                DrawnMap.grid(0.5, "..........\n..........\n..........").grid()));
        Body body = world.add("r1", CollisionShape.of(BOX), new Pose2d(1, 0.75, 0), 0);
        Body other = world.add("r2", CollisionShape.of(BOX), new Pose2d(2, 0.75, 0), 0);
        while (world.advance(body, Arc.ahead(body.pose(), 0.1, 0)) > 0) {
            assertThat(body.pose().x()).isLessThan(2);
        }
        assertThat(world.advance(body, Arc.ahead(body.pose(), 0.1, 0))).isZero();
        assertThat(world.obstacle()).contains(other);
        switch (what) {
            case "drives away" -> world.advance(other, Arc.ahead(other.pose(), 1, 0));
            case "is put elsewhere" -> world.put(other, new Pose2d(4, 0.75, 0));
            case "is hidden" -> world.hide(other);
            case "is taken out" -> world.remove(other);
            default -> world.pickUp(other, body);
        }
        assertThat(world.advance(body, Arc.ahead(body.pose(), 0.1, 0))).isEqualTo(1);
    }

    @Test
    void whoMadeHisWayOutOfAnotherGoesAsNearAsHeCanOnceThatIsGone() {
        var world = new World(RasterWalls.of(
                DrawnMap.grid(0.5, "..........\n..........\n..........").grid()));
        Body body = world.add("r1", CollisionShape.of(BOX), new Pose2d(1, 0.75, 0), 0);
        Body ahead = world.add("r2", CollisionShape.of(BOX), new Pose2d(2, 0.75, 0), 0);
        Body into = world.add("r3", CollisionShape.of(BOX), new Pose2d(4, 0.75, 0), 0);
        while (world.advance(body, Arc.ahead(body.pose(), 0.1, 0)) > 0) {
            assertThat(body.pose().x()).isLessThan(2);
        }
        world.put(ahead, new Pose2d(2.003, 0.75, 0));
        world.put(into, body.pose());
        var arc = Arc.ahead(body.pose(), 0.1, 0);
        assertThat(world.advance(body, arc))
                .as("out of another it goes by strides")
                .isZero();
        assertThat(world.obstacle()).contains(ahead);
        world.remove(into);
        assertThat(world.advance(body, arc)).isBetween(0.02, 0.04);
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
                RasterWalls.of(DrawnMap.grid(0.5, ".....\n.....\n.....\n.....").grid()));
        Body body = world.add("r1", CollisionShape.of(BOX), new Pose2d(1, 1, 0), 0);
        assertThat(world.advance(body, Arc.ahead(body.pose(), 100, 0))).isLessThan(0.02);
        assertThat(body.pose().x()).isBetween(2.5 - 0.11 - 0.005, 2.5 - 0.11);
    }

    @Test
    void doesNotSlipThroughWallsWhoseCellsTouchAtCorners() {
        int size = 20;
        var cells = new byte[size * size];
        for (int i = 0; i < size; i++) {
            cells[i * size + i] = OccupancyGrid.OCCUPIED;
        }
        var world = new World(RasterWalls.of(new OccupancyGrid(size, size, 0.05, 0, 0, cells)));
        var small = Footprint.box(0.01, 0.01, new Point2d(0, 0));
        Body body = world.add("r1", CollisionShape.of(small), new Pose2d(0.8, 0.2, 0), 0);
        for (int i = 0; i < 500; i++) {
            world.advance(body, Arc.ahead(body.pose(), 0.7, 0));
            assertThat(body.pose().x())
                    .as("after %d ways", i)
                    .isGreaterThan(body.pose().y());
            world.advance(body, Arc.ahead(body.pose(), 0, 2.4));
        }
    }

    @Test
    void bodiesOfManyPiecesGoSidewaysAndNeverOverlap() {
        var random = new RandomWorld(5, 0.1, 0.01);
        var world = new World(RasterWalls.of(random.map));
        var bodies = new ArrayList<Body>();
        for (int i = 0; i < 400; i++) {
            List<CollisionShape> chunks = random.chunks();
            Pose2d pose = random.anywhere();
            if (world.hasRoom(chunks, pose, 0)) {
                bodies.add(world.add("r" + bodies.size(), chunks, pose, 0));
            }
        }
        int touches = 0;
        for (int step = 0; step < 100; step++) {
            for (Body body : bodies) {
                var arc = new Arc(
                        body.pose(),
                        random.random.nextDouble(-0.3, 0.3),
                        random.random.nextDouble(-0.3, 0.3),
                        random.random.nextDouble(-1, 1));
                touches += world.advance(body, arc) < 1 ? 1 : 0;
            }
            for (Body one : bodies) {
                for (Body other : bodies) {
                    assertThat(one == other || apart(one, other))
                            .as("step %d: %s and %s", step, one.name(), other.name())
                            .isTrue();
                }
            }
        }
        assertThat(bodies.size()).isGreaterThan(10);
        assertThat(touches).isGreaterThan(100);
    }

    private static boolean apart(Body one, Body other) {
        for (PlacedShape piece : one.figure.pieces) {
            for (PlacedShape second : other.figure.pieces) {
                boolean solid = piece.surface.obstacle() && second.surface.obstacle() && piece.isLevelWith(second);
                if (solid && piece.separation(second) <= 0) {
                    return false;
                }
            }
        }
        return true;
    }

    @Test
    void whoIsGoneIsInNobodysWayAndNotSeen() {
        var world = new World(RasterWalls.of(DrawnMap.grid(10, ".").grid()));
        Body self = world.add("self", CollisionShape.of(BOX), new Pose2d(1, 5, 0), 0);
        Body other = world.add("other", CollisionShape.of(BOX), new Pose2d(3, 5, 0), 0);
        var beams = new SensorRays(List.of(new Fan(Pose2d.ORIGIN, 0, 1, 1)), 0);
        assertThat(beams.cast(world, self, 8)[0]).isLessThan(2);
        assertThat(world.hasRoom(CollisionShape.of(BOX), other.pose(), 0)).isFalse();
        world.remove(other);
        world.remove(other);
        world.look();
        assertThat(beams.cast(world, self, 8)[0]).isEqualTo(Double.POSITIVE_INFINITY);
        assertThat(world.advance(self, Arc.ahead(self.pose(), 3, 0))).isEqualTo(1);
        Body next = world.add("next", CollisionShape.of(BOX), new Pose2d(6, 5, 0), 0);
        assertThat(beams.cast(world, self, 8)[0]).isLessThan(5);
        assertThat(world.advance(self, Arc.ahead(self.pose(), 3, 0))).isLessThan(1);
        assertThat(world.obstacle()).contains(next);
    }

    @Test
    void whileSensorsLookTheySeeWhatWasThere() {
        var world = new World(List.of(), new Extent(0, 0, 10, 10));
        Body self = world.add("self", CollisionShape.of(BOX), new Pose2d(1, 5, 0), 0);
        Body far = world.add("far", CollisionShape.of(BOX), new Pose2d(6, 5, 0), 0);
        var ahead = new SensorRays(List.of(new Fan(Pose2d.ORIGIN, 0, 1, 1)), 0);
        double before = ahead.cast(world, self, 9)[0];
        world.watched(true);
        Body near = world.add("near", CollisionShape.of(BOX), new Pose2d(3, 5, 0), 0);
        Body brief = world.add("brief", CollisionShape.of(BOX), new Pose2d(3, 7, 0), 0);
        world.remove(brief);
        world.remove(far);
        world.pickUp(near, self);
        world.carry(near, new Pose2d(4, 5, 0), 0);
        assertThat(ahead.cast(world, self, 9)[0]).isEqualTo(before);
        world.watched(false);
        world.look();
        assertThat(ahead.cast(world, self, 9)[0]).isEqualTo(Double.POSITIVE_INFINITY);
        assertThat(world.putDown(near, near.pose(), 0)).isTrue();
        world.look();
        assertThat(ahead.cast(world, self, 9)[0]).isBetween(2.0, 3.0);
        world.add("next", CollisionShape.of(BOX), new Pose2d(2, 5, 0), 0);
        assertThat(ahead.cast(world, self, 9)[0]).isLessThan(1);
    }

    @Test
    void whatIsCarriedIsInNobodysWayAndIsPutDownOnlyWhereItFits() {
        var world = new World(List.of(), new Extent(0, 0, 10, 10));
        Body self = world.add("self", CollisionShape.of(BOX), new Pose2d(1, 5, 0), 0);
        Body held = world.add("held", CollisionShape.of(BOX), new Pose2d(2, 5, 0), 0);
        Body other = world.add("other", CollisionShape.of(BOX), new Pose2d(6, 5, 0), 0);
        world.pickUp(held, self);
        assertThat(world.advance(other, Arc.ahead(other.pose(), -4, 0))).isEqualTo(1);
        assertThat(world.putDown(held, new Pose2d(2, 5, 0), 0)).isFalse();
        assertThat(world.obstacle()).contains(other);
        assertThat(held.pose()).isEqualTo(new Pose2d(2, 5, 0));
        assertThat(world.putDown(held, new Pose2d(4, 5, 0), 0)).isTrue();
        assertThat(world.advance(other, Arc.ahead(other.pose(), 4, 0))).isLessThan(1);
        assertThat(world.obstacle()).contains(held);
    }
}
