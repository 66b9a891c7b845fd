package rsal.stage;

import rsal.data.Pose2d;

/// Where a frame is, seen from its parent: a pose in the plane, and a height z [m]. Named like poses,
/// parent first.
public record Placement(Pose2d pose, double z) {
    public static final Placement ORIGIN = new Placement(Pose2d.ORIGIN, 0);

    /// @param heading [rad]
    static Placement of(double x, double y, double z, double heading) {
        return new Placement(new Pose2d(x, y, heading), z);
    }

    /// `aFromB.compose(bFromC)` is `aFromC`.
    public Placement compose(Placement next) {
        return new Placement(pose.compose(next.pose), z + next.z);
    }

    public Placement raised(double height) {
        return new Placement(pose, z + height);
    }
}
