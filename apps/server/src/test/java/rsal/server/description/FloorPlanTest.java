package rsal.server.description;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import rsal.data.OccupancyGrid;
import rsal.data.Pose2d;
import rsal.data.Rgb;
import rsal.scene.Entity;
import rsal.scene.Scene;
import rsal.scene.SolidRaster;
import rsal.scene.Touch;
import rsal.testkit.DrawnMap;

class FloorPlanTest {
    private static final OccupancyGrid MAP = DrawnMap.grid(0.5, """
            #####
            #.#.#
            #####""").grid();

    /// @param walls row by row from below
    private static Scene scene(Optional<Rgb> color, List<Entity> things, String walls) {
        SolidRaster all = SolidRaster.of(MAP);
        var solid = new java.util.BitSet();
        for (int i = 0; i < walls.length(); i++) {
            solid.set(i, walls.charAt(i) == '#');
        }
        var surface = color.map(all.surface()::in).orElse(all.surface());
        var raster = new SolidRaster(5, 3, solid, all.left(), all.bottom(), 0.5, 0.5, 0, 1, true, surface);
        return scene(List.of(raster), things);
    }

    private static Scene scene(List<SolidRaster> walls, List<Entity> things) {
        return new Scene(
                "",
                MAP,
                Optional.empty(),
                Optional.empty(),
                Touch.STALL,
                walls,
                things,
                List.of(),
                Map.of(),
                Map.of(),
                Map.of(),
                Collections.emptySortedMap(),
                List.of(),
                List.of());
    }

    private static String drawn(byte[] cells) {
        var drawn = new StringBuilder();
        for (byte cell : cells) {
            drawn.append(cell == 0 ? '.' : cell == OccupancyGrid.OCCUPIED ? '#' : (char) (cell - 101 + 'a'));
        }
        return drawn.toString();
    }

    @Test
    void isTheMapWhereNothingCanMove() {
        assertThat(FloorPlan.cells(scene(Optional.empty(), List.of(), "###############")))
                .isEqualTo(MAP.cells());
    }

    @Test
    void leavesThingsOut() {
        var thing = new Entity("pillar", List.of(), Pose2d.ORIGIN, 0);
        assertThat(drawn(FloorPlan.cells(scene(Optional.empty(), List.of(thing), "######...######"))))
                .isEqualTo("######...######");
    }

    @Test
    void isAsHighAsItsWorldSays() {
        Scene said = scene(Optional.empty(), List.of(), "###############");
        assertThat(FloorPlan.height(said)).contains(1.0);
        Scene unsaid = scene(List.of(said.walls().getFirst(), SolidRaster.of(MAP)), List.of());
        assertThat(FloorPlan.height(unsaid)).isEmpty();
    }

    @Test
    void hasWallsInTheirColors() {
        Scene scene = scene(Optional.of(new Rgb(255, 0, 0)), List.of(), "######.#.######");
        assertThat(FloorPlan.colors(scene)).containsExactly(new Rgb(255, 0, 0));
        assertThat(drawn(FloorPlan.cells(scene))).isEqualTo("aaaaaa.a.aaaaaa");
    }
}
