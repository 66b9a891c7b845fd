package rsal.server.description;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import rsal.data.OccupancyGrid;
import rsal.data.Rgb;
import rsal.scene.Scene;
import rsal.scene.SolidRaster;
import rsal.scene.Surface;

/// What the page's floor looks like: the map that robots know, without the things, which may move, and with walls in
/// their colors.
public final class FloorPlan {
    private static final int MOST_COLORS = 100;

    private FloorPlan() {}

    /// Of walls, as far as their world gives them any.
    static List<Rgb> colors(Scene scene) {
        return scene.walls().stream()
                .map(raster -> raster.surface().color())
                .filter(color -> !color.equals(Surface.PLAIN.color()))
                .distinct()
                .limit(MOST_COLORS)
                .toList();
    }

    /// How high the highest walls are above the floor [m]; empty where heights don't matter.
    static Optional<Double> height(Scene scene) {
        return scene.walls().stream()
                .map(SolidRaster::highest)
                .max(Comparator.naturalOrder())
                .filter(Double::isFinite);
    }

    /// As [rsal.server.message.Messages.MapInfo] has them.
    public static byte[] cells(Scene scene) {
        OccupancyGrid map = scene.map();
        List<Rgb> colors = colors(scene);
        if (colors.isEmpty() && scene.things().isEmpty()) {
            return map.cells();
        }
        byte[] cells = map.cells().clone();
        List<SolidRaster> walls = scene.walls().reversed(); // the last is on top
        for (int row = 0; row < map.height(); row++) {
            for (int column = 0; column < map.width(); column++) {
                int at = row * map.width() + column;
                if (cells[at] == OccupancyGrid.OCCUPIED) {
                    cells[at] = cell(walls, colors, map, column, row);
                }
            }
        }
        return cells;
    }

    private static byte cell(List<SolidRaster> walls, List<Rgb> colors, OccupancyGrid map, int column, int row) {
        double left = map.originX() + column * map.resolution();
        double bottom = map.originY() + row * map.resolution();
        for (SolidRaster wall : walls) {
            if (isSolid(wall, left, bottom, map.resolution())) {
                return (byte) (OccupancyGrid.OCCUPIED
                        + 1
                        + colors.indexOf(wall.surface().color()));
            }
        }
        return OccupancyGrid.FREE;
    }

    /// Whether there is a solid cell in a square.
    private static boolean isSolid(SolidRaster wall, double left, double bottom, double side) {
        double hair = side / 100; // cells that only touch are not in it
        int firstColumn = Math.max(0, (int) Math.floor((left + hair - wall.left()) / wall.cellX()));
        int lastColumn =
                Math.min(wall.width() - 1, (int) Math.floor((left + side - hair - wall.left()) / wall.cellX()));
        int firstRow = Math.max(0, (int) Math.floor((bottom + hair - wall.bottom()) / wall.cellY()));
        int lastRow =
                Math.min(wall.height() - 1, (int) Math.floor((bottom + side - hair - wall.bottom()) / wall.cellY()));
        for (int row = firstRow; row <= lastRow && firstColumn <= lastColumn; row++) {
            int next = wall.solid().nextSetBit(row * wall.width() + firstColumn);
            if (next >= 0 && next <= row * wall.width() + lastColumn) {
                return true;
            }
        }
        return false;
    }
}
