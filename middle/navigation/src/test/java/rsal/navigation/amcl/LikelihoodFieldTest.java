package rsal.navigation.amcl;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.OccupancyGrid;
import rsal.data.Pose2d;
import rsal.navigation.grid.DistanceField;
import rsal.testkit.DrawnMap;

class LikelihoodFieldTest {
    private static final DrawnMap ROOM = DrawnMap.grid(0.1, """
            ####################
            #..................#
            #..................#
            #..................#
            #.........@........#
            #..................#
            #..................#
            ####################""");
    private static final LikelihoodField FIELD =
            new LikelihoodField(ROOM.grid(), DistanceField.toOccupied(ROOM.grid()), 0.1, 0.05);

    @Test
    void wallsAreMostLikely() {
        assertThat(FIELD.log(0.05, 0.35)).isCloseTo(0, within(1e-6));
    }

    @Test
    void besideAWallItIsTheBellOfTheDistanceOverTheRandomShare() {
        double oneDeviation = Math.log(0.95 * Math.exp(-0.5) + 0.05);
        assertThat(FIELD.log(0.15, 0.35)).isCloseTo(oneDeviation, within(1e-6));
    }

    @Test
    void nothingIsLessLikelyThanTheRandomShare() {
        assertThat(FIELD.log(-5, 3)).isCloseTo(Math.log(0.05), within(1e-6));
        assertThat(FIELD.unlikely()).isCloseTo(Math.log(0.05), within(1e-6));
    }

    @Test
    void beamsCountFromWhereTheBaseIs() {
        Pose2d mapFromBase = ROOM.pose('@', 90);
        // Ahead to the upper wall, to the left to the left wall: 0.35 m and 1 m from the middles of cells.
        var beams = new Beams(new float[] {0.4f, 0}, new float[] {0, 1.0f}, new float[2], new float[2]);
        assertThat(FIELD.log(beams, mapFromBase.x(), mapFromBase.y(), mapFromBase.theta()))
                .isCloseTo(0, within(1e-5));
        assertThat(FIELD.log(beams, mapFromBase.x(), mapFromBase.y(), 0)).isLessThan(-3);
    }

    @Test
    void outsideOfAMapThatWasCutOffBeamsCountAsTheOthersDo() {
        var field = new LikelihoodField(Seen.CUT_OFF.grid(), DistanceField.toOccupied(Seen.CUT_OFF.grid()), 0.1, 0.05);
        Pose2d at = Seen.CUT_OFF.pose('@', 0);
        double inside = field.log(Seen.straight(-0.4f, -0.5f), at.x(), at.y(), 0);
        double unlikely = field.unlikely();

        assertThat(field.log(Seen.straight(-0.4f, -0.5f, 3), at.x(), at.y(), 0)).isCloseTo(1.5 * inside, within(1e-5));
        assertThat(field.log(Seen.straight(-0.4f, -0.5f, 3, 4, 5), at.x(), at.y(), 0))
                .as("no more than end on it")
                .isCloseTo(2 * inside + unlikely, within(1e-5));
        assertThat(field.log(Seen.straight(3, 4), at.x(), at.y(), 0)).isCloseTo(2 * unlikely, within(1e-5));
        assertThat(FIELD.log(Seen.straight(0.2f, 9), 0.35, 0.35, 0))
                .as("where walls are all around")
                .isCloseTo(FIELD.log(0.55, 0.35) + unlikely, within(1e-5));
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void judgesManyPosesAsItJudgesEachAlone(boolean cutOff) {
        var map = (cutOff ? Seen.CUT_OFF : ROOM).grid();
        var field = new LikelihoodField(map, DistanceField.toOccupied(map), 0.1, 0.05);
        var random = new SplittableRandom(1);
        int many = 2 * PoseBlock.SIZE + 77;
        var particles = new Particles(many);
        for (int i = 0; i < many - 3; i++) { // on the map and around it
            particles.add(
                    random.nextDouble(-2, map.width() * map.resolution() + 2),
                    random.nextDouble(-2, map.height() * map.resolution() + 2),
                    random.nextDouble(-Math.PI, Math.PI));
        }
        particles.add(1e30, 0.5, 0);
        particles.add(-1e30, -1e30, 1);
        particles.add(0.5, 1e9, 2);
        Beams beams = Seen.straight(-0.4f, 0.1f, 0.9f, 1.4f, 3);
        var logs = new double[many];

        field.logs(beams, particles, new PoseBlock(), logs);

        for (int i = 0; i < many; i++) {
            assertThat(logs[i])
                    .as("pose %d", i)
                    .isEqualTo(field.log(beams, particles.x[i], particles.y[i], particles.theta[i]));
        }
    }

    /// 3 m by 2 m, with a wall inside, at (0.5, 3).
    private static OccupancyGrid elsewhere() {
        return Seen.hall(30, 20, -1, 2, 10 * 30 + 15);
    }

    /// log(z_hit exp(-d² / 2 σ²) + z_rand), where z_hit = 1 - z_rand and d is how far the nearest wall is.
    @Test
    void eachCellHasTheLikelihoodOfItsDistance() {
        OccupancyGrid map = elsewhere();
        DistanceField toWall = DistanceField.toOccupied(map);
        var field = new LikelihoodField(map, toWall, 0.04, 0.2);
        for (int row = 0; row < 20; row++) {
            for (int column = 0; column < 30; column++) {
                double deviations = toWall.at(row * 30 + column) / 0.04;
                double likelihood = deviations > 8 ? 0.2 : 0.8 * Math.exp(-deviations * deviations / 2) + 0.2;
                assertThat(field.log(-1 + (column + 0.5) * 0.1, 2 + (row + 0.5) * 0.1))
                        .as("column %d, row %d", column, row)
                        .isCloseTo(Math.log(likelihood), within(1e-6));
            }
        }
    }

    /// Rotation, offset and cells by hand, for single poses and for all particles at once.
    @Test
    void aBeamCountsWhereItEnds() {
        OccupancyGrid map = elsewhere();
        var field = new LikelihoodField(map, DistanceField.toOccupied(map), 0.1, 0.05);
        var random = new SplittableRandom(4);
        int many = 300;
        var particles = new Particles(many);
        for (int i = 0; i < many; i++) {
            particles.add(random.nextDouble(-0.8, 1.8), random.nextDouble(2.2, 3.8), random.nextDouble(-3, 3));
        }
        float[] beamX = {0.31f, -0.52f, 0.07f};
        float[] beamY = {0.13f, 0.24f, -0.65f};
        var beams = new Beams(beamX, beamY, new float[3], new float[3]);
        var logs = new double[many];
        field.logs(beams, particles, new PoseBlock(), logs);
        for (int i = 0; i < many; i++) {
            double cos = Math.cos(particles.theta[i]);
            double sin = Math.sin(particles.theta[i]);
            double sum = 0;
            boolean isOnAnEdge = false; // where rounding decides in which cell it ends
            for (int beam = 0; beam < 3; beam++) {
                double x = particles.x[i] + cos * beamX[beam] - sin * beamY[beam];
                double y = particles.y[i] + sin * beamX[beam] + cos * beamY[beam];
                sum += field.log(x, y);
                isOnAnEdge |=
                        Math.abs(Math.IEEEremainder(x, 0.1)) < 1e-4 || Math.abs(Math.IEEEremainder(y, 0.1)) < 1e-4;
            }
            if (!isOnAnEdge) {
                assertThat(field.log(beams, particles.x[i], particles.y[i], particles.theta[i]))
                        .isCloseTo(sum, within(1e-4));
                assertThat(logs[i]).isCloseTo(sum, within(1e-4));
            }
        }
    }

    @Test
    void cellsOutsideTheMapAreUnlikely() {
        assertThat(FIELD.logOf(9, 3)).isEqualTo((float) FIELD.log(0.95, 0.35)).isGreaterThan((float) FIELD.unlikely());
        for (int[] outside : new int[][] {
            {-1, 3}, {FIELD.width(), 3}, {9, -1}, {9, FIELD.height()}, {Integer.MAX_VALUE, Integer.MIN_VALUE}
        }) {
            assertThat(FIELD.logOf(outside[0], outside[1])).isEqualTo((float) FIELD.unlikely());
        }
    }
}
