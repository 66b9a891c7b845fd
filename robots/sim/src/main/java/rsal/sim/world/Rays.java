package rsal.sim.world;

/// Rays on their way, all of a sensor at once, as flat arrays. Kept by who casts them, as many cast at once.
final class Rays {
    final int count;
    final double[] x; // where each starts, in the map frame [m]
    final double[] y;
    final double[] dx; // direction of length 1
    final double[] dy;
    final double[] range; // how far it gets until it meets something [m]; +∞ as long as it has met nothing

    // of the walls, while they look
    final double[] column;
    final double[] row;
    final double[] way;
    final int[] under; // way

    Rays(int count) {
        this.count = count;
        x = new double[count];
        y = new double[count];
        dx = new double[count];
        dy = new double[count];
        range = new double[count];
        column = new double[count];
        row = new double[count];
        way = new double[count];
        under = new int[count];
    }
}
