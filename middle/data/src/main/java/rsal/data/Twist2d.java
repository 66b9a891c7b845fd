package rsal.data;

/// Velocity of a planar body in its own frame: forward and left [m/s], counter-clockwise [rad/s].
public record Twist2d(double vx, double vy, double omega) {
    public static final Twist2d STOP = new Twist2d(0, 0, 0);

    /// What a differential drive can do: forward [m/s] and counter-clockwise [rad/s].
    public static Twist2d drive(double forward, double omega) {
        return new Twist2d(forward, 0, omega);
    }

    /// Speed over ground [m/s].
    public double speed() {
        return vy == 0 ? Math.abs(vx) : Math.hypot(vx, vy); // most bases go nowhere else, and are asked often
    }

    public boolean isFinite() {
        return Double.isFinite(vx) && Double.isFinite(vy) && Double.isFinite(omega);
    }
}
