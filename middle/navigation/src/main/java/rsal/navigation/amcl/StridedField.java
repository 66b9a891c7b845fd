package rsal.navigation.amcl;

/// A [LikelihoodField] sorted for places that lie a fixed number of its columns apart: each plane has every so many of
/// them. So the beam of a robot at a row of places reads cells that lie side by side, which the compiler makes vectors
/// of. Immutable; robots that share a map share it.
///
/// A sum is that of [LikelihoodField#logOf] of the cells of one beam after the other, to the last bit.
final class StridedField {
    private static final int MOST_CELLS = 1 << 20; // beyond which numbers are too coarse to find runs

    private final LikelihoodField field;
    private final int stride;
    private final int planeWidth;
    private final float[][] planes; // row by row, with a row above and one below for what is outside the map

    /// @param stride how many columns of the field places are apart, at least 1
    StridedField(LikelihoodField field, int stride) {
        this.field = field;
        this.stride = stride;
        this.planeWidth = Math.ceilDiv(field.width(), stride);
        this.planes = new float[stride][planeWidth * (field.height() + 2)];
        for (int row = -1; row <= field.height(); row++) {
            for (int column = 0; column < field.width(); column++) {
                planes[column % stride][(row + 1) * planeWidth + column / stride] = field.logOf(column, row);
            }
        }
    }

    /// One heading of a scan at many places. Not safe for several threads at once.
    final class Scan {
        private final float[] placeX;
        private final float[] placeY;
        private final float most; // of all placeX
        private final int regular; // so many of the first places are a stride apart, but for rounding
        private final int[] from; // by beam: columns of places whose cells lie side by side
        private final int[] to;
        private float[] turnedX = {};
        private float[] turnedY = {};

        /// @param placeX by column of places where they are, in cells of the field, in rising order
        /// @param placeY by row
        Scan(float[] placeX, float[] placeY, int beams) {
            this.placeX = placeX;
            this.placeY = placeY;
            this.most = placeX[placeX.length - 1];
            int alike = 1;
            while (alike < placeX.length
                    && Math.abs(placeX[alike] - (placeX[0] + (double) stride * alike)) <= Math.ulp(most)) {
                alike++;
            }
            this.regular = alike;
            this.from = new int[beams];
            this.to = new int[beams];
        }

        /// Turns the scan.
        ///
        /// @param turnedX by beam from the place to its end, in cells of the field; kept
        /// @param turnedY the same
        void turn(float[] turnedX, float[] turnedY) {
            this.turnedX = turnedX;
            this.turnedY = turnedY;
            for (int beam = 0; beam < from.length; beam++) {
                findRun(beam);
            }
        }

        /// Where a beam ends near the border of a cell, rounding may move some of its ends across: there is no run.
        /// Nor are ends of it that are outside the map, nor what is cut to column 0 from below.
        private void findRun(int beam) {
            double first = (double) placeX[0] + turnedX[beam];
            double reach = Math.abs((double) most) + Math.abs(turnedX[beam]);
            double column = Math.floor(first);
            double margin = 4 * Math.ulp((float) reach);
            boolean runs = reach < MOST_CELLS && first - column > margin && first - column < 1 - margin;
            int start = Math.max(0, Math.ceilDiv(-(int) column, stride));
            int end = Math.min(regular, Math.ceilDiv(field.width() - (int) column, stride));
            from[beam] = start;
            to[beam] = runs ? Math.max(start, end) : start;
        }

        /// Sums of the logarithms of all beams for the places of a row from one column to before another.
        void sum(int row, int begin, int end, float[] sums) {
            for (int i = begin; i < end; i++) {
                sums[i] = 0;
            }
            for (int beam = 0; beam < from.length; beam++) {
                int fieldRow = Math.min(Math.max((int) (placeY[row] + turnedY[beam]), -1), field.height());
                int start = Math.min(Math.max(from[beam], begin), end);
                int stop = Math.max(Math.min(to[beam], end), start);
                addEach(beam, fieldRow, begin, start, sums);
                if (start < stop) {
                    int column = (int) (placeX[start] + turnedX[beam]);
                    int first = (fieldRow + 1) * planeWidth + column / stride;
                    addRun(planes[column % stride], first, sums, start, stop - start);
                }
                addEach(beam, fieldRow, stop, end, sums);
            }
        }

        private void addEach(int beam, int fieldRow, int begin, int end, float[] sums) {
            for (int i = begin; i < end; i++) {
                sums[i] += field.logOf((int) (placeX[i] + turnedX[beam]), fieldRow);
            }
        }

        private static void addRun(float[] plane, int first, float[] sums, int begin, int count) {
            for (int i = 0; i < count; i++) {
                sums[begin + i] += plane[first + i];
            }
        }
    }
}
