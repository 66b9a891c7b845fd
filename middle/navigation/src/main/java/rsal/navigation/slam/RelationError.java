package rsal.navigation.slam;

import java.util.List;
import rsal.data.Pose2d;

/// How far relations between poses are off those that are right. Unlike errors of poses it does not punish a
/// map for a single bend that turns all behind it: R. Kümmerle et al., On Measuring the Accuracy of SLAM
/// Algorithms, Autonomous Robots 27 (2009), equations 6 and 7 with means of lengths and angles, not of
/// squares.
///
/// @param count relations looked at
/// @param meters mean length of the errors; NaN without any
/// @param radians mean angle of them; the same
public record RelationError(int count, double meters, double radians) {
    /// Of each pose and the next.
    public static RelationError ofNext(List<Pose2d> right, List<Pose2d> judged) {
        return of(right, judged, 0);
    }

    /// Of poses that are near each other but do not follow on each other, as where loops close.
    ///
    /// @param within in meters
    public static RelationError ofNear(List<Pose2d> right, List<Pose2d> judged, double within) {
        return of(right, judged, within);
    }

    private static RelationError of(List<Pose2d> right, List<Pose2d> judged, double within) {
        if (right.size() != judged.size()) {
            throw new IllegalArgumentException(
                    "%d poses can't be compared with %d correct ones.".formatted(judged.size(), right.size()));
        }
        int count = 0;
        double meters = 0;
        double radians = 0;
        for (int i = 0; i < right.size(); i++) {
            int first = within > 0 ? i + 2 : i + 1;
            int last = within > 0 ? right.size() - 1 : Math.min(i + 1, right.size() - 1);
            for (int k = first; k <= last; k++) {
                if (within > 0 && right.get(i).distanceTo(right.get(k)) > within) {
                    continue;
                }
                Pose2d is = right.get(i).inverse().compose(right.get(k));
                Pose2d off = is.inverse().compose(judged.get(i).inverse().compose(judged.get(k)));
                count++;
                meters += Math.hypot(off.x(), off.y());
                radians += Math.abs(off.theta());
            }
        }
        return new RelationError(count, meters / count, radians / count);
    }
}
