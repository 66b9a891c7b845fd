package rsal.gazebo;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.BitSet;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import rsal.gazebo.RectangleCover.Cells;
import rsal.map.Maps;
import rsal.scene.SolidRaster;
import rsal.settings.FileSource;
import rsal.settings.Location;
import rsal.testkit.Rounds;

class RectangleCoverTest {
    private static List<Cells> cover(String drawn) {
        List<String> lines = drawn.lines().toList();
        int width = lines.getFirst().length();
        var solid = new BitSet();
        for (int row = 0; row < lines.size(); row++) {
            for (int column = 0; column < width; column++) {
                solid.set(row * width + column, lines.get(row).charAt(column) == '#');
            }
        }
        return RectangleCover.of(width, lines.size(), solid, 1_000);
    }

    @Test
    void aRoomTakesFourRectangles() {
        assertThat(cover("""
                ######
                #....#
                #....#
                ######""")).hasSize(4);
    }

    @Test
    void aCrossTakesTwo() {
        assertThat(cover("""
                .##.
                ####
                ####
                .##.""")).hasSize(2);
    }

    @Test
    void whatOthersCoverIsLeftOut() {
        assertThat(cover("""
                ##..
                ####
                ..##
                ..##""")).hasSize(2);
        assertThat(cover("....")).isEmpty();
    }

    @Test
    void allSolidCellsAreCoveredAndNoOthers() {
        for (long seed = 0; seed < Rounds.of(500, 50_000); seed++) {
            var random = new Random(seed);
            int width = 1 + random.nextInt(40);
            int height = 1 + random.nextInt(40);
            var solid = new BitSet();
            for (int cell = 0; cell < width * height; cell++) {
                solid.set(cell, random.nextInt(10) < seed % 10);
            }
            var covered = new BitSet();
            for (Cells cells : RectangleCover.of(width, height, solid, 2_000)) {
                for (int row = cells.row(); row < cells.row() + cells.rows(); row++) {
                    covered.set(row * width + cells.column(), row * width + cells.column() + cells.columns());
                }
            }
            assertThat(covered).as("seed " + seed).isEqualTo(solid);
        }
    }

    @Test
    void itGivesUpWhereThereAreTooMany() {
        var board = new BitSet();
        for (int cell = 0; cell < 100 * 101; cell += 2) {
            board.set(cell);
        }
        assertThat(RectangleCover.of(101, 100, board, 50)).hasSize(51);
    }

    /// How many boxes the walls of the office take.
    @Test
    void theOfficeTakesFew() {
        SolidRaster walls = SolidRaster.of(new Maps(FileSource.disk())
                .find("office", Location.of("office"))
                .grid());
        List<Cells> cover = RectangleCover.of(walls.width(), walls.height(), walls.solid(), 20_000);
        assertThat(walls.solid().cardinality()).isEqualTo(77_036);
        assertThat(cover).hasSize(191);
    }
}
