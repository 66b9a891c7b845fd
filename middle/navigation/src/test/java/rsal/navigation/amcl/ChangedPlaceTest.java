package rsal.navigation.amcl;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.UnaryOperator;
import org.junit.jupiter.api.Test;
import rsal.data.Covariance2d;
import rsal.data.OccupancyGrid;
import rsal.data.Pose2d;
import rsal.data.PoseEstimate;
import rsal.data.PoseEstimate.Quality;
import rsal.testkit.DrawnMap;
import rsal.testkit.LongTest;
import rsal.testkit.Trials;

/// A robot that is told where it starts, in places that differ from their maps or with wheels that are wrong: it stays
/// where odometry says, and is not *localized* where it is wrong. The many cases are in
/// `rsal bench navigation --only amcl.honest`.
class ChangedPlaceTest {
    private static final Covariance2d KNOWN = Covariance2d.ofDeviations(0.1, 0.1, 0.05);
    private static final Pose2d STEP = new Pose2d(0.08, 0, 0.1);
    private static final double CELL = 0.05;

    /// Half a turn makes it the same.
    private static final DrawnMap MIRRORED = Seen.fine("""
            ########################################
            #......................................#
            #......................................#
            #......................................#
            #......................................#
            #......................................#
            #......................................#
            #......................................#
            #......................................#
            #......................................#
            #......................................#
            #......................................#
            #......................................#
            ########################################
            """);

    /// What was believed, and where the robot was.
    private record Belief(PoseEstimate estimate, Pose2d truth) {
        double error() {
            return estimate.mapFromBase().distanceTo(truth);
        }

        boolean isLie() {
            return estimate.quality() == Quality.LOCALIZED && error() > 0.5;
        }
    }

    /// Cells of a rectangle [m] get a value.
    private static OccupancyGrid with(
            OccupancyGrid map, byte value, double left, double bottom, double right, double top) {
        byte[] cells = map.cells().clone();
        for (int row = (int) (bottom / CELL); row < top / CELL; row++) {
            for (int column = (int) (left / CELL); column < right / CELL; column++) {
                cells[row * map.width() + column] = value;
            }
        }
        return new OccupancyGrid(map.width(), map.height(), map.resolution(), 0, 0, cells);
    }

    private static OccupancyGrid furnished(OccupancyGrid map, double left, double bottom, double right, double top) {
        return with(map, OccupancyGrid.OCCUPIED, left, bottom, right, top);
    }

    /// @param wheels what odometry says of a motion
    private static List<Belief> drive(
            OccupancyGrid world,
            OccupancyGrid map,
            Pose2d start,
            int steps,
            Pose2d step,
            UnaryOperator<Pose2d> wheels,
            long seed) {
        var amcl =
                new Amcl(new LocalizationMap(map, 0.1, 0.05), Amcl.Settings.of(150, 2000), new SplittableRandom(seed));
        var seen = new Seen(new DrawnMap(world, MIRRORED.places()));
        amcl.start(PoseEstimate.of(start, KNOWN));
        var beliefs = new ArrayList<Belief>();
        Pose2d truth = start;
        Pose2d odometry = Pose2d.ORIGIN;
        for (int i = 0; i < steps; i++) {
            beliefs.add(new Belief(
                    amcl.update(odometry, seen.beams(truth, map.width() * CELL > 20 ? 3 : 8, 60)), truth));
            truth = truth.compose(step);
            assertThat(seen.isFree(truth))
                    .as("no robot drives through walls: %s", truth)
                    .isTrue();
            odometry = odometry.compose(wheels.apply(step));
        }
        return beliefs;
    }

    /// The map has three cupboards; they were moved to where those of the mirror twin would be.
    @Trials(
            value = {"1", "2", "3", "4"},
            landing = 1)
    void furnitureThatWasMovedIsNoReasonToJumpToTheTwin(long seed) {
        OccupancyGrid bare = MIRRORED.grid();
        OccupancyGrid map =
                furnished(furnished(furnished(bare, 4, 0.05, 4.8, 0.45), 5.5, 2.8, 6.3, 3.2), 1, 2.7, 1.5, 3.2);
        OccupancyGrid world =
                furnished(furnished(furnished(bare, 5.2, 2.8, 6, 3.2), 3.7, 0.05, 4.5, 0.45), 8.5, 0.05, 9, 0.6);
        List<Belief> beliefs = drive(world, map, new Pose2d(4.8, 0.65, 0), 120, STEP, UnaryOperator.identity(), seed);
        assertThat(beliefs).noneMatch(Belief::isLie);
        assertThat(beliefs).allMatch(belief -> belief.error() < 0.3);
        assertThat(beliefs.stream().filter(b -> b.estimate().quality() == Quality.LOST))
                .isEmpty();
    }

    /// A side wall of 10 m is 0.35 m farther in than it was drawn, over 3 m of its length.
    @Test
    @LongTest
    void aWallDrawnWrongIsNoReasonToBeLost() {
        OccupancyGrid map = Seen.ROOM.grid();
        OccupancyGrid world = furnished(map, 0, 0, 3, 0.6);
        List<Belief> beliefs = drive(world, map, Seen.ROOM.pose('a', 180), 120, STEP, UnaryOperator.identity(), 1);
        assertThat(beliefs).allMatch(belief -> belief.error() < 0.3);
        assertThat(beliefs.stream().filter(b -> b.estimate().quality() == Quality.LOST))
                .isEmpty();
    }

    @Trials({"1", "2", "3"})
    void wheelsOfTheWrongSizeAreNoticed(long seed) {
        OccupancyGrid map = Seen.ROOM.grid();
        List<Belief> beliefs = drive(
                map,
                map,
                Seen.ROOM.pose('a', 180),
                150,
                new Pose2d(0.08, 0, 0.1),
                motion -> new Pose2d(1.25 * motion.x(), 0, motion.theta()),
                seed);
        assertThat(beliefs).noneMatch(Belief::isLie);
        assertThat(beliefs.subList(50, 150)).allMatch(belief -> belief.error() < 0.15);
    }

    /// It sees 3 m far, and no end for 20 m.
    @Test
    void aCorridorWithoutFeaturesMakesItAmbiguous() {
        int width = (int) (40 / CELL);
        OccupancyGrid corridor = Seen.hall(width, (int) (2 / CELL), 0, 0);
        var map = new OccupancyGrid(width, corridor.height(), CELL, 0, 0, corridor.cells());
        List<Belief> beliefs = drive(
                map,
                map,
                new Pose2d(5, 1, 0),
                170,
                new Pose2d(0.15, 0, 0),
                motion -> new Pose2d(1.1 * motion.x(), 0, 0),
                1);
        assertThat(beliefs.getFirst().estimate().quality()).isEqualTo(Quality.LOCALIZED);
        assertThat(beliefs).noneMatch(belief -> belief.isLie() && belief.error() > 0.8);
        assertThat(beliefs.subList(80, 170)).allMatch(b -> b.estimate().quality() == Quality.AMBIGUOUS);
    }

    @Test
    @LongTest
    void odometryThatJumpsIsNotBelieved() {
        OccupancyGrid map = Seen.ROOM.grid();
        int[] step = {0};
        List<Belief> beliefs = drive(
                map,
                map,
                Seen.ROOM.pose('a', 180),
                80,
                STEP,
                motion -> ++step[0] == 40 ? motion.compose(new Pose2d(4, 1, 0.5)) : motion,
                1);
        assertThat(beliefs).noneMatch(Belief::isLie);
        assertThat(beliefs.getLast().error()).isLessThan(0.15);
        assertThat(beliefs.getLast().estimate().quality()).isEqualTo(Quality.LOCALIZED);
    }
}
