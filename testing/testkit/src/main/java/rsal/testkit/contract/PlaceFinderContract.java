package rsal.testkit.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import rsal.data.OccupancyGrid;
import rsal.data.PlaceObjective;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.device.PlaceFinder;

/// What every [PlaceFinder] owes.
public abstract class PlaceFinderContract extends DeviceContract<PlaceFinder> {
    private static final double CLEARANCE = 0.5; // m

    protected PlaceFinderContract() {
        super(PlaceFinder.class);
    }

    @ParameterizedTest
    @EnumSource(PlaceObjective.class)
    void findsAsManyPlacesAsAreAskedForThatKeepClearOfWallsAndOfEachOther(PlaceObjective objective) {
        for (int count : new int[] {1, 2, 7}) {
            PlaceFinder.Result result = await(device().find(START, count, CLEARANCE, objective));
            assertThat(result).isInstanceOf(PlaceFinder.Result.Found.class);
            List<Point2d> places = ((PlaceFinder.Result.Found) result).mapFromPlaces();
            assertThat(places).hasSize(count);
            for (int i = 0; i < count; i++) {
                assertThat(room(places.get(i))).as("%s", places.get(i)).isGreaterThanOrEqualTo(CLEARANCE);
                for (Point2d before : places.subList(0, i)) {
                    assertThat(places.get(i).distanceTo(before)).isGreaterThanOrEqualTo(2 * CLEARANCE);
                }
            }
        }
    }

    @Test
    void spreadsThemOverAllThatCanBeReached() {
        List<Point2d> places = places(START, 6);
        for (char corner : new char[] {'@', 'a', 'b', 'c', 'w'}) {
            assertThat(places).as("from %s", corner).anyMatch(place -> place.distanceTo(WORLD.place(corner)) < 6);
        }
    }

    @Test
    void noPlaceIsWhereNoWayLeadsFromTheStart() {
        assertThat(places(START, 12)).noneMatch(place -> place.distanceTo(WORLD.place('x')) < 0.8);
        assertThat(find(WORLD.pose('x', 0), 1, 0.3))
                .isInstanceOfSatisfying(
                        PlaceFinder.Result.Found.class,
                        found -> assertThat(found.mapFromPlaces())
                                .allMatch(place -> place.distanceTo(WORLD.place('x')) < 0.8));
    }

    @Test
    void theSameQuestionHasTheSameAnswer() {
        List<Point2d> first = places(START, 5);
        places(WORLD.pose('a', 90), 3);
        find(WORLD.pose('x', 0), 1, 0.3);
        assertThat(places(START, 5)).isEqualTo(first);
    }

    @Test
    void saysWhyThereAreNone() {
        assertNone(START, 0, CLEARANCE);
        assertNone(START, 10_000, CLEARANCE);
        assertNone(START, 1, 20);
        assertNone(START, 1, -1);
        assertNone(START, 1, Double.NaN);
        assertNone(new Pose2d(-50, 3, 0), 1, CLEARANCE);
        assertNone(new Pose2d(1e9, 1e9, 0), 1, CLEARANCE);
        assertNone(new Pose2d(Double.NaN, 0, 0), 1, CLEARANCE);
    }

    @Test
    void askingMovesNothing() {
        Pose2d before = truth();
        find(START, 4, CLEARANCE);
        advance(2);
        assertThat(truth()).isEqualTo(before);
    }

    private PlaceFinder.Result find(Pose2d start, int count, double clearance) {
        return await(device().find(start, count, clearance));
    }

    private List<Point2d> places(Pose2d start, int count) {
        PlaceFinder.Result result = find(start, count, CLEARANCE);
        assertThat(result).isInstanceOf(PlaceFinder.Result.Found.class);
        return ((PlaceFinder.Result.Found) result).mapFromPlaces();
    }

    private void assertNone(Pose2d start, int count, double clearance) {
        assertThat(find(start, count, clearance))
                .isInstanceOfSatisfying(
                        PlaceFinder.Result.None.class,
                        none -> assertThat(none.why()).isNotBlank());
    }

    /// To the next cell that is not free [m].
    private static double room(Point2d place) {
        OccupancyGrid map = WORLD.grid();
        double least = Double.POSITIVE_INFINITY;
        for (int cell = 0; cell < map.cells().length; cell++) {
            if (map.cells()[cell] != OccupancyGrid.FREE) {
                Point2d middle = map.middle(cell);
                double side = map.resolution() / 2;
                double x = Math.max(0, Math.abs(place.x() - middle.x()) - side);
                double y = Math.max(0, Math.abs(place.y() - middle.y()) - side);
                least = Math.min(least, Math.hypot(x, y));
            }
        }
        return least + 1e-9;
    }
}
