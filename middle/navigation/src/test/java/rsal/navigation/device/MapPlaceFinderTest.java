package rsal.navigation.device;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import org.junit.jupiter.api.Test;
import rsal.data.OccupancyGrid;
import rsal.data.PlaceObjective;
import rsal.data.Point2d;
import rsal.navigation.rooms.RandomFloor;
import rsal.navigation.spread.ReachableSpace;
import rsal.navigation.spread.TeamPlaces;

/// What robots of a team share.
class MapPlaceFinderTest {
    private static final double CLEARANCE = 0.4; // m

    /// Two rooms without a door between them.
    private static final OccupancyGrid MAP = new RandomFloor(12.6, 5.4)
            .room(0.2, 0.2, 6.2, 5.2)
            .room(6.4, 0.2, 12.4, 5.2)
            .paint(0.1, 0)
            .map();

    private static List<Point2d> ask(MapPlaceFinder.Kept kept, Point2d start, int count, PlaceObjective objective) {
        return kept.chosen(MAP, CLEARANCE, start, count, objective);
    }

    @Test
    void anAnswerIsComputedOnceForEachNumberAndObjective() {
        var kept = new MapPlaceFinder.Kept();
        List<Point2d> first = ask(kept, new Point2d(2, 2), 3, PlaceObjective.APART);

        assertThat(ask(kept, new Point2d(5, 4), 3, PlaceObjective.APART)).isSameAs(first);
        assertThat(ask(kept, new Point2d(2, 2), 4, PlaceObjective.APART)).hasSize(4);
        assertThat(ask(kept, new Point2d(2, 2), 3, PlaceObjective.NEAR))
                .isEqualTo(new TeamPlaces(ReachableSpace.around(MAP, CLEARANCE, new Point2d(2, 2)))
                        .choose(3, PlaceObjective.NEAR));
        assertThat(ask(kept, new Point2d(2, 2), 3, PlaceObjective.APART)).isSameAs(first);
    }

    @Test
    void aRobotNearerToAWallThanTheClearanceHasTheAnswerOfTheOthers() {
        var kept = new MapPlaceFinder.Kept();
        List<Point2d> first = ask(kept, new Point2d(2, 2), 3, PlaceObjective.APART);

        assertThat(ask(kept, new Point2d(6, 0.3), 3, PlaceObjective.APART)).isSameAs(first);
    }

    @Test
    void aRobotInAnotherPartOfTheMapHasPlacesThere() {
        var kept = new MapPlaceFinder.Kept();
        ask(kept, new Point2d(2, 2), 3, PlaceObjective.APART);

        for (Point2d start : List.of(new Point2d(8, 2), new Point2d(6.5, 2))) {
            assertThat(ask(kept, start, 3, PlaceObjective.APART)).allMatch(place -> place.x() > 6.3);
        }
        assertThatThrownBy(() -> ask(kept, new Point2d(2, 20), 3, PlaceObjective.APART))
                .isInstanceOf(IllegalArgumentException.class);
    }
}
