package rsal.agents.patrol.strategy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import rsal.agent.StrategyComparison;
import rsal.data.Point2d;

class GraphFileTest {
    /// Three places on a corner, 10 and 20 pixels apart.
    private static final String PLACES = """
            0
            10 20
            1
            1 E 10

            1
            20 20
            2
            0 W 10
            2 N 20

            2
            20 40
            1
            1 S 20
            """;

    private static final String HEADER = "3\n100\n80\n0.5\n";

    @Test
    void placesAndEdgesAreInMeters() {
        GraphFile file = GraphFile.read(HEADER + "-5\n2\n\n" + PLACES);
        assertThat(file.mapFromPlaces()).containsExactly(new Point2d(0, 12), new Point2d(5, 12), new Point2d(5, 22));
        PatrolGraph graph = file.graph(1, 0);
        assertThat(graph.length(0, 2)).isEqualTo(15);
        assertThat(graph.neighborsOf(0)).containsExactly(1);
    }

    @Test
    void offsetMayBeMissing() {
        GraphFile file = GraphFile.read(HEADER + PLACES);
        assertThat(file.mapFromPlaces()).containsExactly(new Point2d(5, 10), new Point2d(10, 10), new Point2d(10, 20));
    }

    @Test
    void errorsNameThePlaceAndTheValue() {
        assertThatThrownBy(() -> GraphFile.read(" \n")).hasMessageContaining("empty");
        assertThatThrownBy(() -> GraphFile.read("0")).hasMessageContaining("number of places is '0'");
        assertThatThrownBy(() -> GraphFile.read(HEADER + "0 0\n" + PLACES + "3"))
                .hasMessageContaining("After the last place 2 there is '3'");
        assertThatThrownBy(() -> GraphFile.read(HEADER + "0 0\n" + PLACES.replace("2 N 20", "7 N 20")))
                .hasMessageContaining("neighbor 2 of place 1 is '7'");
        assertThatThrownBy(() -> GraphFile.read(HEADER + "0 0\n" + PLACES.replace("2 N 20", "2 N x")))
                .hasMessageContaining("length of edge 2 of place 1 is 'x'");
        assertThatThrownBy(() -> GraphFile.read(HEADER + "0 0\n" + PLACES.replace("2 N 20", "2 north 20")))
                .hasMessageContaining("'north'");
        assertThatThrownBy(() -> GraphFile.read(HEADER + "0 0\n" + PLACES.replace("1 E 10", "0 E 10")))
                .hasMessageContaining("itself");
        assertThatThrownBy(() -> GraphFile.read(HEADER + "0 0\n0 10")).hasMessageContaining("ends before the y");
        assertThatThrownBy(() -> GraphFile.read("9".repeat(2_000_000))).hasMessageContaining("1000000 characters");
    }

    @Test
    void errorIsThatOfTheWayThatGotFurther() {
        assertThatThrownBy(() -> GraphFile.read(HEADER + PLACES.replace("1 S 20", "1 S far")))
                .hasMessageContaining("length of edge 1 of place 2 is 'far'");
    }

    @Test
    void comparisonRefusesAGraphInPieces() {
        String text = HEADER + "0 0\n"
                + PLACES.replace("2\n0 W 10\n2 N 20", "1\n0 W 10").replace("1\n1 S 20", "0");
        var team = new StrategyComparison.Team(List.of(2), 1, 0, 1, 100);
        assertThat(GraphFile.read(text).mapFromPlaces()).hasSize(3);
        assertThatThrownBy(() -> new GraphComparison().compare(text, List.of("cr"), team))
                .hasMessageContaining("Place '2' can't be reached");
    }

    @Test
    void anyTextIsReadOrRefused() {
        String valid = HEADER + "0 0\n" + PLACES;
        String letters = "0123456789 .-eENSWx\n";
        for (int seed = 0; seed < (Boolean.getBoolean("rsal.test.all") ? 1_000_000 : 5000); seed++) {
            var random = new SplittableRandom(seed);
            var text = new StringBuilder(valid);
            for (int i = random.nextInt(5); i >= 0; i--) {
                int at = random.nextInt(text.length());
                switch (random.nextInt(3)) {
                    case 0 -> text.setCharAt(at, letters.charAt(random.nextInt(letters.length())));
                    case 1 -> text.deleteCharAt(at);
                    default -> text.insert(at, letters.charAt(random.nextInt(letters.length())));
                }
            }
            try {
                PatrolGraph graph = GraphFile.read(text.toString()).graph(1, 0);
                assertThat(graph.size()).isBetween(1, PatrolGraph.MOST);
            } catch (IllegalArgumentException e) {
                assertThat(e.getMessage()).as("seed %d", seed).endsWith(".");
            }
        }
    }
}
