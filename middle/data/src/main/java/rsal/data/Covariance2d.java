package rsal.data;

/// Symmetric 3×3 covariance of a pose: x, y [m²], heading [rad²] and their products.
public record Covariance2d(double xx, double xy, double xTheta, double yy, double yTheta, double thetaTheta) {
    public static Covariance2d ofDeviations(double x, double y, double theta) {
        return new Covariance2d(x * x, 0, 0, y * y, 0, theta * theta);
    }

    /// Whether it has a value: neither NaN nor infinite.
    public boolean isFinite() {
        return Double.isFinite(xx)
                && Double.isFinite(xy)
                && Double.isFinite(xTheta)
                && Double.isFinite(yy)
                && Double.isFinite(yTheta)
                && Double.isFinite(thetaTheta);
    }

    /// Standard deviation of the position along its worst direction [m].
    public double positionDeviation() {
        double mean = (xx + yy) / 2;
        double spread = Math.hypot((xx - yy) / 2, xy);
        return Math.sqrt(Math.max(0, mean + spread));
    }
}
