package rsal.sim.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import rsal.data.Fan;
import rsal.data.Footprint;
import rsal.data.Pose2d;
import rsal.robot.Shift;
import rsal.testkit.DrawnMap;

class SensorRaysTest {
    private static final Footprint BOX = RandomWorld.box(0.5, 0.4, -0.04, 0);

    private static final double HEIGHT = 0.3; // of the sensor

    @Test
    void everyRayEndsAtTheNearestWallOrRobot() {
        for (long seed = 0; seed < 200; seed++) {
            var random = new RandomWorld(seed, 0.1, 0.01);
            var world = new World(RasterWalls.of(random.map));
            var bodies = new ArrayList<Body>();
            for (int i = 0; i < 15; i++) {
                Pose2d pose = random.anywhere();
                if (world.hasRoom(CollisionShape.of(BOX), pose, 0.1)) {
                    bodies.add(world.add("r" + i, random.chunks(), pose, 0));
                }
            }
            if (bodies.isEmpty()) {
                continue;
            }
            int count = random.random.nextInt(1, 200);
            double first = random.random.nextDouble(-4, 4);
            double increment = random.random.nextDouble(0.001, 7.0 / count); // up to more than a turn
            double reach = random.random.nextDouble(0.5, 10);
            var baseFromSensor = new Pose2d(0.1, 0.1, 1);
            Shift shift = seed % 2 == 0
                    ? Shift.NONE
                    : new Shift(
                            new Pose2d(random.random.nextDouble(-2, 2), 0.3, random.random.nextDouble(-4, 4)), -0.1);
            Pose2d mapFromSensor =
                    bodies.getFirst().pose().compose(shift.baseFromMoved()).compose(baseFromSensor);
            double height = HEIGHT + shift.rise();
            var beams = new SensorRays(List.of(new Fan(baseFromSensor, first, increment, count)), HEIGHT);
            double[] turned = new double[count];
            double most = seed % 3 == 0 ? random.random.nextDouble(0.001, 0.5) : 0;
            Arrays.setAll(turned, _ -> most == 0 ? 0 : random.random.nextDouble(-most, most));
            double[] ranges = beams.cast(
                    world,
                    bodies.getFirst(),
                    shift,
                    reach,
                    most,
                    Arrays.stream(turned).iterator()::nextDouble);
            for (int i = 0; i < count; i++) {
                double direction = mapFromSensor.theta() + first + i * increment + turned[i];
                assertThat(ranges[i])
                        .as("seed %d, ray %d of %d", seed, i, count)
                        .isCloseTo(slow(world, bodies, mapFromSensor, height, direction, reach), within(1e-9));
            }
        }
    }

    private static double slow(
            World world, List<Body> bodies, Pose2d from, double height, double direction, double reach) {
        double dx = Math.cos(direction);
        double dy = Math.sin(direction);
        double range = RandomWorld.ray(world.walls().getFirst(), from.x(), from.y(), dx, dy, reach);
        for (Body body : bodies.subList(1, bodies.size())) {
            for (PlacedShape piece : body.figure.pieces) {
                if (piece.isAt(body.height() + height) && piece.surface.seenByRangers()) {
                    range = Math.min(range, piece.ray(from.x(), from.y(), dx, dy));
                }
            }
        }
        return range <= reach ? range : Double.POSITIVE_INFINITY;
    }

    @Test
    void robotsAreSeenWhereTheyWereWhenTheWorldWasLookedAt() {
        var world = new World(RasterWalls.of(DrawnMap.grid(10, ".").grid()));
        Body self = world.add("self", CollisionShape.of(BOX), new Pose2d(1, 5, 0), 0);
        Body other = world.add("other", CollisionShape.of(BOX), new Pose2d(3, 5, 0), 0);
        world.place(other, new Pose2d(4, 5, 0));
        var ahead = new SensorRays(List.of(new Fan(Pose2d.ORIGIN, 0, 1, 1)), 0);
        assertThat(ahead.cast(world, self, 8)[0]).isCloseTo(2 - 0.29, within(1e-9));
        world.look();
        assertThat(ahead.cast(world, self, 8)[0]).isCloseTo(3 - 0.29, within(1e-9));
    }
}
