package rsal.map;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import rsal.data.OccupancyGrid;
import rsal.data.Pose2d;

class FreeSpaceTest {
    /// Two rooms, the right one larger, a door too narrow for a clearance of a cell and a half; one unknown cell.
    private static final OccupancyGrid ROOMS = grid("""
            ############
            #....#.....#
            #..........#
            #....#.....#
            #....#....?#
            ############""");

    @Test
    void isTheLargestPartOfAllThatIsFree() {
        assertThat(new FreeSpace(ROOMS, 0.5).area()).isEqualTo(4 * 4 + 1 + 4 * 5 - 1);
    }

    @Test
    void endsWhereRobotsDoNotFit() {
        var space = new FreeSpace(ROOMS, 1.5);
        assertThat(space.area()).isEqualTo(2 * 3 - 1);
        for (long seed = 0; seed < 100; seed++) {
            Pose2d place = space.choose(new SplittableRandom(seed), _ -> true).orElseThrow();
            assertThat(place.x()).as("seed %d", seed).isBetween(7.5, 9.5);
            assertThat(place.y()).as("seed %d", seed).isBetween(2.5, 3.5);
        }
    }

    @Test
    void givesWhatSuitsOrNothing() {
        var space = new FreeSpace(ROOMS, 0.5);
        assertThat(space.choose(new SplittableRandom(1), pose -> pose.x() < 2))
                .hasValueSatisfying(pose -> assertThat(pose.x()).isEqualTo(1.5));
        assertThat(space.choose(new SplittableRandom(1), _ -> false)).isEmpty();
        assertThat(new FreeSpace(ROOMS, 10).choose(new SplittableRandom(1), _ -> true))
                .isEmpty();
    }

    @Test
    void findsTheNearestPlace() {
        assertThat(new FreeSpace(ROOMS, 1.5).nearest(new Pose2d(0, 0, 1), _ -> true))
                .contains(new Pose2d(7.5, 2.5, 1));
    }

    private static OccupancyGrid grid(String drawing) {
        var lines = drawing.lines().toList();
        int width = lines.getFirst().length();
        var grid = new OccupancyGrid(width, lines.size(), 1, 0, 0, new byte[width * lines.size()]);
        for (int row = 0; row < lines.size(); row++) {
            for (int column = 0; column < width; column++) {
                grid.cells()[row * width + column] = switch (lines.get(lines.size() - 1 - row)
                        .charAt(column)) {
                    case '#' -> OccupancyGrid.OCCUPIED;
                    case '?' -> OccupancyGrid.UNKNOWN;
                    default -> OccupancyGrid.FREE;
                };
            }
        }
        return grid;
    }
}
