package rsal.navigation.amcl;

import java.util.ArrayList;
import rsal.data.LaserScan;
import rsal.data.OccupancyGrid;
import rsal.data.Pose2d;
import rsal.data.RangeArray;
import rsal.testkit.DrawnMap;
import rsal.testkit.ObviousRays;

/// What a laser sees in a drawn map.
final class Seen {
    private static final int FINE = 5; // cells in a sign, along each side
    private static final int RAYS_ASIDE = 5; // of the middle of a cone

    /// A room like no other, some 10 m × 5 m.
    static final DrawnMap ROOM = fine("""
            ########################################
            #......................................#
            #......................................#
            #..........................#...........#
            #..........a...............#...........#
            #..........................#...........#
            #..........................#......k....#
            #..................#########...........#
            #......................................#
            #......................................#
            #......##..............................#
            #......##..............................#
            #................b.....................#
            #......................................#
            #..................................#####
            #..................................#####
            ########################################
            """);

    /// The left end of a corridor, of which the rest was cut off.
    static final DrawnMap CUT_OFF = DrawnMap.grid(0.1, """
            ##########
            #.........
            #....@....
            #.........
            ##########""");

    static final Beams NOTHING = new Beams(new float[0], new float[0], new float[0], new float[0]);

    private final OccupancyGrid map;
    private final ObviousRays rays;

    /// A hall with walls of one cell all around, in cells of 0.1 m.
    ///
    /// @param x of its lower left corner in the map [m]
    /// @param y likewise
    /// @param inside cells with a wall besides, row by row
    static OccupancyGrid hall(int columns, int rows, double x, double y, int... inside) {
        byte[] cells = new byte[columns * rows];
        for (int cell = 0; cell < cells.length; cell++) {
            int column = cell % columns;
            int row = cell / columns;
            boolean isWall = row == 0 || column == 0 || row == rows - 1 || column == columns - 1;
            cells[cell] = isWall ? OccupancyGrid.OCCUPIED : OccupancyGrid.FREE;
        }
        for (int cell : inside) {
            cells[cell] = OccupancyGrid.OCCUPIED;
        }
        return new OccupancyGrid(columns, rows, 0.1, x, y, cells);
    }

    /// A map drawn with signs of 0.25 m, in cells of 0.05 m.
    static DrawnMap fine(String drawing) {
        DrawnMap drawn = DrawnMap.grid(0.25, drawing);
        OccupancyGrid coarse = drawn.grid();
        int width = FINE * coarse.width();
        var cells = new byte[FINE * coarse.height() * width];
        for (int i = 0; i < cells.length; i++) {
            cells[i] = coarse.at(i % width / FINE, i / width / FINE);
        }
        return new DrawnMap(
                new OccupancyGrid(width, FINE * coarse.height(), coarse.resolution() / FINE, 0, 0, cells),
                drawn.places());
    }

    Seen(DrawnMap map) {
        this.map = map.grid();
        rays = new ObviousRays(map.grid());
    }

    /// Beams that end ahead of the base or behind it.
    ///
    /// @param x where, in the base frame [m]
    static Beams straight(float... x) {
        return new Beams(x, new float[x.length], new float[x.length], new float[x.length]);
    }

    boolean isFree(Pose2d mapFromBase) {
        return map.isFree(mapFromBase.x(), mapFromBase.y());
    }

    /// All around, up to 8 m.
    Beams beams(Pose2d mapFromBase, int count) {
        return beams(mapFromBase, 8, count);
    }

    /// Of a ring of sonars, each a cone of 30° in which the nearest wall counts, up to 5 m.
    Beams sonars(Pose2d mapFromBase, int count) {
        double cone = Math.toRadians(30);
        var mounts = new ArrayList<Pose2d>();
        var ranges = new float[count];
        for (int i = 0; i < count; i++) {
            Pose2d mount = new Pose2d(0, 0, i * 2 * Math.PI / count).compose(new Pose2d(0.2, 0, 0));
            mounts.add(mount);
            double nearest = Double.POSITIVE_INFINITY;
            for (int ray = -RAYS_ASIDE; ray <= RAYS_ASIDE; ray++) {
                Pose2d along = mount.compose(new Pose2d(0, 0, ray * cone / 2 / RAYS_ASIDE));
                nearest = Math.min(nearest, rays.range(mapFromBase.compose(along)));
            }
            ranges[i] = (float) nearest;
        }
        return Beams.of(new RangeArray(mounts, cone, 0, 5, ranges), 5);
    }

    /// @param reach beyond which nothing is seen [m]
    Beams beams(Pose2d mapFromBase, double reach, int count) {
        var ranges = new float[count];
        double increment = 2 * Math.PI / count;
        for (int i = 0; i < count; i++) {
            ranges[i] = (float) rays.range(mapFromBase.compose(new Pose2d(0, 0, i * increment)));
        }
        return Beams.of(new LaserScan(Pose2d.ORIGIN, 0, increment, 0, reach, ranges), count, reach);
    }
}
