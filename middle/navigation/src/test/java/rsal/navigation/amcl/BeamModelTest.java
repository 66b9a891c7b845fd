package rsal.navigation.amcl;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.OccupancyGrid;
import rsal.data.Pose2d;
import rsal.data.RangeArray;
import rsal.navigation.grid.DistanceField;
import rsal.testkit.DrawnMap;

class BeamModelTest {
    private static final DrawnMap ROOM = Seen.fine("""
            ####################
            #..................#
            #..................#
            #..................#
            #..................#
            #.........#........#
            #..a......#........#
            #.........#........#
            #..................#
            ####################
            """);
    private static final BeamModel MODEL = model(ROOM.grid());

    @Test
    void aBeamAsLongAsItShouldBeIsMostLikely() {
        assertThat(MODEL.likelihood(2, 2)).isCloseTo(0.9, within(0.06));
        assertThat(MODEL.likelihood(1.9, 2)).isLessThan(MODEL.likelihood(2, 2));
    }

    @Test
    void aBeamThatIsTooShortIsMoreLikelyThanOneThatWentThroughAWall() {
        assertThat(MODEL.likelihood(1, 3)).isGreaterThan(MODEL.likelihood(3, 1));
        assertThat(MODEL.likelihood(3, 1)).isCloseTo(0.05, within(1e-6));
    }

    @Test
    void wallsHideWhatIsBehindThem() {
        Pose2d here = ROOM.pose('a', 0);
        double toWall = 1.625; // from the middle of its sign to the side of the wall
        double behind = 3.875; // to the right side of the room
        var field = new LikelihoodField(ROOM.grid(), DistanceField.toOccupied(ROOM.grid()), 0.1, 0.05);

        assertThat(log(MODEL, here, toWall)).isGreaterThan(-0.4);
        assertThat(log(MODEL, here, behind)).isLessThan(-2.5);
        assertThat(log(field, here, behind)).isGreaterThan(-0.4);
    }

    @Test
    void aBeamThatLeavesTheMapSaysNothingWhereverItEnds() {
        var cells = new byte[10_000];
        cells[0] = OccupancyGrid.OCCUPIED; // far aside
        var open = new OccupancyGrid(100, 100, 0.05, 0, 0, cells);
        BeamModel model = model(open);
        var here = new Pose2d(2.5, 2.5, 0);

        for (double range : new double[] {2.3, 2.5, 2.7, 5}) { // the map ends after 2.5 m
            assertThat(log(model, here, range)).as("%s m", range).isCloseTo(Math.log(0.08), within(0.3));
        }
    }

    @Test
    void beamsThatEndOutsideOfAMapThatWasCutOffCountAsTheOthersDo() {
        BeamModel model = model(Seen.CUT_OFF.grid());
        Pose2d at = Seen.CUT_OFF.pose('@', 0);
        double inside = model.log(Seen.straight(-0.4f, -0.5f), at.x(), at.y(), 0);
        double two = model.log(Seen.straight(3, 3), at.x(), at.y(), 0);

        assertThat(model.log(Seen.straight(-0.4f, -0.5f, 3), at.x(), at.y(), 0)).isCloseTo(1.5 * inside, within(1e-9));
        assertThat(model.log(Seen.straight(-0.4f, -0.5f, 3, 3, 3, 3), at.x(), at.y(), 0))
                .as("no more than end on it")
                .isCloseTo(2 * inside + two, within(1e-9));
    }

    @Test
    void aConeEndsAtWhatIsNearestInIt() {
        var sonar = new RangeArray(List.of(Pose2d.ORIGIN), Math.toRadians(60), 0, 5, new float[] {1.625f});
        var aside = new Pose2d(
                ROOM.pose('a', 0).x(), ROOM.pose('a', 0).y() + 0.45, Math.toRadians(0)); // looks past the wall's end
        var thin = Beams.of(sonar, 5);

        assertThat(MODEL.log(thin, aside.x(), aside.y(), aside.theta())).isGreaterThan(-1.5);
        assertThat(MODEL.log(
                        new Beams(thin.x(), thin.y(), thin.originX(), thin.originY()),
                        aside.x(),
                        aside.y(),
                        aside.theta()))
                .isLessThan(-2);
    }

    private static BeamModel model(OccupancyGrid map) {
        return new BeamModel(DistanceField.toOccupied(map), OutOfMapModel.of(map), 0.1, 0.05);
    }

    private static double log(SensorModel model, Pose2d from, double range) {
        var beams = new Beams(new float[] {(float) range}, new float[1], new float[1], new float[1]);
        return model.log(beams, from.x(), from.y(), from.theta());
    }

    /// Probabilistic Robotics, section 6.3, without the normalizers: z_hit exp(-(z - z*)² / 2 σ²) + z_short exp(-λ z),
    /// where z is less than z*, + z_rand.
    @ParameterizedTest
    @CsvSource({"2, 2", "1.95, 2", "2.05, 2", "1, 3", "3, 1", "0.2, 0.9", "4, Infinity"})
    void aBeamHasTheLikelihoodOfItsLength(double measured, double expected) {
        double hit = 0.85 * Math.exp(-(measured - expected) * (measured - expected) / (2 * 0.1 * 0.1));
        double tooShort = measured < expected ? 0.1 * Math.exp(-0.3 * measured) : 0;
        assertThat(MODEL.likelihood(measured, expected)).isCloseTo(hit + tooShort + 0.05, within(1e-12));
    }

    private static Beams around(double cone) {
        float[] x = {1.4f, -0.9f, 0.2f, 0.6f};
        float[] y = {0.3f, 0.5f, -1.1f, 0.9f};
        float[] originX = {0.2f, -0.15f, 0.05f, 0.1f};
        float[] originY = {0.1f, 0.05f, -0.2f, 0};
        return new Beams(x, y, originX, originY, cone);
    }

    /// A sensor that looks along one of the beams.
    private static Pose2d baseFromSensor(Beams beams, int beam) {
        double dx = beams.x()[beam] - beams.originX()[beam];
        double dy = beams.y()[beam] - beams.originY()[beam];
        return new Pose2d(beams.originX()[beam], beams.originY()[beam], Math.atan2(dy, dx));
    }

    private static double length(Beams beams, int beam) {
        return Math.hypot(beams.x()[beam] - beams.originX()[beam], beams.y()[beam] - beams.originY()[beam]);
    }

    /// From where each sensor is, in the direction of its beam.
    @Test
    void allBeamsCountFromWhereTheirSensorsAre() {
        DistanceField field = DistanceField.toOccupied(ROOM.grid());
        var random = new SplittableRandom(2);
        Beams beams = around(0);
        int many = 50;
        var particles = new Particles(many);
        for (int i = 0; i < many; i++) {
            particles.add(random.nextDouble(0.5, 4.5), random.nextDouble(0.5, 1), random.nextDouble(-3, 3));
        }
        var logs = new double[many];
        MODEL.logs(beams, particles, new PoseBlock(), logs);
        for (int i = 0; i < many; i++) {
            var pose = new Pose2d(particles.x[i], particles.y[i], particles.theta[i]);
            double sum = 0;
            for (int beam = 0; beam < beams.count(); beam++) {
                Pose2d from = pose.compose(baseFromSensor(beams, beam));
                double measured = length(beams, beam);
                double wall = field.firstHit(from.x(), from.y(), Math.cos(from.theta()), Math.sin(from.theta()), 20);
                sum += Math.log(MODEL.likelihood(measured, wall));
            }
            assertThat(MODEL.log(beams, particles.x[i], particles.y[i], particles.theta[i]))
                    .isCloseTo(sum, within(2e-3));
            assertThat(logs[i]).isCloseTo(sum, within(2e-3));
        }
    }

    /// So many unlikely beams that their product is less than a number can hold.
    @ParameterizedTest
    @ValueSource(doubles = {0, 0.5})
    void manyBeamsCountAsOftenAsOne(double cone) {
        Beams few = around(cone);
        int times = 400;
        var many = new Beams(
                repeated(few.x(), times),
                repeated(few.y(), times),
                repeated(few.originX(), times),
                repeated(few.originY(), times),
                cone);
        assertThat(log(few) * times).isLessThan(-1000);
        assertThat(MODEL.log(many, 1.1, 0.8, 1)).isCloseTo(times * MODEL.log(few, 1.1, 0.8, 1), within(1e-4));
        assertThat(log(many)).isCloseTo(times * log(few), within(1e-4));
    }

    private static float[] repeated(float[] values, int times) {
        var all = new float[values.length * times];
        for (int i = 0; i < all.length; i++) {
            all[i] = values[i % values.length];
        }
        return all;
    }

    private static double log(Beams beams) {
        var one = new Particles(1);
        one.add(1.1, 0.8, 1);
        var log = new double[1];
        MODEL.logs(beams, one, new PoseBlock(), log);
        return log[0];
    }

    /// As far as [Cones] say, from where each sensor is; the bell is read from a table.
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void conesCountAsFarAsTheyReach(boolean cutOff) {
        OccupancyGrid map = (cutOff ? Seen.CUT_OFF : ROOM).grid();
        DistanceField field = DistanceField.toOccupied(map);
        OutOfMapModel around = OutOfMapModel.of(map);
        BeamModel model = new BeamModel(field, around, 0.1, 0.05);
        double cone = Math.toRadians(30);
        var cones = new Cones(field, Cones.raysAside(cone));
        Beams beams = around(cone);
        var random = new SplittableRandom(2);
        int many = PoseBlock.SIZE + 50;
        var particles = new Particles(many);
        for (int i = 0; i < many; i++) {
            particles.add(random.nextDouble(0.5, 1.4), random.nextDouble(0.5, 1), random.nextDouble(-3, 3));
        }
        var logs = new double[many];
        model.logs(beams, particles, new PoseBlock(), logs);
        for (int i = 0; i < many; i++) {
            var pose = new Pose2d(particles.x[i], particles.y[i], particles.theta[i]);
            double onMap = 0;
            double beyond = 0;
            int outside = 0;
            for (int beam = 0; beam < beams.count(); beam++) {
                Pose2d from = pose.compose(baseFromSensor(beams, beam));
                double measured = length(beams, beam);
                double reach = cones.reach(
                        (float) ((from.x() - cones.originX) * cones.cellsPerMeter),
                        (float) ((from.y() - cones.originY) * cones.cellsPerMeter),
                        (float) Math.cos(from.theta()),
                        (float) Math.sin(from.theta()),
                        Math.floorMod(Math.round(from.theta() / (2 * Math.PI) * Cones.DIRECTIONS), Cones.DIRECTIONS),
                        measured + 0.4);
                double log = Math.log(model.likelihood(measured, reach));
                boolean leaves = reach == Double.POSITIVE_INFINITY
                        && around.isUnknown()
                        && !field.contains(
                                from.x() + measured * Math.cos(from.theta()),
                                from.y() + measured * Math.sin(from.theta()));
                onMap += leaves ? 0 : log;
                beyond += leaves ? log : 0;
                outside += leaves ? 1 : 0;
            }
            double all = around.joined(onMap, beams.count() - outside, beyond, outside);
            assertThat(logs[i]).as("pose %d", i).isCloseTo(all, within(0.02));
        }
    }
}
