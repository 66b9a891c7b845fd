package rsal.navigation.amcl;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.Callable;
import java.util.concurrent.Executors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.OccupancyGrid;
import rsal.data.Pose2d;
import rsal.navigation.grid.DistanceField;

class ConesTest {
    private static final OccupancyGrid ROOM = Seen.ROOM.grid();
    private static final DistanceField FIELD = DistanceField.toOccupied(ROOM);
    private static final double CONE = Math.toRadians(30);
    private static final int ASIDE = Cones.raysAside(CONE);
    private static final double LIMIT = 20; // m

    /// Edges that a cone just sees from one place and not from the next make few differ by more.
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void reachesAboutAsFarAsRaysFromTheSensorItself(long seed) {
        var random = new SplittableRandom(seed);
        var cones = new Cones(FIELD, ASIDE);
        int count = 20_000;
        var errors = new double[count];
        for (int i = 0; i < count; i++) {
            Pose2d sensor = free(random);
            double reach = reach(cones, sensor);
            double exact = exact(cones, sensor);
            errors[i] = reach == exact ? 0 : Math.abs(reach - exact);
        }
        Arrays.sort(errors);

        assertThat(errors[count / 2]).as("median").isLessThan(0.02);
        assertThat(errors[(int) (0.95 * count)]).as("95 %").isLessThan(0.12);
        assertThat(Arrays.stream(errors).filter(error -> error < 0.25).count()).isGreaterThan((long) (0.975 * count));
    }

    @Test
    void reportsTheSameHoweverOftenItWasAsked() {
        var random = new SplittableRandom(1);
        for (int i = 0; i < 200; i++) {
            Pose2d sensor = free(random);
            var cones = new Cones(FIELD, ASIDE);
            double first = reach(cones, sensor);
            for (int again = 0; again < 40; again++) {
                assertThat(reach(cones, sensor)).isEqualTo(first);
            }
        }
    }

    @Test
    void reportsAllThreadsTheSame() throws Exception {
        var random = new SplittableRandom(1);
        List<Pose2d> sensors = Stream.generate(() -> free(random)).limit(50_000).toList();
        var shared = new Cones(FIELD, ASIDE);
        List<Double> alone = reaches(new Cones(FIELD, ASIDE), sensors);
        Callable<List<Double>> ask = () -> reaches(shared, sensors);

        try (var threads = Executors.newFixedThreadPool(4)) {
            for (var reported : threads.invokeAll(Collections.nCopies(4, ask))) {
                assertThat(reported.get().equals(alone)).isTrue(); // nobody wants to read what differs
            }
        }
    }

    private static List<Double> reaches(Cones cones, List<Pose2d> sensors) {
        return sensors.stream().map(sensor -> reach(cones, sensor)).toList();
    }

    @Test
    void besideTheMapThereIsNoWay() {
        assertThat(reach(new Cones(FIELD, ASIDE), new Pose2d(-0.05, 2, 0))).isZero();
        assertThat(reach(new Cones(FIELD, ASIDE), new Pose2d(1000, 1e9, 0))).isZero();
    }

    /// Thousands of poses of which some are beside the map, some in walls.
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void posesAreAboutAsLikelyAsByRaysFromEach(boolean cutOff) {
        OccupancyGrid map = (cutOff ? Seen.CUT_OFF : Seen.ROOM).grid();
        var model = new BeamModel(DistanceField.toOccupied(map), OutOfMapModel.of(map), 0.25, 0.05);
        var random = new SplittableRandom(1);
        Beams beams = new Seen(Seen.ROOM).sonars(Seen.ROOM.pose('a', 20), 16);
        int many = 2 * PoseBlock.SIZE + 77;
        var particles = new Particles(many);
        for (int i = 0; i < many; i++) {
            particles.add(
                    random.nextDouble(-0.5, map.width() * map.resolution() + 0.5),
                    random.nextDouble(-0.5, map.height() * map.resolution() + 0.5),
                    random.nextDouble(-Math.PI, Math.PI));
        }
        var logs = new double[many];
        model.logs(beams, particles, new PoseBlock(), logs);

        double sum = 0;
        for (int i = 0; i < many; i++) {
            double exact = model.log(beams, particles.x[i], particles.y[i], particles.theta[i]);
            sum += Math.abs(logs[i] - exact);
        }
        assertThat(sum / many / beams.count()).isCloseTo(0, within(0.05));

        var again = new double[many];
        model.logs(beams, particles, new PoseBlock(), again);
        assertThat(again).isEqualTo(logs);
    }

    private static Pose2d free(SplittableRandom random) {
        while (true) {
            double x = random.nextDouble(0, ROOM.width() * ROOM.resolution());
            double y = random.nextDouble(0, ROOM.height() * ROOM.resolution());
            if (FIELD.at(x, y) > 0.05) {
                return new Pose2d(x, y, random.nextDouble(-Math.PI, Math.PI));
            }
        }
    }

    private static double reach(Cones cones, Pose2d sensor) {
        double steps = sensor.theta() / (2 * Math.PI) * Cones.DIRECTIONS;
        return cones.reach(
                (float) ((sensor.x() - cones.originX) * cones.cellsPerMeter),
                (float) ((sensor.y() - cones.originY) * cones.cellsPerMeter),
                (float) Math.cos(sensor.theta()),
                (float) Math.sin(sensor.theta()),
                Math.floorMod(Math.round(steps), Cones.DIRECTIONS),
                LIMIT);
    }

    private static double exact(Cones cones, Pose2d sensor) {
        return cones.exact(sensor.x(), sensor.y(), Math.cos(sensor.theta()), Math.sin(sensor.theta()), LIMIT);
    }

    /// 6 m by 4 m.
    private static OccupancyGrid hall() {
        return Seen.hall(60, 40, -2, 3);
    }

    @Test
    void raysFill80PercentOfACone() {
        assertThat(Cones.raysAside(0)).isZero();
        assertThat(Cones.raysAside(Math.toRadians(30))).isEqualTo(4); // 12° to each side, in steps of 3°
        assertThat(Cones.raysAside(Math.toRadians(60))).isEqualTo(8);
    }

    /// What a cell keeps is in steps of 4 cm from its middle; where in it the sensor is counts as it is.
    @ParameterizedTest
    @ValueSource(ints = {0, 90, 180, -90})
    void aRayReachesAsFarAsFromTheMiddleOfItsCellInSteps(int degrees) {
        DistanceField field = DistanceField.toOccupied(hall());
        var cones = new Cones(field, 0);
        var random = new SplittableRandom(3);
        double cos = Math.cos(Math.toRadians(degrees));
        double sin = Math.sin(Math.toRadians(degrees));
        for (int i = 0; i < 300; i++) {
            double x = random.nextDouble(-1.6, 3.6);
            double y = random.nextDouble(3.4, 6.6);
            double middleX = -2 + (Math.floor((x + 2) * 10) + 0.5) / 10;
            double middleY = 3 + (Math.floor((y - 3) * 10) + 0.5) / 10;
            double wall = field.firstHit(middleX, middleY, cos, sin, 10);
            double expected = Math.floor(wall / 0.04 + 0.5) * 0.04 - cos * (x - middleX) - sin * (y - middleY);
            for (int asked = 0; asked < 20; asked++) { // kept after the sixteenth time
                assertThat(reach(cones, new Pose2d(x, y, Math.toRadians(degrees))))
                        .as("from (%.3f, %.3f)", x, y)
                        .isCloseTo(expected, within(1e-4));
            }
        }
    }

    @Test
    void besideAWallItIsExact() {
        var cones = new Cones(DistanceField.toOccupied(hall()), ASIDE);
        for (Pose2d sensor : List.of(new Pose2d(3.83, 5.011, 2), new Pose2d(1.013, 3.12, 1), new Pose2d(-1.88, 4, 0))) {
            assertThat(reach(cones, sensor)).isCloseTo(exact(cones, sensor), within(1e-5));
        }
    }

    /// The nearest of all rays: to a wall straight ahead that is the middle one, from aside the outermost.
    @Test
    void aConeReachesAsFarAsItsNearestRay() {
        var cones = new Cones(DistanceField.toOccupied(hall()), 4);
        assertThat(exact(cones, new Pose2d(1.05, 5.05, 0))).isCloseTo(2.85, within(0.06));
        double aside = Math.toRadians(40);
        double nearest = 1.85 / Math.sin(aside + Math.toRadians(12));
        assertThat(exact(cones, new Pose2d(1.05, 5.05, aside))).isCloseTo(nearest, within(0.07));
        assertThat(exact(cones, new Pose2d(1.05, 5.05, -aside)))
                .isCloseTo(1.95 / Math.sin(aside + Math.toRadians(12)), within(0.07));
        assertThat(reach(cones, new Pose2d(1.05, 5.05, aside))).isCloseTo(nearest, within(0.1));
    }

    @Test
    void whereNothingIsWithin10MetersItReachesForever() {
        byte[] cells = new byte[300 * 10];
        cells[5 * 300 + 150] = OccupancyGrid.OCCUPIED; // at 15 m
        var cones = new Cones(DistanceField.toOccupied(new OccupancyGrid(300, 10, 0.1, 0, 0, cells)), 0);
        for (int asked = 0; asked < 20; asked++) {
            assertThat(reach(cones, new Pose2d(4.05, 0.55, 0))).isEqualTo(Double.POSITIVE_INFINITY);
            assertThat(reach(cones, new Pose2d(6.05, 0.55, 0))).isBetween(8.9, 9.1);
        }
    }

    @Test
    void ofAMapThatIsTooLargeNothingIsKept() {
        byte[] cells = new byte[400 * 401];
        cells[50] = OccupancyGrid.OCCUPIED;
        var cones = new Cones(DistanceField.toOccupied(new OccupancyGrid(400, 401, 1, 0, 0, cells)), 0);
        var sensor = new Pose2d(43.217, 0.5, 0);
        assertThat(reach(cones, sensor)).isCloseTo(exact(cones, sensor), within(1e-4));
    }
}
