package rsal.sim.world;

import rsal.data.DistanceTransform;
import rsal.data.OccupancyGrid;
import rsal.scene.Raster;
import rsal.scene.Surface;

/// Walls given as an upright grid of cells, some of which are solid: a map or a floor plan.
///
/// Each cell knows how far the nearest solid one is, so that rays and collision checks can skip the empty circle
/// around it.
public final class Walls {
    private static final byte SOLID = 0;
    private static final byte NEAR = 1; // touches a solid cell, if only with a corner
    private static final byte FAR = 2;
    private static final double UNITS_PER_CELL = 2;
    private static final int MOST = 0xFF;
    private static final double GUARD = 1e-6; // [cells]; more than rounding, so that no stride ends in a wall

    private final double cellX; // [m]
    private final double cellY;
    private final double least; // of the two
    private final double left; // of the fence, which is one cell wide
    private final double bottom;
    private final int width; // with the fence
    private final int height;
    private final boolean fenced;
    private final double lowest;
    private final double highest;
    private final Surface surface;
    private final double[] strides; // by room, what a ray may skip [m]
    private final byte[] room; // by cell: SOLID, NEAR, or NEAR + units from any point of it to anything solid, unsigned

    /// The walls of a map.
    public static Walls of(OccupancyGrid map) {
        return new Walls(Raster.of(map));
    }

    public Walls(Raster raster) {
        cellX = raster.cellX();
        cellY = raster.cellY();
        least = Math.min(cellX, cellY);
        left = raster.left() - cellX;
        bottom = raster.bottom() - cellY;
        width = raster.width() + 2;
        height = raster.height() + 2;
        fenced = raster.fenced();
        lowest = raster.lowest();
        highest = raster.highest();
        surface = raster.surface();
        strides = new double[MOST + 1];
        for (int i = 0; i < strides.length; i++) {
            strides[i] = empty(i) - GUARD * least;
        }
        room = new byte[Math.multiplyExact(width, height)];
        markSolid(raster);
        markNear();
        measureFar();
    }

    private void markSolid(Raster raster) {
        for (int row = 0; row < raster.height(); row++) {
            for (int column = 0; column < raster.width(); column++) {
                if (!raster.solid().get(row * raster.width() + column)) {
                    room[(row + 1) * width + column + 1] = FAR;
                }
            }
        }
    }

    private void markNear() {
        for (int row = 1; row < height - 1; row++) {
            for (int column = 1; column < width - 1; column++) {
                int cell = row * width + column;
                if (room[cell] == FAR && touchesSolid(column, row)) {
                    room[cell] = NEAR;
                }
            }
        }
    }

    private boolean touchesSolid(int column, int row) {
        for (int y = row - 1; y <= row + 1; y++) {
            if (room[y * width + column - 1] == SOLID
                    || room[y * width + column] == SOLID
                    || room[y * width + column + 1] == SOLID) {
                return true;
            }
        }
        return false;
    }

    /// Two cells are as far apart, from border to border, as the middle of one is from the middle of the nearest
    /// of those around the other.
    private void measureFar() {
        DistanceTransform.measure(width, height, cell -> room[cell] != FAR, (row, squares) -> {
            for (int column = 0; column < width; column++) {
                double cells = Math.sqrt(squares[column]);
                if (cells > 0) {
                    room[row * width + column] = (byte) Math.min(MOST, NEAR + (int) (cells * UNITS_PER_CELL));
                }
            }
        });
    }

    Surface surface() {
        return surface;
    }

    /// Underside above ground [m].
    double lowest() {
        return lowest;
    }

    /// Top above ground [m].
    double highest() {
        return highest;
    }

    boolean isAt(double z) {
        return lowest <= z && z < highest;
    }

    /// Without the fence.
    public Extent extent() {
        return new Extent(left + cellX, bottom + cellY, left + (width - 1) * cellX, bottom + (height - 1) * cellY);
    }

    /// Whether a place is in the grid and not in a wall.
    public boolean isFree(double x, double y) {
        return roomAt(x, y) != SOLID;
    }

    /// A distance [m] within which nothing is solid around a place; less than the true one by up to two cells.
    /// Negative in walls and outside the grid.
    double emptyAround(double x, double y) {
        int at = roomAt(x, y);
        return at == SOLID ? -least : empty(at);
    }

    /// [m]
    private double empty(int room) {
        return (room - NEAR) * (least / UNITS_PER_CELL);
    }

    private int roomAt(double x, double y) {
        double column = (x - left) / cellX;
        double row = (y - bottom) / cellY;
        boolean inside = column >= 0 && column < width && row >= 0 && row < height; // false for NaN
        return inside ? roomIn((int) column, (int) row) : SOLID;
    }

    private int roomIn(int column, int row) {
        return room[row * width + column] & 0xFF;
    }

    /// Ends rays at the border of the first solid cell, if that is within reach and they have met nothing before;
    /// at once inside a wall.
    ///
    /// Each strides across the empty circle around where it is (Hart, Sphere Tracing, 1996) until walls are near,
    /// then walks from cell to cell exactly (Amanatides and Woo, A Fast Voxel Traversal Algorithm, 1987). All
    /// take their strides in turns, so that while one waits for memory others go on.
    void end(Rays rays, double reach) {
        int[] under = rays.under; // in locals, as the compiler doesn't trust fields to stay
        double[] ways = rays.way;
        double[] limits = rays.limit;
        double[] columns = rays.column;
        double[] rows = rays.row;
        double[] columnsPerMeter = rays.columnsPerMeter;
        double[] rowsPerMeter = rays.rowsPerMeter;
        int count = begin(rays, reach);
        while (count > 0) {
            int still = 0;
            for (int k = 0; k < count; k++) {
                int i = under[k];
                double way = ways[i];
                int column = (int) (columns[i] + way * columnsPerMeter[i]);
                int row = (int) (rows[i] + way * rowsPerMeter[i]);
                int here = roomIn(column, row);
                way = here > NEAR ? way + strides[here] : walk(rays, i, way, column, row);
                if (way <= limits[i]) {
                    ways[i] = way;
                    under[still++] = i;
                }
            }
            count = still;
        }
    }

    private int begin(Rays rays, double reach) {
        double columnsPerMeter = 1 / cellX;
        double rowsPerMeter = 1 / cellY;
        for (int i = 0; i < rays.count; i++) {
            rays.column[i] = (rays.x[i] - left) * columnsPerMeter;
            rays.row[i] = (rays.y[i] - bottom) * rowsPerMeter;
            rays.columnsPerMeter[i] = rays.dx[i] * columnsPerMeter;
            rays.rowsPerMeter[i] = rays.dy[i] * rowsPerMeter;
            rays.limit[i] = Math.min(reach, rays.range[i]);
        }
        strideTogether(rays, reach);
        int under = 0;
        for (int i = 0; i < rays.count; i++) {
            double way = isInside(rays.column[i], rays.row[i]) ? rays.bunchWay[i / Rays.BUNCH] : toGrid(rays, i);
            if (way <= rays.limit[i]) {
                rays.way[i] = way;
                rays.under[under++] = i;
            }
        }
        return under;
    }

    private boolean isInside(double column, double row) {
        return column >= 1 && column < width - 1 && row >= 1 && row < height - 1; // false for NaN
    }

    /// Lets bunches of rays from one place go as far as the strides of their middle ones, each shorter by how far
    /// the others are beside it: cones, each of which is marched as one.
    private void strideTogether(Rays rays, double reach) {
        double worth = 2 * least;
        int under = beginTogether(rays);
        while (under > 0) {
            int still = 0;
            for (int k = 0; k < under; k++) {
                int bunch = rays.under[k];
                int middle = rays.middle(bunch);
                double way = rays.bunchWay[bunch];
                int column = (int) (rays.column[middle] + way * rays.columnsPerMeter[middle]);
                int row = (int) (rays.row[middle] + way * rays.rowsPerMeter[middle]);
                double stride = strides[roomIn(column, row)] - way * rays.bunchSpread[bunch];
                rays.bunchWay[bunch] = way + Math.max(0, stride);
                if (stride >= worth && way <= reach) {
                    rays.under[still++] = bunch;
                }
            }
            under = still;
        }
    }

    private int beginTogether(Rays rays) {
        int under = 0;
        for (int bunch = 0; bunch * Rays.BUNCH < rays.count; bunch++) {
            int middle = rays.middle(bunch);
            double widest = isInside(rays.column[middle], rays.row[middle]) ? 0 : Double.POSITIVE_INFINITY;
            for (int i = bunch * Rays.BUNCH; i < rays.end(bunch); i++) {
                double dx = rays.dx[i] - rays.dx[middle];
                double dy = rays.dy[i] - rays.dy[middle];
                boolean fromOnePlace = rays.x[i] == rays.x[middle] && rays.y[i] == rays.y[middle];
                widest = fromOnePlace ? Math.max(widest, dx * dx + dy * dy) : Double.POSITIVE_INFINITY;
            }
            rays.bunchWay[bunch] = 0;
            rays.bunchSpread[bunch] = Math.sqrt(widest);
            if (widest < 1) {
                rays.under[under++] = bunch;
            }
        }
        return under;
    }

    /// Way of a ray from outside until it is well in the first cell [m]; +∞ when it misses the grid.
    private double toGrid(Rays rays, int ray) {
        double enters = 0;
        double leaves = Double.POSITIVE_INFINITY;
        for (int axis = 0; axis < 2; axis++) {
            double at = axis == 0 ? rays.column[ray] : rays.row[ray];
            double speed = axis == 0 ? rays.columnsPerMeter[ray] : rays.rowsPerMeter[ray];
            double last = (axis == 0 ? width : height) - 1;
            if (speed == 0) {
                leaves = at >= 1 && at < last ? leaves : Double.NEGATIVE_INFINITY;
            } else {
                enters = Math.max(enters, ((speed > 0 ? 1 : last) - at) / speed);
                leaves = Math.min(leaves, ((speed > 0 ? last : 1) - at) / speed);
            }
        }
        double inside = enters + GUARD * least;
        return inside < leaves ? inside : Double.POSITIVE_INFINITY;
    }

    /// Goes from cell to cell while walls are near.
    ///
    /// @return how far it came [m]; +∞ when it has met a wall, noting its range, or the fence
    private double walk(Rays rays, int ray, double from, int fromColumn, int fromRow) {
        double limit = rays.limit[ray];
        double columnSpeed = rays.columnsPerMeter[ray];
        double rowSpeed = rays.rowsPerMeter[ray];
        double perColumn = columnSpeed == 0 ? Double.POSITIVE_INFINITY : 1 / columnSpeed;
        double perRow = rowSpeed == 0 ? Double.POSITIVE_INFINITY : 1 / rowSpeed;
        int stepColumn = columnSpeed >= 0 ? 1 : -1;
        int stepRow = rowSpeed >= 0 ? 1 : -1;
        double originColumn = rays.column[ray] - (columnSpeed >= 0 ? 1 : 0); // so that a cell is left at its number
        double originRow = rays.row[ray] - (rowSpeed >= 0 ? 1 : 0);
        int column = fromColumn;
        int row = fromRow;
        int here = roomIn(column, row);
        double way = here == SOLID ? Math.max(0, from - GUARD * least) : from; // as only [#begin] puts it into a wall
        while (here == NEAR && way <= limit) {
            double toColumn = (column - originColumn) * perColumn;
            double toRow = (row - originRow) * perRow;
            if (toColumn < toRow) {
                way = toColumn;
                column += stepColumn;
            } else {
                way = toRow;
                row += stepRow;
            }
            here = roomIn(column, row);
        }
        if (here > NEAR) {
            return way + GUARD * least; // or rounding might put it back
        }
        boolean atFence = column == 0 || column == width - 1 || row == 0 || row == height - 1;
        if (here == SOLID && way <= limit && !atFence) {
            rays.range[ray] = way;
            rays.met[ray] = Rays.WALL;
        }
        return Double.POSITIVE_INFINITY;
    }

    /// How far a piece is from walls, and from the fence if there is one [m]: at most the true distance (exact to
    /// a face, less to a corner), 0 or less when they overlap, `reach` when nothing is nearer than that.
    double separation(Piece piece, double reach) {
        if (!(surface.obstacle() && piece.isBetween(lowest, highest))) {
            return reach;
        }
        if (emptyAround(piece.x(), piece.y()) - piece.radius() >= reach) {
            return reach;
        }
        int firstColumn = column(piece.minX() - reach);
        int lastColumn = column(piece.maxX() + reach);
        int firstRow = row(piece.minY() - reach);
        int lastRow = row(piece.maxY() + reach);
        double nearest = fenced ? Math.min(reach, fromFence(piece)) : reach;
        for (int row = firstRow; row <= lastRow; row++) {
            int stride;
            for (int column = firstColumn; column <= lastColumn; column += stride) {
                int here = roomIn(column, row);
                stride = 1 + (int) ((Math.max(here, NEAR) - NEAR) / UNITS_PER_CELL);
                if (here == SOLID) {
                    double x = left + column * cellX;
                    double y = bottom + row * cellY;
                    nearest = Math.min(nearest, piece.separation(x, y, x + cellX, y + cellY));
                }
            }
        }
        return nearest;
    }

    private double fromFence(Piece piece) {
        Extent inside = extent();
        double fromSides = Math.min(piece.minX() - inside.left(), inside.right() - piece.maxX());
        double fromEnds = Math.min(piece.minY() - inside.bottom(), inside.top() - piece.maxY());
        return Math.min(fromSides, fromEnds);
    }

    private int column(double x) {
        return (int) Math.clamp(Math.floor((x - left) / cellX), fenced ? 0.0 : 1.0, width - (fenced ? 1.0 : 2.0));
    }

    private int row(double y) {
        return (int) Math.clamp(Math.floor((y - bottom) / cellY), fenced ? 0.0 : 1.0, height - (fenced ? 1.0 : 2.0));
    }
}
