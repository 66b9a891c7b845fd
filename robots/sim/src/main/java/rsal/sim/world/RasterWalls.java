package rsal.sim.world;

import java.util.concurrent.atomic.AtomicLong;
import org.jspecify.annotations.Nullable;
import rsal.data.DistanceTransform;
import rsal.data.OccupancyGrid;
import rsal.scene.SolidRaster;
import rsal.scene.Surface;

/// Walls given as an upright grid of cells, some of which are solid: a map or a floor plan.
///
/// Each cell knows how far the nearest solid one is, so that rays and collision checks can skip the empty circle
/// around it. That is kept in strips eight columns wide, so that eight by eight cells lie side by side in a processor's
/// cache: rays go up and down as often as aside.
public final class RasterWalls {
    static final byte SOLID = 0;
    static final byte NEAR = 1; // touches a solid cell, if only with a corner
    private static final byte FAR = 2;
    private static final double UNITS_PER_CELL = 2;
    private static final int MOST = 0xFF;
    private static final int STRIP_BITS = 3;
    private static final int STRIP = 1 << STRIP_BITS; // columns
    private static final double GUARD = 1e-6; // [cells]
    private static final int MOST_CELLS = 1 << 20; // with boxes, which have 8 bytes each
    private static final long WORTH_BOXES = 2; // rays per cell, after which boxes have cost less than they save

    final double cellX; // [m]
    final double cellY;
    final double columnsPerMeter;
    final double rowsPerMeter;
    final double least; // [m]
    final double guard; // more than rounding, so that no stride ends in a wall [m]
    final double left; // of the fence, which is one cell wide
    final double bottom;
    final int width; // with the fence
    final int height;
    private final boolean fenced;
    private final double lowest;
    private final double highest;
    private final Surface surface;
    final double[] strides; // by room, what a ray may skip [m]; nothing near walls
    private final int strip; // cells of one
    private final AtomicLong cast = new AtomicLong(); // rays, until there are boxes
    private volatile @Nullable EmptyBoxes boxes;
    private final byte[] room; // by cell: SOLID, NEAR, or NEAR + units from any point of it to anything solid, unsigned

    /// The walls of a map.
    public static RasterWalls of(OccupancyGrid map) {
        return new RasterWalls(SolidRaster.of(map));
    }

    public RasterWalls(SolidRaster raster) {
        cellX = raster.cellX();
        cellY = raster.cellY();
        columnsPerMeter = 1 / cellX;
        rowsPerMeter = 1 / cellY;
        least = Math.min(cellX, cellY);
        guard = GUARD * least;
        left = raster.left() - cellX;
        bottom = raster.bottom() - cellY;
        width = raster.width() + 2;
        height = raster.height() + 2;
        fenced = raster.fenced();
        lowest = raster.lowest();
        highest = raster.highest();
        surface = raster.surface();
        strides = new double[MOST + 1];
        for (int i = NEAR + 1; i < strides.length; i++) {
            strides[i] = empty(i) - guard;
        }
        strip = Math.multiplyExact(STRIP, height);
        room = new byte[Math.multiplyExact(strip, (width + STRIP - 1) / STRIP)];
        markSolid(raster);
        markNear();
        measureFar();
    }

    private void markSolid(SolidRaster raster) {
        for (int row = 0; row < raster.height(); row++) {
            for (int column = 0; column < raster.width(); column++) {
                if (!raster.solid().get(row * raster.width() + column)) {
                    room[at(column + 1, row + 1)] = FAR;
                }
            }
        }
    }

    private void markNear() {
        for (int row = 1; row < height - 1; row++) {
            for (int column = 1; column < width - 1; column++) {
                int cell = at(column, row);
                if (room[cell] == FAR && touchesSolid(column, row)) {
                    room[cell] = NEAR;
                }
            }
        }
    }

    private boolean touchesSolid(int column, int row) {
        for (int y = row - 1; y <= row + 1; y++) {
            if (room[at(column - 1, y)] == SOLID || room[at(column, y)] == SOLID || room[at(column + 1, y)] == SOLID) {
                return true;
            }
        }
        return false;
    }

    /// Two cells are as far apart, from border to border, as the middle of one is from the middle of the nearest
    /// of those around the other.
    private void measureFar() {
        DistanceTransform.measure(
                width, height, cell -> room[at(cell % width, cell / width)] != FAR, (row, squares) -> {
                    for (int column = 0; column < width; column++) {
                        double cells = Math.sqrt(squares[column]);
                        if (cells > 0) {
                            room[at(column, row)] = (byte) Math.min(MOST, NEAR + (int) (cells * UNITS_PER_CELL));
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

    /// As [PlacedShape#isAt].
    boolean isAt(double z) {
        return PlacedShape.isBetween(lowest, z, highest);
    }

    /// Whether no robot leaves them.
    public boolean isFenced() {
        return fenced;
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

    int roomIn(int column, int row) {
        return room[at(column, row)] & 0xFF;
    }

    /// Where a cell is in arrays of all.
    int at(int column, int row) {
        return (column >> STRIP_BITS) * strip + (row << STRIP_BITS) + (column & (STRIP - 1));
    }

    /// Whether so many rays were cast that they go by boxes now.
    boolean hasBoxes() {
        return boxes != null;
    }

    /// Length of arrays by cells.
    int cells() {
        return room.length;
    }

    /// Ends rays at the border of the first solid cell, if that is within reach and they have met nothing before;
    /// at once inside a wall. Of as many threads as like; how they go makes no difference.
    void end(Rays rays, double reach) {
        EmptyBoxes known = boxes;
        if (known != null) {
            known.end(rays, reach);
            return;
        }
        rays.march.end(this, rays, reach);
        if (room.length <= MOST_CELLS) {
            long before = cast.getAndAdd(rays.count);
            long worth = WORTH_BOXES * room.length;
            if (before < worth && before + rays.count >= worth) { // only one thread makes them
                boxes = new EmptyBoxes(this);
            }
        }
    }

    /// Whether a place is in the grid and not on its fence [cells].
    boolean isInside(double column, double row) {
        return column >= 1 && column < width - 1 && row >= 1 && row < height - 1; // false for NaN
    }

    boolean isFence(int column, int row) {
        return column == 0 || column == width - 1 || row == 0 || row == height - 1;
    }

    /// How far a piece is from walls, and from the fence if there is one [m]: at most the true distance (exact to
    /// a face, less to a corner), 0 or less when they overlap, `reach` when nothing is nearer than that.
    double separation(PlacedShape piece, double reach) {
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

    private double fromFence(PlacedShape piece) {
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
