package rsal.navigation.explore;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;

class FrontiersTest {
    /// Cells of 0.5 m: `.` free, `#` occupied, blank unknown; the last line is the lowest row.
    private static OccupancyGrid grid(String drawn) {
        List<String> lines = drawn.lines().toList();
        int width = lines.getFirst().length();
        var cells = new byte[width * lines.size()];
        for (int row = 0; row < lines.size(); row++) {
            for (int column = 0; column < width; column++) {
                cells[row * width + column] =
                        switch (lines.get(lines.size() - 1 - row).charAt(column)) {
                            case '.' -> OccupancyGrid.FREE;
                            case '#' -> OccupancyGrid.OCCUPIED;
                            default -> OccupancyGrid.UNKNOWN;
                        };
            }
        }
        return new OccupancyGrid(width, lines.size(), 0.5, 0, 0, cells);
    }

    @Test
    void aFrontierIsWhereTheFreeMeetsTheUnknown() {
        List<Frontier> frontiers = Frontiers.of(grid("""
                ########
                #....???
                #....???
                #....???
                ########"""), 1);

        assertThat(frontiers).containsExactly(new Frontier(new Point2d(2.25, 1.25), 1.5));
    }

    @Test
    void aMapWithoutUnknownCellsBesideFreeOnesIsDone() {
        assertThat(Frontiers.of(grid("""
                ?????
                ?###?
                ?#.#?
                ?###?"""), 0.1)).isEmpty();
    }

    @Test
    void gapsThatAreTooShortAreLeftOut() {
        OccupancyGrid map = grid("""
                ######
                #.....
                ######""");

        assertThat(Frontiers.of(map, 0.5)).hasSize(1); // the map ends there
        assertThat(Frontiers.of(map, 1)).isEmpty();
    }

    @Test
    void longOnesAreCutSoThatRobotsMayShareThem() {
        String row = ".".repeat(20);

        List<Frontier> frontiers = Frontiers.of(grid("?".repeat(20) + "\n" + row + "\n" + "#".repeat(20)), 0.5);

        assertThat(frontiers).hasSizeGreaterThan(2);
        assertThat(frontiers.stream().mapToDouble(Frontier::length).sum()).isEqualTo(10);
    }
}
