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
    void tellsTheSameHoweverOftenItWasAsked() {
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
    void tellsAllThreadsTheSame() throws Exception {
        var random = new SplittableRandom(1);
        List<Pose2d> sensors = Stream.generate(() -> free(random)).limit(50_000).toList();
        var shared = new Cones(FIELD, ASIDE);
        List<Double> alone = reaches(new Cones(FIELD, ASIDE), sensors);
        Callable<List<Double>> ask = () -> reaches(shared, sensors);

        try (var threads = Executors.newFixedThreadPool(4)) {
            for (var told : threads.invokeAll(Collections.nCopies(4, ask))) {
                assertThat(told.get().equals(alone)).isTrue(); // nobody wants to read what differs
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
}
