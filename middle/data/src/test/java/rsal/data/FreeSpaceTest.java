package rsal.data;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class FreeSpaceTest {
    private static final OccupancyGrid MAP = grid("""
            ################?????
            #..............#.....
            #..............#.....
            #.........##...#.....
            #.........##.........
            #..............#.....
            #..............#?????
            ################?????""");

    @Test
    void choosesOnlyPlacesWithClearanceInTheLargestPart() {
        var space = new FreeSpace(MAP, 0.75);
        var random = new SplittableRandom(1);
        for (int i = 0; i < 200; i++) {
            Pose2d pose = space.choose(random, _ -> true).orElseThrow();
            assertThat(pose.x()).isBetween(1.25, 4.25); // the table leaves too little room to pass
            assertThat(pose.y()).isBetween(1.25, 2.75);
        }
    }

    @Test
    void withLessClearanceBothSidesOfADoorBelongTogether() {
        var space = new FreeSpace(MAP, 0.25);
        var random = new SplittableRandom(1);
        int east = 0;
        for (int i = 0; i < 200; i++) {
            east += space.choose(random, _ -> true).orElseThrow().x() > 8 ? 1 : 0;
        }
        assertThat(east).isBetween(20, 120);
    }

    @Test
    void narrowWaysConnectPlacesWithRoom() {
        var space = new FreeSpace(MAP, 0.75, 0.25);
        var random = new SplittableRandom(1);
        int east = 0;
        for (int i = 0; i < 200; i++) {
            Pose2d pose = space.choose(random, _ -> true).orElseThrow();
            assertThat(pose.x())
                    .satisfiesAnyOf(
                            x -> assertThat(x).isBetween(1.25, 6.75),
                            x -> assertThat(x).isGreaterThan(8.5));
            east += pose.x() > 8 ? 1 : 0;
        }
        assertThat(east).isBetween(20, 120);
    }

    @Test
    void findsTheNearestPlaceThatSuits() {
        var space = new FreeSpace(MAP, 0.75);
        assertThat(space.nearest(new Pose2d(0.1, 2, 1), _ -> true)).contains(new Pose2d(1.25, 1.75, 1));
        assertThat(space.nearest(new Pose2d(0.1, 2, 1), p -> p.x() > 4)).contains(new Pose2d(4.25, 1.75, 1));
        assertThat(space.nearest(new Pose2d(0.1, 2, 1), _ -> false)).isEmpty();
    }

    @Test
    void aMapWithoutRoomHasNoPlaces() {
        var space = new FreeSpace(grid("#.#"), 1);
        assertThat(space.choose(new SplittableRandom(1), _ -> true)).isEmpty();
    }

    private static OccupancyGrid grid(String drawing) {
        var lines = drawing.lines().toList();
        int width = lines.getFirst().length();
        var grid = new OccupancyGrid(width, lines.size(), 0.5, 0, 0, new byte[width * lines.size()]);
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
