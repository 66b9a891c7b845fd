package rsal.stage;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import rsal.data.Point2d;
import rsal.stage.SolidBody.Prism;
import rsal.stage.SolidBody.Raster;

/// What is solid of a model.
class SolidBodyTest {
    @Test
    void aModelIsABoxUnlessItSaysOtherwise() {
        assertThat(body("model ( size [2 1 3] )").prisms()).singleElement().satisfies(box -> {
            assertThat(corners(box)).containsExactly("-1.000 -0.500", "1.000 -0.500", "1.000 0.500", "-1.000 0.500");
            assertThat(box.heights()).isEqualTo(new ValueRange(0, 3));
            assertThat(box.color()).isEmpty();
        });
        assertThat(body("model ( noblocks 1 )").isEmpty()).isTrue();
        assertThat(body("model ( size [1 0 1] )").isEmpty()).isTrue();
    }

    @Test
    void sensorsHaveNoBodyUnlessTheySaySo() {
        for (String type : List.of("ranger", "blobfinder", "fiducial", "bumper")) {
            assertThat(body(type + " ( )").isEmpty()).as(type).isTrue();
        }
        assertThat(body("ranger ( block ( points 3 point[0] [0 0] point[1] [1 0] point[2] [0 1] ) )")
                        .prisms())
                .hasSize(1);
    }

    @Test
    void blocksTogetherFillTheSize() {
        SolidBody body = body("""
                model ( size [4 2 1]
                  block ( points 4 point[0] [10 10] point[1] [11 10] point[2] [11 11] point[3] [10 11] z [0 5] )
                  block ( points 3 point[0] [13 10] point[1] [14 10] point[2] [14 12] z [5 10] color "blue" )
                )
                """);
        assertThat(corners(body.prisms().get(0)))
                .containsExactly("-2.000 -1.000", "-1.000 -1.000", "-1.000 0.000", "-2.000 0.000");
        assertThat(body.prisms().get(0).heights()).isEqualTo(new ValueRange(0, 0.5));
        assertThat(corners(body.prisms().get(1))).containsExactly("1.000 -1.000", "2.000 -1.000", "2.000 1.000");
        assertThat(body.prisms().get(1).heights()).isEqualTo(new ValueRange(0.5, 1));
        assertThat(body.prisms().get(1).color()).contains(StageColor.BLUE);
    }

    @Test
    void blocksAboveTheGroundStayThere() {
        String block = "block ( points 3 point[0] [0 0] point[1] [1 0] point[2] [0 1] z [1 3] )";
        assertThat(body("model ( size [1 1 4] %s )".formatted(block))
                        .prisms()
                        .getFirst()
                        .heights())
                .isEqualTo(new ValueRange(2, 6));
        assertThat(body("model ( size [1 1 4] %s )".formatted(block.replace(" z [1 3]", "")))
                        .prisms()
                        .getFirst()
                        .heights())
                .isEqualTo(new ValueRange(0, 4));
    }

    @Test
    void outlinesAreCounterClockwise() {
        assertThat(corners(body("""
                        model ( size [2 2 1] block ( points 3 point[0] [0 0] point[1] [0 1] point[2] [1 0] ) )
                        """).prisms().getFirst()))
                .containsExactly("1.000 -1.000", "-1.000 1.000", "-1.000 -1.000");
    }

    @Test
    void aBlockOfTwoPointsIsAWall() {
        assertThat(corners(body("model ( size [2 5 1] block ( points 2 point[0] [0 3] point[1] [7 3] ) )")
                        .prisms()
                        .getFirst()))
                .containsExactly("-1.000 0.000", "1.000 0.000");
    }

    @Test
    void anOriginMovesAndTurnsTheBody() {
        Prism box = body("model ( size [2 1 1] origin [1 0 0.5 90] )").prisms().getFirst();
        assertThat(corners(box)).containsExactly("1.500 -1.000", "1.500 1.000", "0.500 1.000", "0.500 -1.000");
        assertThat(box.heights()).isEqualTo(new ValueRange(0.5, 1.5));
    }

    @Test
    void aBoundaryIsFourWallsInsideOfTheSize() {
        List<Prism> walls = body("model ( size [2 1 0.5] boundary 1 )").prisms();
        assertThat(walls)
                .hasSize(4)
                .allSatisfy(wall -> assertThat(wall.heights()).isEqualTo(new ValueRange(0, 0.5)));
        assertThat(walls.stream().mapToDouble(SolidBodyTest::area).sum()).isCloseTo(2 * 1 - 1.98 * 0.98, within(1e-9));
        assertThat(solid(walls, -0.999, 0)).isTrue();
        assertThat(solid(walls, 0.999, 0)).isTrue();
        assertThat(solid(walls, 0, 0.499)).isTrue();
        assertThat(solid(walls, 0, -0.499)).isTrue();
        assertThat(solid(walls, 0, 0)).isFalse();
    }

    @Test
    void aSmallBitmapBecomesRectangles() {
        List<Prism> prisms = Worlds.of("model ( size [5 4 2] bitmap \"plan.pgm\" boundary 0 )")
                .andImage("plan.pgm", """
                        #####
                        #...#
                        #.#.#
                        ###.#""")
                .model()
                .traits()
                .body()
                .prisms();
        assertThat(prisms).allSatisfy(prism -> assertThat(prism.heights()).isEqualTo(new ValueRange(0, 2)));
        assertThat(drawn(prisms, 5, 4)).isEqualTo("""
                #####
                #...#
                #.#.#
                ###.#""");
    }

    @Test
    void aBitmapIsTrimmedToWhatIsSolid() {
        List<Prism> prisms = Worlds.of("model ( size [3 2 1] bitmap \"plan.pgm\" )")
                .andImage("plan.pgm", """
                        ......
                        ..#...
                        ..###.
                        ......""")
                .model()
                .traits()
                .body()
                .prisms();
        assertThat(drawn(prisms, 3, 2)).isEqualTo("#..\n###");
    }

    @Test
    void aLargeBitmapStaysARaster() {
        var lines = new ArrayList<String>();
        for (int row = 0; row < 200; row++) {
            lines.add((row % 2 == 0 ? "#." : ".#").repeat(100));
        }
        SolidBody body = Worlds.of("model ( size [20 40 1] origin [1 0 0.5 90] bitmap \"plan.pgm\" boundary 1 )")
                .andImage("plan.pgm", String.join("\n", lines))
                .model()
                .traits()
                .body();
        assertThat(body.prisms()).hasSize(4);
        Raster raster = body.raster().orElseThrow();
        assertThat(raster.bitmap().width()).isEqualTo(200);
        assertThat(raster.bitmap().isSolid(0, 199)).isTrue();
        assertThat(raster.bitmap().isSolid(0, 198)).isFalse();
        assertThat(raster.bitmap().isSolid(-1, 0)).isFalse();
        assertThat(raster.cellLength()).isEqualTo(0.1);
        assertThat(raster.cellWidth()).isEqualTo(0.2);
        assertThat(raster.heights()).isEqualTo(new ValueRange(0.5, 1.5));
        Point2d corner = raster.modelFromCorner().position();
        assertThat("%.3f %.3f".formatted(corner.x(), corner.y())).isEqualTo("21.000 -10.000");
        assertThat(raster.modelFromCorner().theta()).isEqualTo(Math.PI / 2);
    }

    @Test
    void modelsOfOneBitmapShareIt() {
        var worlds = Worlds.of("define m model ( bitmap \"plan.pgm\" )\nm ( mass 1 ) m ( mass 2 )")
                .andImage("plan.pgm", (".#".repeat(75) + "\n" + "#.".repeat(75) + "\n").repeat(75));
        List<StageModel> models = worlds.models();
        assertThat(models.get(0).traits().body().raster().orElseThrow().bitmap())
                .isSameAs(models.get(1).traits().body().raster().orElseThrow().bitmap());
    }

    @Test
    void anImageWithoutDarkPixelsIsWarnedOf() {
        var worlds = Worlds.of("model ( bitmap \"plan.pgm\" )").andImage("plan.pgm", "...");
        assertThat(worlds.model().traits().body().isEmpty()).isTrue();
        assertThat(worlds.warnings())
                .containsExactly("test.world:1:9: Image 'plan.pgm' has no dark pixel, so nothing of it is solid.");
    }

    private static SolidBody body(String text) {
        return Worlds.of(text).model().traits().body();
    }

    private static List<String> corners(Prism prism) {
        return prism.outline().stream()
                .map(c -> "%.3f %.3f".formatted(c.x() + 0.0, c.y() + 0.0).replace("-0.000", "0.000"))
                .toList();
    }

    private static double area(Prism prism) {
        double area = 0;
        for (int i = 0; i < prism.outline().size(); i++) {
            Point2d a = prism.outline().get(i);
            Point2d b = prism.outline().get((i + 1) % prism.outline().size());
            area += (a.x() * b.y() - b.x() * a.y()) / 2;
        }
        return area;
    }

    /// Whether a place is in one of several upright rectangles.
    private static boolean solid(List<Prism> prisms, double x, double y) {
        return prisms.stream().anyMatch(prism -> {
            Point2d low = prism.outline().get(0);
            Point2d high = prism.outline().get(2);
            return x > low.x() && x < high.x() && y > low.y() && y < high.y();
        });
    }

    /// A body of cells of a meter.
    private static String drawn(List<Prism> prisms, int width, int height) {
        var lines = new ArrayList<String>();
        for (int row = height - 1; row >= 0; row--) {
            var line = new StringBuilder();
            for (int column = 0; column < width; column++) {
                line.append(solid(prisms, column + 0.5 - width / 2.0, row + 0.5 - height / 2.0) ? '#' : '.');
            }
            lines.add(line.toString());
        }
        return String.join("\n", lines);
    }
}
