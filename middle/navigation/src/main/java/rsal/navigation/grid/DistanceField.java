package rsal.navigation.grid;

import java.util.function.IntPredicate;
import rsal.data.DistanceTransform;
import rsal.data.OccupancyGrid;

/// For each cell of a map the distance [m] from its middle to the middle of the nearest cell of some kind,
/// exactly. Immutable; robots that share a map share its fields.
public final class DistanceField {
    private final int width;
    private final int height;
    private final double resolution;
    private final double originX;
    private final double originY;
    private final double cellsPerMeter;
    private final float[] meters;

    private DistanceField(OccupancyGrid map, float[] meters) {
        this.width = map.width();
        this.height = map.height();
        this.resolution = map.resolution();
        this.originX = map.originX();
        this.originY = map.originY();
        this.cellsPerMeter = 1 / map.resolution();
        this.meters = meters;
    }

    /// How far the nearest occupied cell is.
    public static DistanceField toOccupied(OccupancyGrid map) {
        byte[] cells = map.cells();
        return new DistanceField(map, transform(map, cell -> cells[cell] == OccupancyGrid.OCCUPIED));
    }

    /// How far the nearest face of a wall is: an occupied cell with one beside it, or across a corner, that is not
    /// occupied. Unlike [#toOccupied] it grows inside of what is thick, where no beam ends, but no more than said:
    /// the far side of a wall is to look little better than its middle.
    ///
    /// @param deepest that anything is said to be inside [m]
    public static DistanceField toFace(OccupancyGrid map, double deepest) {
        byte[] cells = map.cells();
        float[] meters = transform(map, cell -> cells[cell] == OccupancyGrid.OCCUPIED && !isOccupiedAround(map, cell));
        for (int cell = 0; cell < cells.length; cell++) {
            if (cells[cell] == OccupancyGrid.OCCUPIED) {
                meters[cell] = (float) Math.min(deepest, meters[cell]);
            }
        }
        return new DistanceField(map, meters);
    }

    private static boolean isOccupiedAround(OccupancyGrid map, int cell) {
        int row = cell / map.width();
        int column = cell % map.width();
        int lowest = Math.max(0, row - 1);
        int highest = Math.min(map.height() - 1, row + 1);
        int leftmost = Math.max(0, column - 1);
        int rightmost = Math.min(map.width() - 1, column + 1);
        for (int r = lowest; r <= highest; r++) {
            for (int c = leftmost; c <= rightmost; c++) {
                if (map.cells()[r * map.width() + c] != OccupancyGrid.OCCUPIED) {
                    return false;
                }
            }
        }
        return true;
    }

    /// How far the nearest cell is that is not known to be free: occupied or unknown.
    public static DistanceField toNotFree(OccupancyGrid map) {
        byte[] cells = map.cells();
        return new DistanceField(map, transform(map, cell -> cells[cell] != OccupancyGrid.FREE));
    }

    /// The same, to the bit, of a map that differs little from one before: what is far from all that differs is taken
    /// over.
    ///
    /// @param before of the map before, also how far the nearest cell is that is not known to be free
    public static DistanceField toNotFree(Difference difference, DistanceField before) {
        before.checkIsOf(difference.overlay().before());
        return new DistanceRepair(difference, before.meters)
                .meters()
                .map(meters -> new DistanceField(difference.now(), meters))
                .orElseGet(() -> toNotFree(difference.now()));
    }

    /// Throws [IllegalArgumentException] when a map is not of the same size and at the same place.
    public void checkIsOf(OccupancyGrid map) {
        if (!(map.width() == width
                && map.height() == height
                && map.resolution() == resolution
                && map.originX() == originX
                && map.originY() == originY)) {
            throw new IllegalArgumentException("""
                    A field of distances on %d × %d cells of %s m from (%s, %s) is not of a map of \
                    %d × %d cells of %s m from (%s, %s).
                    Maybe it is of the map before, or of the one after.""".formatted(
                            width,
                            height,
                            resolution,
                            originX,
                            originY,
                            map.width(),
                            map.height(),
                            map.resolution(),
                            map.originX(),
                            map.originY()));
        }
    }

    public int width() {
        return width;
    }

    public int height() {
        return height;
    }

    /// Side of a cell [m].
    public double resolution() {
        return resolution;
    }

    /// Of the lower-left cell's lower-left corner [m].
    public double originX() {
        return originX;
    }

    /// The same.
    public double originY() {
        return originY;
    }

    /// Distance of a cell [m], row by row as in the map; +∞ everywhere when there is nothing to be near to.
    public float at(int cell) {
        return meters[cell];
    }

    /// Distance of the cell at a place in the map frame [m]; 0 outside the map.
    public double at(double x, double y) {
        int column = (int) Math.floor((x - originX) / resolution);
        int row = (int) Math.floor((y - originY) / resolution);
        return column >= 0 && column < width && row >= 0 && row < height ? meters[row * width + column] : 0;
    }

    /// Distance at a place in the map frame, interpolated between the middles of the four nearest cells, and how it
    /// grows along x and along y.
    ///
    /// @param into distance [m] and the two slopes, when the place is in the map and its distance finite
    /// @return whether it is
    public boolean slope(double x, double y, double[] into) {
        double column = (x - originX) / resolution - 0.5;
        double row = (y - originY) / resolution - 0.5;
        if (!(column >= 0 && column < width - 1 && row >= 0 && row < height - 1)) {
            return false;
        }
        int left = (int) column;
        int low = (int) row;
        double right = column - left;
        double up = row - low;
        int cell = low * width + left;
        double a = meters[cell];
        double b = meters[cell + 1];
        double c = meters[cell + width];
        double d = meters[cell + width + 1];
        into[0] = (1 - up) * (a + right * (b - a)) + up * (c + right * (d - c));
        into[1] = ((1 - up) * (b - a) + up * (d - c)) / resolution;
        into[2] = ((1 - right) * (c - a) + right * (d - b)) / resolution;
        return into[0] < Double.POSITIVE_INFINITY;
    }

    /// How far one sees from a place in a direction before a cell is hit or the map ends, at most `limit` [m].
    ///
    /// Steps as far as the field says that nothing is (J. Hart: Sphere Tracing, The Visual Computer 12, 1996),
    /// less the diagonal of a cell, because the field holds for the middles of cells. It may overlook a corner
    /// that the ray crosses for less than half a cell.
    public double castRay(double x, double y, double direction, double limit) {
        return ray(x, y, Math.cos(direction), Math.sin(direction), limit);
    }

    private double ray(double x, double y, double cos, double sin, double limit) {
        float[] field = meters; // the compiler would look it up again after each step
        double slack = resolution * Math.sqrt(2);
        double least = resolution / 2;
        double column = (x - originX) * cellsPerMeter;
        double row = (y - originY) * cellsPerMeter;
        double columns = cos * cellsPerMeter; // per m
        double rows = sin * cellsPerMeter;
        double range = 0;
        while (range < limit) {
            double c = column + columns * range;
            double r = row + rows * range;
            boolean isOnMap = c >= 0 && c < width && r >= 0 && r < height;
            double free = isOnMap ? field[((int) r) * width + (int) c] : 0;
            if (free < least) {
                return range;
            }
            range += Math.max(free - slack, least);
        }
        return limit;
    }

    /// How far the first cell is that is hit from a place in a direction [m], found as by [#castRay]: +∞ when none is
    /// within `limit` or the map ends before it, 0 when the place itself is outside the map.
    public double firstHit(double x, double y, double direction, double limit) {
        return firstHit(x, y, Math.cos(direction), Math.sin(direction), limit);
    }

    /// The same in the direction of a vector of length 1.
    ///
    /// @param cos of the direction
    /// @param sin the same
    public double firstHit(double x, double y, double cos, double sin, double limit) {
        double range = ray(x, y, cos, sin, limit);
        return isHit(x, y, cos, sin, range, limit) ? range : Double.POSITIVE_INFINITY;
    }

    /// The same in several directions, all at once: each waits for memory while the others go on.
    ///
    /// @param cos of the directions
    /// @param sin the same
    /// @param from index of the first direction
    /// @param into for each direction from the first on, as [#firstHit]; its length says how many there are
    public void firstHits(double x, double y, double[] cos, double[] sin, int from, double limit, double[] into) {
        march(x, y, cos, sin, from, limit, into, false);
        for (int ray = 0; ray < into.length; ray++) {
            boolean hits = isHit(x, y, cos[from + ray], sin[from + ray], into[ray], limit);
            into[ray] = hits ? into[ray] : Double.POSITIVE_INFINITY;
        }
    }

    /// The shortest of the same: +∞ when nothing is hit in any of the directions.
    ///
    /// @param count how many directions
    public double nearestHit(double x, double y, double[] cos, double[] sin, int from, int count, double limit) {
        double[] ranges = new double[count];
        march(x, y, cos, sin, from, limit, ranges, true);
        double nearest = Double.POSITIVE_INFINITY;
        for (int ray = 0; ray < count; ray++) {
            if (ranges[ray] < nearest && isHit(x, y, cos[from + ray], sin[from + ray], ranges[ray], limit)) {
                nearest = ranges[ray];
            }
        }
        return nearest;
    }

    /// @param nearest whether those that are farther than another that hit something need not go on
    private void march(
            double x, double y, double[] cos, double[] sin, int from, double limit, double[] ranges, boolean nearest) {
        int[] under = new int[ranges.length]; // those that have hit nothing yet
        for (int i = 0; i < under.length; i++) {
            under[i] = i;
            ranges[i] = 0;
        }
        float[] field = meters;
        double slack = resolution * Math.sqrt(2);
        double least = resolution / 2;
        double column = (x - originX) * cellsPerMeter;
        double row = (y - originY) * cellsPerMeter;
        double end = limit;
        int going = limit > 0 ? under.length : 0;
        while (going > 0) {
            int still = 0;
            for (int k = 0; k < going; k++) {
                int ray = under[k];
                double range = ranges[ray];
                double c = column + cos[from + ray] * cellsPerMeter * range; // as in #ray, to the bit
                double r = row + sin[from + ray] * cellsPerMeter * range;
                boolean isOnMap = c >= 0 && c < width && r >= 0 && r < height;
                double free = isOnMap ? field[((int) r) * width + (int) c] : 0;
                if (free >= least) {
                    double next = range + Math.max(free - slack, least);
                    ranges[ray] = next;
                    under[still] = ray;
                    still += next < end ? 1 : 0;
                } else if (nearest && isHit(x, y, cos[from + ray], sin[from + ray], range, end)) {
                    end = range;
                }
            }
            going = still;
        }
    }

    private boolean isHit(double x, double y, double cos, double sin, double range, double limit) {
        return range == 0 || (range < limit && contains(x + cos * range, y + sin * range));
    }

    /// Whether a place in the map frame is on the map.
    public boolean contains(double x, double y) {
        double column = Math.floor((x - originX) / resolution);
        double row = Math.floor((y - originY) / resolution);
        return column >= 0 && column < width && row >= 0 && row < height;
    }

    private static float[] transform(OccupancyGrid map, IntPredicate target) {
        var meters = new float[map.cells().length];
        DistanceTransform.measure(map.width(), map.height(), target, (row, squares) -> {
            for (int column = 0; column < squares.length; column++) {
                meters[row * squares.length + column] = meters(map, squares[column]);
            }
        });
        return meters;
    }

    /// @param square of a distance [cells²]
    static float meters(OccupancyGrid map, double square) {
        return (float) (map.resolution() * Math.sqrt(square));
    }
}
