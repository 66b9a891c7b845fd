package rsal.navigation.amcl;

import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReferenceArray;
import rsal.navigation.grid.DistanceField;

/// How far the cones of sonars should reach on a map: from the middles of cells of 0.1 m, in directions 3° apart, the
/// way to the nearest wall in the cone. A cone is as many rays as directions in it.
///
/// What a cell sees is found as it is asked for, and kept once it was asked so often that finding it for all directions
/// pays, as long as there is room ([#MOST_KEPT]). It is the same value, kept or not, so that robots on any number of
/// threads share it without a lock: who finds a cell empty that another is about to fill finds the value himself. A
/// table of ranges by place and direction is D. Fox, W. Burgard, S. Thrun, Markov Localization for Mobile Robots in
/// Dynamic Environments (Journal of Artificial Intelligence Research 11, 1999, section 3.4); differs in that it is
/// filled as robots go, and in that [#reach] is corrected by where in its cell a sensor is.
final class Cones {
    static final int DIRECTIONS = 120;
    static final double FARTHEST = 10; // m; what is farther is not told apart from nothing

    private static final double SIDE_RAY = 0.4; // of the cone, from its middle
    private static final double CELL = 0.1; // m
    private static final double NEAR = 0.15; // m; a wall may go through a cell whose middle is nearer to it
    private static final int OFTEN = 16; // times asked that cost as much as filling a cell
    private static final int MOST_KEPT = 400_000; // cells: some 60 MB
    private static final double MOST_CELLS = 16_000_000; // of a map
    private static final double STEP = 0.04; // m, of what is kept
    private static final int NOTHING = 255;
    private static final byte[] NOT_KEPT = {};
    private static final byte[] BESIDE_A_WALL = {0}; // told from what is kept by its length, as the other
    private static final double[] COS = new double[2 * DIRECTIONS]; // twice around, so that no cone has a break
    private static final double[] SIN = new double[2 * DIRECTIONS];

    static {
        for (int i = 0; i < 2 * DIRECTIONS; i++) {
            COS[i] = Math.cos(2 * Math.PI * (i % DIRECTIONS) / DIRECTIONS);
            SIN[i] = Math.sin(2 * Math.PI * (i % DIRECTIONS) / DIRECTIONS);
        }
    }

    final double originX;
    final double originY;
    final double cellsPerMeter = 1 / CELL;
    private final DistanceField toOccupied;
    private final int raysAside;
    private final int width;
    private final int height;
    private final AtomicReferenceArray<byte[]> kept; // by cell: for each direction what it reaches, or nothing yet
    private final byte[] asked; // how often, about, as threads may forget each other's
    private final AtomicInteger keptCells = new AtomicInteger();

    /// @param raysAside of the middle ray, on each side
    Cones(DistanceField toOccupied, int raysAside) {
        this.toOccupied = toOccupied;
        this.originX = toOccupied.originX();
        this.originY = toOccupied.originY();
        this.raysAside = raysAside;
        double columns = Math.ceil(toOccupied.width() * toOccupied.resolution() / CELL);
        double rows = Math.ceil(toOccupied.height() * toOccupied.resolution() / CELL);
        boolean fits = columns * rows <= MOST_CELLS;
        this.width = fits ? (int) columns : 0;
        this.height = fits ? (int) rows : 0;
        this.asked = new byte[width * height];
        this.kept = new AtomicReferenceArray<>(asked.length);
        for (int cell = 0; cell < asked.length; cell++) {
            kept.setPlain(cell, NOT_KEPT);
        }
    }

    /// How many rays of a cone of this width are on each side of its middle. The outermost are not among them: what is
    /// there returns little sound.
    static int raysAside(double cone) {
        return (int) Math.round(SIDE_RAY * cone * DIRECTIONS / (2 * Math.PI));
    }

    /// How far a cone should reach [m], +∞ when nothing is in it.
    ///
    /// @param column of the sensor, in cells from the origin
    /// @param row the same
    /// @param cos of the cone's middle
    /// @param sin the same
    /// @param direction the same in steps, rounded
    /// @param limit [m] beyond which it may as well be +∞
    double reach(float column, float row, float cos, float sin, int direction, double limit) {
        int c = (int) column;
        int r = (int) row;
        if (!(column >= 0 && row >= 0 && c < width && r < height)) { // beside the map, or all of it is too large
            return exact(originX + column * CELL, originY + row * CELL, cos, sin, limit);
        }
        int cell = r * width + c;
        byte[] reaches = kept.getAcquire(cell);
        if (reaches.length == NOT_KEPT.length) {
            reaches = ask(cell);
        }
        if (reaches.length == BESIDE_A_WALL.length) {
            return exact(originX + column * CELL, originY + row * CELL, cos, sin, limit);
        }
        int steps = reaches.length == NOT_KEPT.length ? steps(fromMiddle(cell, direction)) : reaches[direction] & 0xFF;
        if (steps == NOTHING) {
            return Double.POSITIVE_INFINITY;
        }
        return steps * STEP - CELL * (cos * (column - c - 0.5f) + sin * (row - r - 0.5f));
    }

    /// Keeps what a cell sees if it was asked often enough.
    private byte[] ask(int cell) {
        byte[] reaches = NOT_KEPT;
        if (!(toOccupied.at(middleX(cell), middleY(cell)) >= NEAR)) {
            reaches = BESIDE_A_WALL;
        } else if (asked[cell] < OFTEN) {
            asked[cell]++;
        } else if (keptCells.get() < MOST_KEPT) {
            keptCells.incrementAndGet();
            reaches = around(middleX(cell), middleY(cell));
        }
        if (reaches.length > NOT_KEPT.length) {
            kept.setRelease(cell, reaches);
        }
        return reaches;
    }

    private double middleX(int cell) {
        return originX + (cell % width + 0.5) * CELL;
    }

    private double middleY(int cell) {
        int row = cell / width;
        return originY + (row + 0.5) * CELL;
    }

    private double fromMiddle(int cell, int direction) {
        int first = Math.floorMod(direction - raysAside, DIRECTIONS);
        return toOccupied.nearestHit(middleX(cell), middleY(cell), COS, SIN, first, 2 * raysAside + 1, FARTHEST);
    }

    private byte[] around(double x, double y) {
        double[] rays = new double[DIRECTIONS];
        toOccupied.firstHits(x, y, COS, SIN, 0, FARTHEST, rays);
        byte[] reaches = new byte[DIRECTIONS];
        for (int d = 0; d < DIRECTIONS; d++) {
            double nearest = Double.POSITIVE_INFINITY;
            for (int ray = -raysAside; ray <= raysAside; ray++) {
                nearest = Math.min(nearest, rays[Math.floorMod(d + ray, DIRECTIONS)]);
            }
            reaches[d] = (byte) steps(nearest);
        }
        return reaches;
    }

    private static int steps(double reach) {
        return reach == Double.POSITIVE_INFINITY ? NOTHING : (int) (reach / STEP + 0.5);
    }

    /// The same from where the sensor is, by all rays of the cone.
    ///
    /// @param x in the map frame [m]
    /// @param y the same
    double exact(double x, double y, double cos, double sin, double limit) {
        double nearest = toOccupied.firstHit(x, y, cos, sin, limit);
        for (int ray = 1; ray <= raysAside; ray++) {
            double c = COS[ray];
            double s = SIN[ray];
            double left = toOccupied.firstHit(x, y, c * cos - s * sin, c * sin + s * cos, Math.min(nearest, limit));
            nearest = Math.min(nearest, left);
            double right = toOccupied.firstHit(x, y, c * cos + s * sin, c * sin - s * cos, Math.min(nearest, limit));
            nearest = Math.min(nearest, right);
        }
        return nearest;
    }
}
