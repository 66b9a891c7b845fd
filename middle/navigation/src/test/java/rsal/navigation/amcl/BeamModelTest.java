package rsal.navigation.amcl;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
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
    void aBeamThatLeavesTheMapTellsNothingWhereverItEnds() {
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
}
