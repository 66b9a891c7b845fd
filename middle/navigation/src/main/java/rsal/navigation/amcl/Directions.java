package rsal.navigation.amcl;

/// Cosines and sines of many angles at once, off by less than 1e-15. A loop that calls [Math#cos] takes one angle after
/// the other; of this one, which has no branches, the compiler makes vectors. Nothing but sums and products in a fixed
/// order: the same on all machines.
///
/// Taylor's series of half the angle, which is at most π/2, up to where all that is left is less than the last bit of
/// 1;
/// then the formulas of the double angle. Room to work in; not safe for several threads at once.
final class Directions {
    private static final double C2 = -1 / 2.0;
    private static final double C4 = -C2 / (3 * 4);
    private static final double C6 = -C4 / (5 * 6);
    private static final double C8 = -C6 / (7 * 8);
    private static final double C10 = -C8 / (9 * 10);
    private static final double C12 = -C10 / (11 * 12);
    private static final double C14 = -C12 / (13 * 14);
    private static final double C16 = -C14 / (15 * 16);
    private static final double C18 = -C16 / (17 * 18);
    private static final double C20 = -C18 / (19 * 20);
    private static final double C22 = -C20 / (21 * 22);
    private static final double S3 = -1 / 6.0;
    private static final double S5 = -S3 / (4 * 5);
    private static final double S7 = -S5 / (6 * 7);
    private static final double S9 = -S7 / (8 * 9);
    private static final double S11 = -S9 / (10 * 11);
    private static final double S13 = -S11 / (12 * 13);
    private static final double S15 = -S13 / (14 * 15);
    private static final double S17 = -S15 / (16 * 17);
    private static final double S19 = -S17 / (18 * 19);
    private static final double S21 = -S19 / (20 * 21);

    final double[] cos;
    final double[] sin;

    /// @param most angles at once
    Directions(int most) {
        cos = new double[most];
        sin = new double[most];
    }

    /// @param angles in [-π, π]
    void of(double[] angles, int first, int count) {
        double[] cos = this.cos;
        double[] sin = this.sin;
        System.arraycopy(angles, first, cos, 0, count); // only arrays with the same index are known not to overlap
        for (int i = 0; i < count; i++) {
            double half = cos[i] / 2;
            double s = sin(half);
            double c = cos(half);
            cos[i] = c * c - s * s;
            sin[i] = 2 * s * c;
        }
    }

    private static double cos(double x) {
        double q = x * x;
        double far = C12 + q * (C14 + q * (C16 + q * (C18 + q * (C20 + q * C22))));
        return 1 + q * (C2 + q * (C4 + q * (C6 + q * (C8 + q * (C10 + q * far)))));
    }

    private static double sin(double x) {
        double q = x * x;
        double far = S11 + q * (S13 + q * (S15 + q * (S17 + q * (S19 + q * S21))));
        return x * (1 + q * (S3 + q * (S5 + q * (S7 + q * (S9 + q * far)))));
    }
}
