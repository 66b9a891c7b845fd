package rsal.sim.world;

/// Rays on their way across the grid of walls, as flat arrays.
///
/// Each strides across the empty circle around where it is (Hart, Sphere Tracing, 1996) until walls are near, then
/// walks from cell to cell exactly (Amanatides and Woo, A Fast Voxel Traversal Algorithm, 1987). A ray takes two
/// strides and two cells on average; which of both comes next is anybody's guess, and processors pay for a wrong one
/// as for dozens of steps. So all go in step: they stride until none is far from walls, then those near walls walk,
/// then those that came free of them stride again. Whoever is to go on is written into a list, and counted or not,
/// without a branch.
final class March {
    private static final int BUNCH = 8; // rays

    private final double[] column; // where each starts [cells]
    private final double[] row;
    private final double[] columnsPerMeter;
    private final double[] rowsPerMeter;
    private final double[] metersPerColumn; // +∞ of those that stay in a column
    private final double[] metersPerRow;
    private final double[] originColumn; // where it starts, or one less, so that a cell is left at its number
    private final double[] originRow;
    private final double[] limit; // of the way that is of interest [m]
    private final double[] way; // how far it came [m]
    private final int[] atColumn; // the cell that it came to
    private final int[] atRow;
    private final double[] bunchWay; // of rays next to each other [m]
    private final double[] bunchSpread; // how far they are beside their middle one, per meter of its way
    private final int[] striding; // indices of rays, or of bunches; one more than there are may be written
    private final int[] walking;
    private final int[] meeting;
    private int met; // how many of those meeting a wall there are

    /// @param most rays that there will be
    March(int most) {
        column = new double[most];
        row = new double[most];
        originColumn = new double[most];
        originRow = new double[most];
        columnsPerMeter = new double[most];
        rowsPerMeter = new double[most];
        metersPerColumn = new double[most];
        metersPerRow = new double[most];
        limit = new double[most];
        way = new double[most];
        atColumn = new int[most];
        atRow = new int[most];
        bunchWay = new double[most / BUNCH + 1];
        bunchSpread = new double[most / BUNCH + 1];
        striding = new int[most + 1];
        walking = new int[most + 1];
        meeting = new int[most + 1];
    }

    /// Ends rays at the border of the first solid cell, if that is within reach and they have met nothing before; at
    /// once inside a wall.
    void end(Walls walls, Rays rays, double reach) {
        enter(walls, rays, reach);
        strideTogether(walls, rays, reach);
        met = 0;
        int striding = setOut(walls, rays.count);
        while (striding > 0) {
            int near = stride(walls, striding);
            striding = walk(walls, endInside(walls, near));
        }
        note(walls, rays);
    }

    private void enter(Walls walls, Rays rays, double reach) {
        double columns = 1 / walls.cellX;
        double rows = 1 / walls.cellY;
        for (int i = 0; i < rays.count; i++) {
            column[i] = (rays.x[i] - walls.left) * columns;
            row[i] = (rays.y[i] - walls.bottom) * rows;
            columnsPerMeter[i] = rays.dx[i] * columns;
            rowsPerMeter[i] = rays.dy[i] * rows;
            limit[i] = Math.min(reach, rays.range[i]);
        }
        for (int i = 0; i < rays.count; i++) {
            metersPerColumn[i] = 1 / (columnsPerMeter[i] + 0.0); // +∞ of -0, too
            metersPerRow[i] = 1 / (rowsPerMeter[i] + 0.0);
            originColumn[i] = column[i] - (columnsPerMeter[i] >= 0 ? 1 : 0);
            originRow[i] = row[i] - (rowsPerMeter[i] >= 0 ? 1 : 0);
        }
    }

    /// Lets bunches of rays from one place go as far as the strides of their middle ones, each shorter by how far
    /// the others are beside it: cones, each of which is marched as one.
    private void strideTogether(Walls walls, Rays rays, double reach) {
        double worth = 2 * walls.least;
        int under = beginTogether(walls, rays);
        while (under > 0) {
            int still = 0;
            for (int k = 0; k < under; k++) {
                int bunch = striding[k];
                int middle = middle(bunch, rays.count);
                double from = bunchWay[bunch];
                int toColumn = (int) (column[middle] + from * columnsPerMeter[middle]);
                int toRow = (int) (row[middle] + from * rowsPerMeter[middle]);
                double stride = walls.strides[walls.roomIn(toColumn, toRow)] - from * bunchSpread[bunch];
                bunchWay[bunch] = from + Math.max(0, stride);
                striding[still] = bunch;
                still += 1 - (negative(stride - worth) | negative(reach - from));
            }
            under = still;
        }
    }

    private int beginTogether(Walls walls, Rays rays) {
        int under = 0;
        for (int bunch = 0; bunch * BUNCH < rays.count; bunch++) {
            int middle = middle(bunch, rays.count);
            double widest = walls.isInside(column[middle], row[middle]) ? 0 : Double.POSITIVE_INFINITY;
            for (int i = bunch * BUNCH; i < end(bunch, rays.count); i++) {
                double dx = rays.dx[i] - rays.dx[middle];
                double dy = rays.dy[i] - rays.dy[middle];
                boolean fromOnePlace = rays.x[i] == rays.x[middle] && rays.y[i] == rays.y[middle];
                widest = fromOnePlace ? Math.max(widest, dx * dx + dy * dy) : Double.POSITIVE_INFINITY;
            }
            bunchWay[bunch] = 0;
            bunchSpread[bunch] = Math.sqrt(widest);
            if (widest < 1) {
                striding[under++] = bunch;
            }
        }
        return under;
    }

    private static int middle(int bunch, int count) {
        return (bunch * BUNCH + end(bunch, count)) >>> 1;
    }

    /// Index behind a bunch's last ray.
    private static int end(int bunch, int count) {
        return Math.min((bunch + 1) * BUNCH, count);
    }

    /// @return how many are under way
    private int setOut(Walls walls, int count) {
        int under = 0;
        for (int i = 0; i < count; i++) {
            way[i] = walls.isInside(column[i], row[i]) ? bunchWay[i / BUNCH] : toGrid(walls, i);
            striding[under] = i;
            under += way[i] <= limit[i] ? 1 : 0;
        }
        return under;
    }

    /// Way of a ray from outside until it is well in the first cell [m]; +∞ when it misses the grid.
    private double toGrid(Walls walls, int ray) {
        double enters = 0;
        double leaves = Double.POSITIVE_INFINITY;
        for (int axis = 0; axis < 2; axis++) {
            double at = axis == 0 ? column[ray] : row[ray];
            double speed = axis == 0 ? columnsPerMeter[ray] : rowsPerMeter[ray];
            double last = (axis == 0 ? walls.width : walls.height) - 1;
            if (speed == 0) {
                leaves = at >= 1 && at < last ? leaves : Double.NEGATIVE_INFINITY;
            } else {
                enters = Math.max(enters, ((speed > 0 ? 1 : last) - at) / speed);
                leaves = Math.min(leaves, ((speed > 0 ? last : 1) - at) / speed);
            }
        }
        double inside = enters + walls.guard;
        return inside < leaves ? inside : Double.POSITIVE_INFINITY;
    }

    /// Lets those under way stride until walls are near, or their limit is passed.
    ///
    /// @return to how many walls are near
    private int stride(Walls walls, int count) {
        int[] under = striding; // in locals, as the compiler doesn't trust fields to stay
        int[] near = walking;
        double[] ways = way;
        double[] limits = limit;
        double[] strides = walls.strides;
        int found = 0;
        int going = count;
        while (going > 0) {
            int still = 0;
            for (int k = 0; k < going; k++) {
                int i = under[k];
                double from = ways[i];
                int toColumn = (int) (column[i] + from * columnsPerMeter[i]);
                int toRow = (int) (row[i] + from * rowsPerMeter[i]);
                int here = walls.roomIn(toColumn, toRow);
                double to = from + strides[here]; // none where walls are near
                ways[i] = to;
                atColumn[i] = toColumn;
                atRow[i] = toRow;
                int far = isFar(here);
                near[found] = i;
                found += 1 - far;
                under[still] = i;
                still += far & ~negative(limits[i] - to);
            }
            going = still;
        }
        return found;
    }

    /// Ends those that are in a wall, where only [#setOut] can have put them.
    ///
    /// @return how many are left, near walls
    private int endInside(Walls walls, int count) {
        int left = 0;
        for (int k = 0; k < count; k++) {
            int i = walking[k];
            if (walls.roomIn(atColumn[i], atRow[i]) == Walls.SOLID) {
                way[i] = Math.max(0, way[i] - walls.guard);
                meeting[met++] = i;
            } else {
                walking[left++] = i;
            }
        }
        return left;
    }

    /// Lets those near walls go from cell to cell, until they meet one, or come free, or their limit is passed.
    ///
    /// @return how many came free
    private int walk(Walls walls, int count) {
        int[] near = walking;
        int[] free = striding;
        double[] ways = way;
        double[] limits = limit;
        int[] meet = meeting;
        int freed = 0;
        int solids = met;
        int going = count;
        while (going > 0) {
            int still = 0;
            for (int k = 0; k < going; k++) {
                int i = near[k];
                double perColumn = metersPerColumn[i];
                double perRow = metersPerRow[i];
                double toColumn = (atColumn[i] - originColumn[i]) * perColumn;
                double toRow = (atRow[i] - originRow[i]) * perRow;
                int aside = -negative(toColumn - toRow); // all bits: the border to another column is nearer
                double to = Math.min(toColumn, toRow);
                int nextColumn = atColumn[i] + (aside & (1 - 2 * negative(perColumn)));
                int nextRow = atRow[i] + (~aside & (1 - 2 * negative(perRow)));
                int here = walls.roomIn(nextColumn, nextRow);
                int within = 1 - negative(limits[i] - to);
                int far = isFar(here);
                int solid = 1 - Math.min(here, 1);
                atColumn[i] = nextColumn;
                atRow[i] = nextRow;
                ways[i] = to + far * walls.guard; // or rounding might put it back
                meet[solids] = i;
                solids += solid & within;
                free[freed] = i;
                freed += far & within;
                near[still] = i;
                still += within & ~far & ~solid;
            }
            going = still;
        }
        met = solids;
        return freed;
    }

    /// 1 when walls are not near, else 0.
    private static int isFar(int room) {
        return (Walls.NEAR - room) >>> 31;
    }

    /// 1 when it is, else 0.
    private static int negative(double number) {
        return (int) (Double.doubleToRawLongBits(number) >>> 63);
    }

    /// Whoever has met the fence has left the grid, and met nothing.
    private void note(Walls walls, Rays rays) {
        for (int k = 0; k < met; k++) {
            int i = meeting[k];
            if (way[i] <= limit[i] && !walls.isFence(atColumn[i], atRow[i])) {
                rays.range[i] = way[i];
                rays.met[i] = Rays.WALL;
            }
        }
    }
}
