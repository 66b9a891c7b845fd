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

    /// The sum, as of errors that have nothing to do with each other.
    public Covariance2d plus(Covariance2d other) {
        return new Covariance2d(
                xx + other.xx,
                xy + other.xy,
                xTheta + other.xTheta,
                yy + other.yy,
                yTheta + other.yTheta,
                thetaTheta + other.thetaTheta);
    }

    public Covariance2d times(double factor) {
        return new Covariance2d(
                factor * xx, factor * xy, factor * xTheta, factor * yy, factor * yTheta, factor * thetaTheta);
    }

    /// What is known where this is what is not ("information"), and the other way round. Not finite when there is
    /// none.
    public Covariance2d inverse() {
        double a = yy * thetaTheta - yTheta * yTheta;
        double b = xTheta * yTheta - xy * thetaTheta;
        double c = xy * yTheta - yy * xTheta;
        double by = 1 / (xx * a + xy * b + xTheta * c);
        return new Covariance2d(
                a * by,
                b * by,
                c * by,
                (xx * thetaTheta - xTheta * xTheta) * by,
                (xy * xTheta - xx * yTheta) * by,
                (xx * yy - xy * xy) * by);
    }

    /// Of the same pose in other axes.
    ///
    /// @param theta heading of the axes of this in those
    public Covariance2d turned(double theta) {
        double cos = Math.cos(theta);
        double sin = Math.sin(theta);
        return new Covariance2d(
                cos * cos * xx - 2 * cos * sin * xy + sin * sin * yy,
                cos * sin * (xx - yy) + (cos * cos - sin * sin) * xy,
                cos * xTheta - sin * yTheta,
                sin * sin * xx + 2 * cos * sin * xy + cos * cos * yy,
                sin * xTheta + cos * yTheta,
                thetaTheta);
    }
}
