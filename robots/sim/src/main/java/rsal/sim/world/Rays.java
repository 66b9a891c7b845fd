package rsal.sim.world;

import java.util.Objects;
import org.jspecify.annotations.Nullable;

/// Rays on their way, all of a sensor at once, as flat arrays. Each thread has one of these and uses it again and
/// again, so that it stays in the processor's cache.
final class Rays {
    private static final ThreadLocal<Rays> OF_THIS_THREAD = ThreadLocal.withInitial(() -> new Rays(64, true));

    static final int NOTHING = -1;
    static final int WALL = -2;

    int count; // of those in use
    final double[] x; // where each starts, in the map frame [m]
    final double[] y;
    final double[] dx; // direction of length 1
    final double[] dy;
    final double[] range; // how far it gets until it meets something [m]; +∞ as long as it has met nothing

    final int[] met; // NOTHING, WALL, or the slot of a piece

    final double[] metersPerColumn; // of a grid; scratch of [EmptyBoxes]
    final double[] metersPerRow;
    final int[] apart; // rays that go by a march of their own
    final RayMarch march;
    private final @Nullable Rays few; // those that go apart; null in those
    final PieceGrid.Found near = new PieceGrid.Found();

    private Rays(int count, boolean all) {
        x = new double[count];
        y = new double[count];
        dx = new double[count];
        dy = new double[count];
        range = new double[count];
        met = new int[count];
        metersPerColumn = new double[count];
        metersPerRow = new double[count];
        apart = new int[count];
        march = new RayMarch(count);
        few = all ? new Rays(count, false) : null;
    }

    /// Those of this thread, to be written again.
    static Rays ofThisThread(int count) {
        Rays rays = OF_THIS_THREAD.get();
        if (rays.x.length < count) {
            rays = new Rays(Math.max(count, 2 * rays.x.length), true);
            OF_THIS_THREAD.set(rays);
        }
        rays.count = count;
        return rays;
    }

    /// Lets some rays, those in [#apart], go by [RayMarch].
    void march(RasterWalls walls, double reach, int number) {
        Rays some = Objects.requireNonNull(few);
        some.count = number;
        for (int i = 0; i < number; i++) {
            int ray = apart[i];
            some.x[i] = x[ray];
            some.y[i] = y[ray];
            some.dx[i] = dx[ray];
            some.dy[i] = dy[ray];
            some.range[i] = range[ray];
            some.met[i] = met[ray];
        }
        some.march.end(walls, some, reach);
        for (int i = 0; i < number; i++) {
            range[apart[i]] = some.range[i];
            met[apart[i]] = some.met[i];
        }
    }
}
