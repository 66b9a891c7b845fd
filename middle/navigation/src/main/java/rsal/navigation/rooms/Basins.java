package rsal.navigation.rooms;

import java.util.Arrays;
import rsal.data.OccupancyGrid;
import rsal.navigation.grid.DistanceField;

/// Floods a floor from its widest places to its walls. Where the floods of two widest places meet, they join,
/// unless the place is a gate: a watershed of the distance to walls (L. Vincent, P. Soille, Watersheds in
/// digital spaces: an efficient algorithm based on immersion simulations, IEEE Transactions on Pattern Analysis
/// and Machine Intelligence 13, 1991), whose basins merge by how much lower the saddle is than the lower of two
/// peaks (persistence; R. Bormann et al., Room segmentation: survey, implementation, and analysis, ICRA 2016,
/// call the simpler forms distance transform based and morphological).
///
/// Departs from them in that cells of equal distance are taken row by row, and basins are compared as they
/// meet, by ratios: widths of doors and rooms of one building differ less in scale than in meters.
final class Basins {
    static final int NONE = -1;
    private static final int DIGIT = 16; // bits

    private final OccupancyGrid map;
    private final RoomParameters parameters;
    private final float[] halfWidths; // of cells: to the next wall's face [m]; 0 for walls
    private final int[] basinOf;
    private int[] parents = new int[64];
    private float[] peaks = new float[64];
    private int count;

    /// @param bare without furniture
    Basins(OccupancyGrid bare, RoomParameters parameters) {
        this.map = bare;
        this.parameters = parameters;
        this.halfWidths = halfWidths(bare);
        this.basinOf = new int[halfWidths.length];
        Arrays.fill(basinOf, NONE);
        int[] order = narrowestFirst();
        for (int i = order.length - 1; i >= 0; i--) {
            flood(order[i]);
        }
        for (int cell = 0; cell < basinOf.length; cell++) {
            basinOf[cell] = basinOf[cell] == NONE ? NONE : root(basinOf[cell]);
        }
    }

    /// Of the map's rim nobody knows what lies beyond: it is a wall.
    private static float[] halfWidths(OccupancyGrid map) {
        DistanceField toWall = DistanceField.toNotFree(map);
        var half = new float[map.cells().length];
        double side = map.resolution();
        for (int row = 0; row < map.height(); row++) {
            int toRow = Math.min(row + 1, map.height() - row);
            for (int column = 0; column < map.width(); column++) {
                int cell = row * map.width() + column;
                if (map.cells()[cell] == OccupancyGrid.FREE) {
                    int toRim = Math.min(toRow, Math.min(column + 1, map.width() - column));
                    half[cell] = (float) (Math.min(toRim * side, toWall.at(cell)) - side / 2);
                }
            }
        }
        return half;
    }

    /// Open cells, from the narrowest on; of equal ones row by row. Sorted digit by digit.
    private int[] narrowestFirst() {
        int open = 0;
        for (float half : halfWidths) {
            open += half > 0 ? 1 : 0;
        }
        var order = new int[open];
        int next = 0;
        for (int cell = 0; cell < halfWidths.length; cell++) {
            if (halfWidths[cell] > 0) {
                order[next++] = cell;
            }
        }
        var sorted = new int[open];
        for (int shift = 0; shift < Float.SIZE; shift += DIGIT) {
            var starts = new int[(1 << DIGIT) + 1];
            for (int cell : order) {
                starts[digit(cell, shift) + 1]++;
            }
            for (int digit = 0; digit < 1 << DIGIT; digit++) {
                starts[digit + 1] += starts[digit];
            }
            for (int cell : order) {
                sorted[starts[digit(cell, shift)]++] = cell;
            }
            int[] spare = order;
            order = sorted;
            sorted = spare;
        }
        return order;
    }

    /// Of the bits of a positive float, which are in its order.
    private int digit(int cell, int shift) {
        return Float.floatToRawIntBits(halfWidths[cell]) >>> shift & (1 << DIGIT) - 1;
    }

    private void flood(int cell) {
        int width = map.width();
        int column = cell % width;
        int right = column < width - 1 ? basin(cell + 1) : NONE;
        int left = column > 0 ? basin(cell - 1) : NONE;
        int up = cell + width < basinOf.length ? basin(cell + width) : NONE;
        int down = cell >= width ? basin(cell - width) : NONE;
        float here = halfWidths[cell];
        join(right, left, here);
        join(right, up, here);
        join(right, down, here);
        join(left, up, here);
        join(left, down, here);
        join(up, down, here);
        int best = NONE;
        float most = 0;
        for (int side = 0; side < 4; side++) {
            int neighbor = side == 0 ? right : side == 1 ? left : side == 2 ? up : down;
            int at = cell + (side == 0 ? 1 : side == 1 ? -1 : side == 2 ? width : -width);
            if (neighbor != NONE && halfWidths[at] > most) {
                most = halfWidths[at];
                best = neighbor;
            }
        }
        basinOf[cell] = best == NONE ? begin(here) : root(best);
    }

    private int basin(int cell) {
        return basinOf[cell] == NONE ? NONE : root(basinOf[cell]);
    }

    private int begin(float peak) {
        if (count == parents.length) {
            parents = Arrays.copyOf(parents, 2 * count);
            peaks = Arrays.copyOf(peaks, 2 * count);
        }
        parents[count] = count;
        peaks[count] = peak;
        return count++;
    }

    private void join(int one, int other, float saddle) {
        if (one == NONE || other == NONE) {
            return;
        }
        int a = root(one);
        int b = root(other);
        if (a != b && !parameters.isGate(saddle, Math.min(peaks[a], peaks[b]), Math.max(peaks[a], peaks[b]))) {
            int kept = peaks[a] >= peaks[b] ? a : b;
            parents[kept == a ? b : a] = kept;
        }
    }

    private int root(int basin) {
        int at = basin;
        while (parents[at] != at) {
            parents[at] = parents[parents[at]];
            at = parents[at];
        }
        return at;
    }

    /// How many numbers of basins there are, of which those that joined others are not used.
    int numbers() {
        return count;
    }

    /// The basin of each cell, or [#NONE].
    int[] basinOf() {
        return basinOf;
    }

    /// How far walls are from the middle of each cell [m].
    float[] halfWidths() {
        return halfWidths;
    }

    /// Half the greatest width of a basin [m].
    float peak(int basin) {
        return peaks[basin];
    }
}
