package rsal.sim.world;

/// Rays on their way across the grid of walls.
///
/// Each strides across the empty circle around where it is (Hart, Sphere Tracing, 1996) until walls are near, then
/// walks from cell to cell exactly (Amanatides and Woo, A Fast Voxel Traversal Algorithm, 1987). A ray takes two
/// strides and two cells on average; which of both comes next is anybody's guess, and processors pay for a wrong one
/// as for dozens of steps. So all go in step: they stride until none is far from walls, then those near walls walk,
/// then those that came free of them stride again. A ray that is to go on is written into a list, and counted or not,
/// without a branch.
///
/// What a ray is made of lies side by side, so that few arrays are looked into at once and each index is checked once.
final class RayMarch {
    private static final int BUNCH = 8; // rays

    private static final double APART = Double.POSITIVE_INFINITY; // spread of rays that don't leave one place inside

    private static final int SIZE_BITS = 4;
    private static final int SIZE = 1 << SIZE_BITS; // of a ray's numbers, of which these are used:
    private static final int COLUMN = 0; // where it starts [cells]
    private static final int ROW = 1;
    private static final int COLUMNS_PER_METER = 2;
    private static final int ROWS_PER_METER = 3;
    private static final int WAY = 4; // how far it came [m]
    private static final int LIMIT = 5; // of the way that is of interest [m]
    private static final int METERS_PER_COLUMN = 6; // +∞ of those that stay in a column
    private static final int METERS_PER_ROW = 7;
    private static final int ORIGIN_COLUMN = 8; // where it starts, or one less, so that a cell is left at its number
    private static final int ORIGIN_ROW = 9;

    private final double[] numbers; // of rays, which are called by the index of their first
    private final int[] cell; // column and row of that to which each came
    private final double[] bunchWay; // of rays next to each other [m]
    private final int[] bunchMiddle; // the ray in the middle of each
    private final double[] bunchSpread; // how far they are beside their middle one, per meter of its way
    private final int[] striding; // rays, or bunches; one more than there are may be written
    private final int[] walking;
    private final int[] meeting;
    private final int[] room; // where those striding are, in their order
    private int met; // how many of those meeting a wall there are

    /// @param most rays that there will be
    RayMarch(int most) {
        numbers = new double[most * SIZE];
        cell = new int[most * 2];
        bunchWay = new double[most / BUNCH + 1];
        bunchMiddle = new int[most / BUNCH + 1];
        bunchSpread = new double[most / BUNCH + 1];
        striding = new int[most + 1];
        walking = new int[most + 1];
        meeting = new int[most + 1];
        room = new int[most];
    }

    /// Ends rays at the border of the first solid cell, if that is within reach and they have met nothing before; at
    /// once inside a wall.
    void end(RasterWalls walls, Rays rays, double reach) {
        strideTogether(walls, reach, enter(walls, rays, reach));
        met = 0;
        int striding = setOut(walls, rays.count);
        while (striding > 0) {
            int near = stride(walls, striding);
            striding = walk(walls, endInside(walls, near));
        }
        note(walls, rays);
    }

    /// Notes where rays begin and how far those of each bunch are from its middle one.
    ///
    /// @return how many bunches may go together: those whose rays leave one place inside the grid
    private int enter(RasterWalls walls, Rays rays, double reach) {
        int under = 0;
        for (int bunch = 0; bunch * BUNCH < rays.count; bunch++) {
            int middle = (bunch * BUNCH + end(bunch, rays.count)) >>> 1;
            double x = rays.x[middle];
            double y = rays.y[middle];
            boolean fromOnePlace = walls.isInside(
                    (x - walls.left) * walls.columnsPerMeter, (y - walls.bottom) * walls.rowsPerMeter); // as in enter
            double widest = 0; // its square
            for (int i = bunch * BUNCH; i < end(bunch, rays.count); i++) {
                enter(walls, rays, reach, i);
                fromOnePlace = fromOnePlace && rays.x[i] == x && rays.y[i] == y;
                double dx = rays.dx[i] - rays.dx[middle];
                double dy = rays.dy[i] - rays.dy[middle];
                double aside = dx * dx + dy * dy;
                widest = aside > widest ? aside : widest;
            }
            bunchWay[bunch] = 0;
            bunchMiddle[bunch] = middle * SIZE;
            bunchSpread[bunch] = fromOnePlace ? Math.sqrt(widest) : APART;
            striding[under] = bunch;
            under += bunchSpread[bunch] < 1 ? 1 : 0;
        }
        return under;
    }

    private void enter(RasterWalls walls, Rays rays, double reach, int index) {
        double[] its = numbers;
        int ray = index * SIZE;
        double column = (rays.x[index] - walls.left) * walls.columnsPerMeter;
        double row = (rays.y[index] - walls.bottom) * walls.rowsPerMeter;
        double columnsPerMeter = rays.dx[index] * walls.columnsPerMeter;
        double rowsPerMeter = rays.dy[index] * walls.rowsPerMeter;
        its[ray + COLUMN] = column;
        its[ray + ROW] = row;
        its[ray + COLUMNS_PER_METER] = columnsPerMeter;
        its[ray + ROWS_PER_METER] = rowsPerMeter;
        its[ray + LIMIT] = Math.min(reach, rays.range[index]);
        its[ray + METERS_PER_COLUMN] = 1 / (columnsPerMeter + 0.0); // +∞ of -0, too
        its[ray + METERS_PER_ROW] = 1 / (rowsPerMeter + 0.0);
        its[ray + ORIGIN_COLUMN] = column - (columnsPerMeter >= 0 ? 1 : 0);
        its[ray + ORIGIN_ROW] = row - (rowsPerMeter >= 0 ? 1 : 0);
    }

    /// Lets bunches of rays from one place go as far as the strides of their middle ones, each shorter by how far
    /// the others are beside it: cones, each of which is marched as one.
    private void strideTogether(RasterWalls walls, double reach, int bunches) {
        double[] its = numbers;
        double worth = 2 * walls.least;
        int under = bunches;
        while (under > 0) {
            int still = 0;
            for (int k = 0; k < under; k++) {
                int bunch = striding[k];
                double from = bunchWay[bunch];
                int middle = bunchMiddle[bunch];
                int toColumn = (int) (its[middle + COLUMN] + from * its[middle + COLUMNS_PER_METER]);
                int toRow = (int) (its[middle + ROW] + from * its[middle + ROWS_PER_METER]);
                double stride = walls.strides[walls.roomIn(toColumn, toRow)] - from * bunchSpread[bunch];
                bunchWay[bunch] = from + Math.max(0, stride);
                striding[still] = bunch;
                still += 1 - (negative(stride - worth) | negative(reach - from));
            }
            under = still;
        }
    }

    /// Index behind a bunch's last ray.
    private static int end(int bunch, int count) {
        return Math.min((bunch + 1) * BUNCH, count);
    }

    /// @return how many are under way
    private int setOut(RasterWalls walls, int count) {
        double[] its = numbers;
        int[] under = striding;
        int out = 0;
        for (int bunch = 0; bunch * BUNCH < count; bunch++) {
            boolean apart = bunchSpread[bunch] == APART;
            for (int i = bunch * BUNCH; i < end(bunch, count); i++) {
                int ray = i * SIZE;
                boolean outside = apart && !walls.isInside(its[ray + COLUMN], its[ray + ROW]);
                double distance = outside ? toGrid(walls, ray) : bunchWay[bunch];
                its[ray + WAY] = distance;
                under[out] = ray;
                out += distance <= its[ray + LIMIT] ? 1 : 0;
            }
        }
        return out;
    }

    /// Way of a ray from outside until it is well in the first cell [m]; +∞ when it misses the grid.
    private double toGrid(RasterWalls walls, int ray) {
        double enters = 0;
        double leaves = Double.POSITIVE_INFINITY;
        for (int axis = 0; axis < 2; axis++) {
            double from = numbers[ray + COLUMN + axis];
            double speed = numbers[ray + COLUMNS_PER_METER + axis];
            double last = (axis == 0 ? walls.width : walls.height) - 1;
            if (speed == 0) {
                leaves = from >= 1 && from < last ? leaves : Double.NEGATIVE_INFINITY;
            } else {
                enters = Math.max(enters, ((speed > 0 ? 1 : last) - from) / speed);
                leaves = Math.min(leaves, ((speed > 0 ? last : 1) - from) / speed);
            }
        }
        double inside = enters + walls.guard;
        return inside < leaves ? inside : Double.POSITIVE_INFINITY;
    }

    /// Lets those under way stride until walls are near, or their limit is passed.
    ///
    /// @return to how many walls are near
    private int stride(RasterWalls walls, int count) {
        int[] under = striding; // in locals, as the compiler doesn't trust fields to stay
        int[] near = walking;
        double[] its = numbers;
        double[] strides = walls.strides;
        int[] rooms = room;
        int found = 0;
        int going = count;
        while (going > 0) {
            for (int k = 0; k < going; k++) {
                int ray = under[k];
                double from = its[ray + WAY];
                int column = (int) (its[ray + COLUMN] + from * its[ray + COLUMNS_PER_METER]);
                int row = (int) (its[ray + ROW] + from * its[ray + ROWS_PER_METER]);
                rooms[k] = walls.roomIn(column, row);
            }
            int still = 0;
            for (int k = 0; k < going; k++) {
                int ray = under[k];
                int here = rooms[k];
                double to = its[ray + WAY] + strides[here]; // none where walls are near
                its[ray + WAY] = to;
                int far = isFar(here);
                near[found] = ray;
                found += 1 - far;
                under[still] = ray;
                still += far & ~negative(its[ray + LIMIT] - to);
            }
            going = still;
        }
        return found;
    }

    /// Ends those that are in a wall, where only [#setOut] can have put them.
    ///
    /// Nearly along a border a coordinate rounds to it for a long way, while the ray is behind it. Were it not put
    /// there, it would come free by crossing that border again, as before, and stride and walk there for ever.
    ///
    /// @return how many are left, near walls
    private int endInside(RasterWalls walls, int count) {
        double[] its = numbers;
        int left = 0;
        for (int k = 0; k < count; k++) {
            int ray = walking[k];
            double distance = its[ray + WAY];
            int column = (int) (its[ray + COLUMN] + distance * its[ray + COLUMNS_PER_METER]);
            int row = (int) (its[ray + ROW] + distance * its[ray + ROWS_PER_METER]);
            column += left(column, its[ray + ORIGIN_COLUMN], its[ray + METERS_PER_COLUMN], distance);
            row += left(row, its[ray + ORIGIN_ROW], its[ray + METERS_PER_ROW], distance);
            cell[place(ray)] = column;
            cell[place(ray) + 1] = row;
            if (walls.roomIn(column, row) == RasterWalls.SOLID) {
                its[ray + WAY] = Math.max(0, distance - walls.guard);
                meeting[met++] = ray;
            } else {
                walking[left++] = ray;
            }
        }
        return left;
    }

    /// What leads to the next cell of an axis when this one was left before, else 0.
    private static int left(int cell, double origin, double metersPerCell, double distance) {
        return -negative((cell - origin) * metersPerCell - distance) & ahead(metersPerCell);
    }

    /// Lets those near walls go from cell to cell, until they meet one, or come free, or their limit is passed.
    ///
    /// @return how many came free
    private int walk(RasterWalls walls, int count) {
        int[] near = walking;
        int[] free = striding;
        double[] its = numbers;
        int[] at = cell;
        int[] meet = meeting;
        int freed = 0;
        int solids = met;
        int going = count;
        while (going > 0) {
            int still = 0;
            for (int k = 0; k < going; k++) {
                int ray = near[k];
                int place = place(ray);
                int column = at[place];
                int row = at[place + 1];
                double perColumn = its[ray + METERS_PER_COLUMN];
                double perRow = its[ray + METERS_PER_ROW];
                double toColumn = (column - its[ray + ORIGIN_COLUMN]) * perColumn;
                double toRow = (row - its[ray + ORIGIN_ROW]) * perRow;
                int aside = -negative(toColumn - toRow); // all bits: the border to another column is nearer
                double to = Math.min(toColumn, toRow);
                int nextColumn = column + (aside & ahead(perColumn));
                int nextRow = row + (~aside & ahead(perRow));
                int here = walls.roomIn(nextColumn, nextRow);
                int within = 1 - negative(its[ray + LIMIT] - to);
                int far = isFar(here);
                int solid = 1 - Math.min(here, 1);
                at[place] = nextColumn;
                at[place + 1] = nextRow;
                its[ray + WAY] = to + far * walls.guard; // or rounding might put it back
                meet[solids] = ray;
                solids += solid & within;
                free[freed] = ray;
                freed += far & within;
                near[still] = ray;
                still += within & ~far & ~solid;
            }
            going = still;
        }
        met = solids;
        return freed;
    }

    /// Where in [#cell] the column of a ray is.
    private static int place(int ray) {
        return (2 * ray) >>> SIZE_BITS;
    }

    /// 1 upwards, −1 downwards.
    private static int ahead(double metersPerCell) {
        return 1 - 2 * negative(metersPerCell);
    }

    /// 1 when walls are not near, else 0.
    private static int isFar(int room) {
        return (RasterWalls.NEAR - room) >>> 31;
    }

    /// 1 when it is, else 0.
    private static int negative(double number) {
        return (int) (Double.doubleToRawLongBits(number) >>> 63);
    }

    /// A ray that has met the fence has left the grid, and met nothing.
    private void note(RasterWalls walls, Rays rays) {
        for (int k = 0; k < met; k++) {
            int ray = meeting[k];
            double distance = numbers[ray + WAY];
            if (distance <= numbers[ray + LIMIT] && !walls.isFence(cell[place(ray)], cell[place(ray) + 1])) {
                rays.range[ray / SIZE] = distance;
                rays.met[ray / SIZE] = Rays.WALL;
            }
        }
    }
}
