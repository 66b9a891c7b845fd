package rsal.navigation.passage;

import rsal.data.OccupancyGrid;
import rsal.navigation.grid.DistanceField;
import rsal.navigation.wavefront.CostMap;
import rsal.navigation.wavefront.CostMap.Clearance;

/// Maps that are drawn, at 5 cm a cell, and their passages for a robot like a Pioneer 2-DX.
public final class DrawnMaps {
    public static final double BODY = 0.32; // m
    static final double LEAST = 0.29; // m

    /// Two rooms of 4 m × 3.6 m, with a door of 0.8 m in a wall of 0.2 m.
    public static final OccupancyGrid DOOR = of(0.2, """
            ###########################################
            #....................#....................#
            #....................#....................#
            #....................#....................#
            #....................#....................#
            #....................#....................#
            #....................#....................#
            #....................#....................#
            #.........................................#
            #.........................................#
            #.........................................#
            #.........................................#
            #....................#....................#
            #....................#....................#
            #....................#....................#
            #....................#....................#
            #....................#....................#
            #....................#....................#
            ###########################################""");

    private DrawnMaps() {}

    /// @param side of a drawn character [m], a multiple of 0.05
    public static OccupancyGrid of(double side, String drawing) {
        String[] lines = drawing.strip().split("\n", -1);
        int factor = (int) Math.round(side / 0.05);
        int width = lines[0].length() * factor;
        int height = lines.length * factor;
        var cells = new byte[width * height];
        for (int cell = 0; cell < cells.length; cell++) {
            int row = height - 1 - cell / width;
            boolean wall = lines[row / factor].charAt(cell % width / factor) == '#';
            cells[cell] = wall ? OccupancyGrid.OCCUPIED : OccupancyGrid.FREE;
        }
        return new OccupancyGrid(width, height, 0.05, 0, 0, cells);
    }

    static CostMap open(OccupancyGrid map) {
        return CostMap.of(map, DistanceField.toNotFree(map), new Clearance(LEAST, LEAST, 0));
    }

    public static Passages passages(OccupancyGrid map) {
        return Passages.of(open(map), DistanceField.toNotFree(map), BODY);
    }
}
