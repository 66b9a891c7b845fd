package rsal.navigation.slam;

import rsal.data.Covariance2d;
import rsal.data.Pose2d;

/// How one pose of a graph lies to another.
///
/// @param from number of a pose
/// @param to number of another
/// @param fromFromTo where `to` is, seen from `from`
/// @param covariance of x, y and heading of that, in the frame `from`
public record Relation(int from, int to, Pose2d fromFromTo, Covariance2d covariance, Source source) {
    /// Who tells it.
    public enum Source {
        /// The wheels.
        ODOMETRY,
        /// A scan and those just before it.
        SCANS,
        /// A scan and those taken there before; may be wrong.
        LOOP
    }

    public Relation {
        if (from == to || from < 0 || to < 0) {
            throw new IllegalArgumentException("A relation can't lead from '%d' to '%d'.".formatted(from, to));
        }
    }
}
