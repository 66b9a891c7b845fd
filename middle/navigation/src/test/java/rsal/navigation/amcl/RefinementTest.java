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
    void staysWhereACorridorSaysNothing() {
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

    /// Half the squares of how far the pose is from its start, by its variances, and of how far beams end from
    /// walls: those of Geman and McClure, which count the less the farther away.
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

    /// Equations 12 and 13 of Kohlbrecher: the information is the sum of JᵀJ, the right side that of -Jᵀd,
    /// where J is how a beam's distance grows along x, y and with the heading. Here J is had by small steps.
    /// Each beam has the weight of Geman and McClure, (1 + d²/4σ²)⁻², and the scale.
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6})
    void sumsUpHowDistancesGrow(long seed) {
        var random = new SplittableRandom(seed);
        DistanceField toWall = DistanceField.toOccupied(Seen.ROOM.grid());
        Pose2d pose = Seen.ROOM
                .pose('a', random.nextDouble(360))
                .compose(new Pose2d(random.nextDouble(-0.2, 0.2), random.nextDouble(-0.2, 0.2), 0));
        int count = 20;
        var beams = new Beams(new float[count], new float[count], new float[count], new float[count]);
        for (int i = 0; i < count; i++) {
            beams.x()[i] = (float) random.nextDouble(-3, 3); // some end beyond the map
            beams.y()[i] = (float) random.nextDouble(-3, 3);
        }
        double deviation = 0.15;
        double scale = 7;
        var expected = new double[9];
        for (int i = 0; i < count; i++) {
            var end = new Point2d(beams.x()[i], beams.y()[i]);
            double distance = distance(toWall, pose, end);
            if (Double.isNaN(distance)) {
                continue;
            }
            double h = 1e-7;
            double[] j = {
                (distance(toWall, new Pose2d(pose.x() + h, pose.y(), pose.theta()), end) - distance) / h,
                (distance(toWall, new Pose2d(pose.x(), pose.y() + h, pose.theta()), end) - distance) / h,
                (distance(toWall, new Pose2d(pose.x(), pose.y(), pose.theta() + h), end) - distance) / h
            };
            double weight = scale * Math.pow(1 + distance * distance / (4 * deviation * deviation), -2);
            int at = 0;
            for (int row = 0; row < 3; row++) {
                for (int column = row; column < 3; column++) {
                    expected[at++] += weight * j[row] * j[column];
                }
                expected[6 + row] -= weight * j[row] * distance;
            }
        }
        double[] sums = new Refinement(toWall, deviation, 15).add(beams, pose.x(), pose.y(), pose.theta(), scale);
        for (int i = 0; i < 9; i++) {
            assertThat(sums[i]).as("sum %d", i).isCloseTo(expected[i], within(1e-4 * (1 + Math.abs(expected[i]))));
        }
        assertThat(sums[0] * sums[3] * sums[5]).isGreaterThan(0.1);
    }

    /// Of where a point of the base frame is; NaN outside the map.
    private static double distance(DistanceField toWall, Pose2d pose, Point2d point) {
        Point2d end = pose.transform(point);
        var slope = new double[3];
        return toWall.slope(end.x(), end.y(), slope) ? slope[0] : Double.NaN;
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5})
    void solvesThreeEquations(long seed) {
        var random = new SplittableRandom(seed);
        var rows = new double[4][3];
        for (double[] row : rows) {
            for (int i = 0; i < 3; i++) {
                row[i] = random.nextDouble(-2, 2);
            }
        }
        double[] solution = {random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(-1, 1)};
        var matrix = new double[3][3]; // rowsᵀ rows
        for (int i = 0; i < 3; i++) {
            for (int k = 0; k < 3; k++) {
                for (double[] row : rows) {
                    matrix[i][k] += row[i] * row[k];
                }
            }
        }
        var right = new double[3];
        for (int i = 0; i < 3; i++) {
            for (int k = 0; k < 3; k++) {
                right[i] += matrix[i][k] * solution[k];
            }
        }
        var found = new double[3];
        Refinement.solve(
                new double[] {
                    matrix[0][0],
                    matrix[0][1],
                    matrix[0][2],
                    matrix[1][1],
                    matrix[1][2],
                    matrix[2][2],
                    right[0],
                    right[1],
                    right[2]
                },
                found);
        for (int i = 0; i < 3; i++) {
            assertThat(found[i]).isCloseTo(solution[i], within(1e-9));
        }
    }

    /// By up to 0.3 rad it is turned.
    @Test
    void whatIsTurnedTooFarStays() {
        OccupancyGrid hall = Seen.hall(60, 60, 0, 0);
        var refinement = new Refinement(DistanceField.toOccupied(hall), 2, 1e6);
        var free = Covariance2d.ofDeviations(0.001, 0.001, 100);
        Pose2d middle = new Pose2d(3, 3, 0);
        for (double turn : new double[] {0.2, -0.2, 0.29, -0.29}) {
            Beams walls = walls(middle);
            Pose2d start = new Pose2d(3, 3, turn);
            assertThat(refinement.refine(walls, start, free).theta())
                    .as("%.2f rad", turn)
                    .isCloseTo(middle.theta(), within(0.03));
        }
        for (double turn : new double[] {0.4, -0.4}) {
            Pose2d start = new Pose2d(3, 3, turn);
            assertThat(refinement.refine(walls(middle), start, free)).isEqualTo(start);
        }
    }

    /// Beams from the middle of the hall to the wall ahead and the one to the left.
    private static Beams walls(Pose2d mapFromBase) {
        int count = 14;
        var beams = new Beams(new float[count], new float[count], new float[count], new float[count]);
        for (int i = 0; i < count / 2; i++) {
            double along = -1.5 + 0.5 * i;
            Point2d ahead = mapFromBase.inverse().transform(new Point2d(5.95, 3 + along));
            Point2d left = mapFromBase.inverse().transform(new Point2d(3 + along, 5.95));
            beams.x()[2 * i] = (float) ahead.x();
            beams.y()[2 * i] = (float) ahead.y();
            beams.x()[2 * i + 1] = (float) left.x();
            beams.y()[2 * i + 1] = (float) left.y();
        }
        return beams;
    }
}
