package rsal.navigation.amcl;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.Angles;
import rsal.data.Covariance2d;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.navigation.grid.DistanceField;
import rsal.testkit.DrawnMap;

class RefinementTest {
    private static final Covariance2d VAGUE = Covariance2d.ofDeviations(0.3, 0.3, 0.2);

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10})
    void bringsAPoseToWithinCentimetersOfWhereTheScanWasTaken(long seed) {
        var random = new SplittableRandom(seed);
        var place = new Seen(Seen.ROOM);
        var refinement = new Refinement(DistanceField.toOccupied(Seen.ROOM.grid()), 0.1, 15);
        Pose2d truth = Seen.ROOM.pose('a', random.nextDouble(360));
        Pose2d start = truth.compose(
                new Pose2d(random.nextDouble(-0.2, 0.2), random.nextDouble(-0.2, 0.2), random.nextDouble(-0.12, 0.12)));

        Pose2d found = refinement.refine(place.beams(truth, 60), start, VAGUE);

        assertThat(found.distanceTo(truth)).as("seed %d", seed).isLessThan(0.04);
        assertThat(Angles.difference(found.theta(), truth.theta())).isCloseTo(0, within(0.02));
    }

    @Test
    void staysWhereACorridorTellsNothing() {
        DrawnMap corridor = DrawnMap.grid(0.1, """
                ############################################################
                ............................................................
                ............................................................
                ............................................................
                ............................a...............................
                ............................................................
                ............................................................
                ............................................................
                ############################################################
                """);
        var refinement = new Refinement(DistanceField.toOccupied(corridor.grid()), 0.1, 15);
        Pose2d truth = corridor.pose('a', 0);
        Pose2d start = new Pose2d(truth.x() + 0.15, truth.y() + 0.1, 0.05);

        Pose2d found = refinement.refine(new Seen(corridor).beams(truth, 2, 60), start, VAGUE);

        assertThat(found.y()).isCloseTo(truth.y(), within(0.03));
        assertThat(found.theta()).isCloseTo(0, within(0.03));
        assertThat(found.x()).isCloseTo(start.x(), within(0.03));
    }

    /// Nothing else is seen that would draw the robot back.
    @Test
    void keepsOutOfAThickWall() {
        DrawnMap wall = Seen.fine("""
                ..............
                ##............
                ##............
                ##............
                ##...a........
                ##............
                ##............
                ##............
                ..............
                """);
        var refinement = new Refinement(DistanceField.toFace(wall.grid(), 0.1), 0.1, 15);
        Pose2d truth = wall.pose('a', 180);
        Pose2d start = new Pose2d(truth.x() - 0.08, truth.y(), truth.theta());

        Pose2d found = refinement.refine(new Seen(wall).beams(truth, 1.2, 60), start, VAGUE);

        assertThat(found.x()).isCloseTo(truth.x(), within(0.03));
    }

    @Test
    void keepsThePoseWhenNothingIsNear() {
        var refinement = new Refinement(DistanceField.toOccupied(Seen.ROOM.grid()), 0.1, 15);
        Pose2d outside = new Pose2d(100, 100, 0);

        assertThat(refinement.refine(new Seen(Seen.ROOM).beams(Seen.ROOM.pose('a', 0), 60), outside, VAGUE))
                .isEqualTo(outside);
        assertThat(refinement.refine(Seen.NOTHING, outside, VAGUE)).isEqualTo(outside);
    }

    /// Half the squares of how far the pose is from its start, by its variances, and of how far beams end from walls:
    /// those of Geman and McClure, which count the less the farther away.
    private static double cost(DistanceField toWall, Beams beams, Pose2d pose, Pose2d start) {
        double near = 4 * 0.1 * 0.1;
        double scale = Math.min(1, 15.0 / beams.count()) / (0.1 * 0.1);
        double turn = Angles.difference(start.theta(), pose.theta());
        double cost = (Math.pow(pose.distanceTo(start), 2) / 0.09 + turn * turn / 0.04) / 2;
        for (int i = 0; i < beams.count(); i++) {
            var end = pose.transform(new Point2d(beams.x()[i], beams.y()[i]));
            var slope = new double[3];
            if (toWall.slope(end.x(), end.y(), slope)) {
                double squared = slope[0] * slope[0];
                cost += scale * near * squared / (near + squared) / 2;
            }
        }
        return cost;
    }

    /// With beams that end at nothing on the map, as at people, and more beams than count as independent.
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
    void noPoseNearbyCostsLess(long seed) {
        var random = new SplittableRandom(seed);
        DistanceField toWall = DistanceField.toOccupied(Seen.ROOM.grid());
        var refinement = new Refinement(toWall, 0.1, 15);
        Pose2d truth = Seen.ROOM.pose(seed % 2 == 0 ? 'a' : 'b', random.nextDouble(360));
        Pose2d start = truth.compose(
                new Pose2d(random.nextDouble(-0.2, 0.2), random.nextDouble(-0.2, 0.2), random.nextDouble(-0.12, 0.12)));
        Beams beams = new Seen(Seen.ROOM).beams(truth, 40);
        for (int i = 0; i < beams.count(); i += 5) {
            beams.x()[i] *= 0.7f;
            beams.y()[i] *= 0.7f;
        }
        Pose2d found = refinement.refine(beams, start, VAGUE);
        double least = cost(toWall, beams, found, start);
        assertThat(least).isLessThan(cost(toWall, beams, start, start));
        for (Pose2d step : List.of(
                new Pose2d(0.02, 0, 0),
                new Pose2d(-0.02, 0, 0),
                new Pose2d(0, 0.02, 0),
                new Pose2d(0, -0.02, 0),
                new Pose2d(0, 0, 0.01),
                new Pose2d(0, 0, -0.01))) {
            assertThat(cost(toWall, beams, found.compose(step), start))
                    .as("seed %d, %s", seed, step)
                    .isGreaterThan(least);
        }
    }

    /// The better the start is known, the less a scan moves it: by the variances of both.
    @ParameterizedTest
    @ValueSource(doubles = {0.02, 0.05, 0.2})
    void aStartCountsAsAMeasurement(double deviation) {
        OccupancyGrid hall = Seen.hall(60, 60, 0, 0);
        DistanceField toWall = DistanceField.toOccupied(hall);
        Pose2d start = new Pose2d(3, 3, 0);
        Beams beams = Seen.straight(2.8f, 2.8f); // the wall's middle is at 5.95 m, both end at 5.8 m
        var covariance = Covariance2d.ofDeviations(deviation, 0.01, 0.001);
        Pose2d found = new Refinement(toWall, 0.1, 1).refine(beams, start, covariance);
        var slope = new double[3];
        toWall.slope(5.8, 3, slope);
        double off = slope[0]; // m
        // of one independent beam, with the weight of Geman and McClure where it ends: fixed point
        double moved = 0;
        for (int i = 0; i < 100; i++) {
            double share = 0.04 / (0.04 + (off - moved) * (off - moved));
            double weight = share * share / 0.01;
            moved = weight * off / (weight + 1 / (deviation * deviation));
        }
        assertThat(found.x() - start.x()).isCloseTo(moved, within(0.002));
        assertThat(found.y()).isCloseTo(3, within(1e-6));
    }

    @Test
    void aPoseThatWouldMoveTooFarStays() {
        OccupancyGrid hall = Seen.hall(60, 60, 0, 0);
        var refinement = new Refinement(DistanceField.toOccupied(hall), 2, 1e6);
        Pose2d start = new Pose2d(3, 3, 0);
        var free = Covariance2d.ofDeviations(100, 0.001, 0.001);
        assertThat(refinement.refine(Seen.straight(2.5f), start, free).x()).isGreaterThan(3.3);
        assertThat(refinement.refine(Seen.straight(2.2f), start, free)).isEqualTo(start); // 0.7 m
    }
}
