package rsal.sim.world;

/// Rays on their way, all of a sensor at once, as flat arrays. Kept by who casts them, as many cast at once.
final class Rays {
    static final int NOTHING = -1;
    static final int WALL = -2;

    final int count;
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
    final int[] under; // those still under way

    Rays(int count) {
        this.count = count;
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
        way = new double[count];
        under = new int[count];
    }
}
