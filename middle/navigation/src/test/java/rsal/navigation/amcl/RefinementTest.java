package rsal.navigation.amcl;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.Angles;
import rsal.data.Covariance2d;
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
}
