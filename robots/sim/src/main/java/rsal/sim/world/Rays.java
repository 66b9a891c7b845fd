package rsal.sim.world;

/// Rays on their way, all of a sensor at once, as flat arrays. Each thread has one of these and uses it again and
/// again, so that it stays in the processor's cache.
final class Rays {
    private static final ThreadLocal<Rays> OF_THIS_THREAD = ThreadLocal.withInitial(() -> new Rays(64));

    static final int NOTHING = -1;
    static final int WALL = -2;

    int count; // of those in use
    final double[] x; // where each starts, in the map frame [m]
    final double[] y;
    final double[] dx; // direction of length 1
    final double[] dy;
    final double[] range; // how far it gets until it meets something [m]; +∞ as long as it has met nothing

    final int[] met; // NOTHING, WALL, or the slot of a piece

    final RayMarch march;
    final PieceGrid.Found near = new PieceGrid.Found();

    private Rays(int count) {
        x = new double[count];
        y = new double[count];
        dx = new double[count];
        dy = new double[count];
        range = new double[count];
        met = new int[count];
        march = new RayMarch(count);
    }

    /// Those of this thread, to be written again.
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
