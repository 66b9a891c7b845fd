package rsal.sim.world;

/// Rays on their way, all of a sensor at once, as flat arrays. Each thread has one of these and uses it again and
/// again, so that it stays in the processor's cache.
final class Rays {
    private static final ThreadLocal<Rays> OF_THIS_THREAD = ThreadLocal.withInitial(() -> new Rays(64));

    static final int NOTHING = -1;
    static final int WALL = -2;
    static final int BUNCH = 8;

    int count; // of those in use
    final double[] x; // where each starts, in the map frame [m]
    final double[] y;
    final double[] dx; // direction of length 1
    final double[] dy;
    final double[] range; // how far it gets until it meets something [m]; +∞ as long as it has met nothing

    final int[] met; // NOTHING, WALL, or the slot of a piece

    // of the walls, while they look
    final double[] column;
    final double[] row;
    final double[] columnsPerMeter;
    final double[] rowsPerMeter;
    final double[] way; // [m]
    final double[] limit; // of the way that is of interest [m]
    final double[] bunchWay; // of rays next to each other [m]
    final double[] bunchSpread; // how far they are beside their middle one, per meter of its way
    final int[] under; // those still under way

    final PieceGrid.Found near = new PieceGrid.Found();

    private Rays(int count) {
        x = new double[count];
        y = new double[count];
        dx = new double[count];
        dy = new double[count];
        range = new double[count];
        column = new double[count];
        row = new double[count];
        columnsPerMeter = new double[count];
        rowsPerMeter = new double[count];
        met = new int[count];
        limit = new double[count];
        bunchWay = new double[count / BUNCH + 1];
        bunchSpread = new double[count / BUNCH + 1];
        way = new double[count];
        under = new int[count];
    }

    /// Index of a bunch's middle ray.
    int middle(int bunch) {
        return (bunch * BUNCH + end(bunch)) >>> 1;
    }

    /// Index behind a bunch's last ray.
    int end(int bunch) {
        return Math.min((bunch + 1) * BUNCH, count);
    }

    /// Those of this thread, to be written anew.
    static Rays ofThisThread(int count) {
        Rays rays = OF_THIS_THREAD.get();
        if (rays.x.length < count) {
            rays = new Rays(Math.max(count, 2 * rays.x.length));
            OF_THIS_THREAD.set(rays);
        }
        rays.count = count;
        return rays;
    }
}
