package rsal.navigation.grid;

import java.util.Arrays;
import rsal.data.OccupancyGrid;

/// For each cell of a map the distance [m] from its middle to the middle of the nearest cell of some kind,
/// exactly. Immutable; robots that share a map share its fields.
///
/// P. Felzenszwalb, D. Huttenlocher: Distance Transforms of Sampled Functions, Theory of Computing 8 (2012),
/// algorithm 1 along the rows. Differs in that the columns, which hold only zero and infinity, are done by
/// counting.
public final class DistanceField {
    private final int width;
    private final int height;
    private final double resolution;
    private final double originX;
    private final double originY;
    private final float[] meters;

    private DistanceField(OccupancyGrid map, float[] meters) {
        this.width = map.width();
        this.height = map.height();
        this.resolution = map.resolution();
        this.originX = map.originX();
        this.originY = map.originY();
        this.meters = meters;
    }

    /// How far the nearest occupied cell is.
    public static DistanceField toOccupied(OccupancyGrid map) {
        return new DistanceField(map, transform(map, false));
    }

    /// How far the nearest cell is that is not known to be free: occupied or unknown.
    public static DistanceField toNotFree(OccupancyGrid map) {
        return new DistanceField(map, transform(map, true));
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

    /// How far one sees from a place in a direction before a cell is hit or the map ends, at most `limit` [m].
    ///
    /// Steps as far as the field says that nothing is (J. Hart: Sphere Tracing, The Visual Computer 12, 1996),
    /// less the diagonal of a cell, because the field holds for the middles of cells. It may overlook a corner
    /// that the ray crosses for less than half a cell.
    public double castRay(double x, double y, double direction, double limit) {
        double cos = Math.cos(direction);
        double sin = Math.sin(direction);
        double slack = resolution * Math.sqrt(2);
        double range = 0;
        while (range < limit) {
            double free = at(x + cos * range, y + sin * range);
            if (free < resolution / 2) {
                return range;
            }
            range += Math.max(free - slack, resolution / 2);
        }
        return limit;
    }

    private static float[] transform(OccupancyGrid map, boolean unknownToo) {
        int width = map.width();
        int height = map.height();
        int none = width + height; // cells; farther than anything in the map
        int[] inColumn = distancesInColumns(map, unknownToo, none);
        var meters = new float[width * height];
        var squares = new double[width];
        var parabolas = new int[width];
        var borders = new double[width + 1];
        for (int row = 0; row < height; row++) {
            int start = row * width;
            for (int column = 0; column < width; column++) {
                double cells = inColumn[start + column];
                squares[column] = cells * cells;
            }
            lowerEnvelope(squares, parabolas, borders);
            int k = 0;
            for (int column = 0; column < width; column++) {
                while (borders[k + 1] < column) {
                    k++;
                }
                double dx = column - parabolas[k];
                double square = dx * dx + squares[parabolas[k]];
                meters[start + column] = square >= (double) none * none
                        ? Float.POSITIVE_INFINITY
                        : (float) (map.resolution() * Math.sqrt(square));
            }
        }
        return meters;
    }

    private static int[] distancesInColumns(OccupancyGrid map, boolean unknownToo, int none) {
        int width = map.width();
        byte[] cells = map.cells();
        var distances = new int[cells.length];
        for (int i = 0; i < cells.length; i++) {
            boolean target = unknownToo ? cells[i] != OccupancyGrid.FREE : cells[i] == OccupancyGrid.OCCUPIED;
            int below = i < width ? none : distances[i - width];
            distances[i] = target ? 0 : Math.min(none, below + 1);
        }
        for (int i = cells.length - width - 1; i >= 0; i--) {
            distances[i] = Math.min(distances[i], distances[i + width] + 1);
        }
        return distances;
    }

    /// Which of the parabolas `(x − i)² + squares[i]` is lowest where: parabola `k` of the answer from
    /// `borders[k]` to `borders[k + 1]`.
    private static void lowerEnvelope(double[] squares, int[] parabolas, double[] borders) {
        Arrays.fill(borders, Double.POSITIVE_INFINITY);
        int k = 0;
        parabolas[0] = 0;
        borders[0] = Double.NEGATIVE_INFINITY;
        for (int q = 1; q < squares.length; q++) {
            double crossing = crossing(squares, q, parabolas[k]);
            while (crossing <= borders[k]) {
                k--;
                crossing = crossing(squares, q, parabolas[k]);
            }
            k++;
            parabolas[k] = q;
            borders[k] = crossing;
        }
        borders[k + 1] = Double.POSITIVE_INFINITY;
    }

    private static double crossing(double[] squares, int q, int v) {
        return (squares[q] + (double) q * q - squares[v] - (double) v * v) / (2.0 * (q - v));
    }
}
