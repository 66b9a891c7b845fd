package rsal.ros2.message;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import rsal.data.Path2d;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.ros2.cdr.CdrWriter;
import rsal.ros2.cdr.RosMessage;

/// Paths as `nav_msgs/Path`: poses close to each other, as planners of Nav2 have them and its controllers expect them.
public final class PathMessage {
    private static final double STEP = 0.1; // m, between poses at most, unless there are too many
    private static final int MOST = 10_000; // legs of a path that is written

    private PathMessage() {}

    /// The way through the positions of all poses; empty when one is not finite. The frame is not looked at.
    public static Optional<Path2d> of(RosMessage message) {
        var points = new ArrayList<Point2d>();
        for (RosMessage stamped : message.messages("poses")) {
            RosMessage position = stamped.message("pose").message("position");
            var point = new Point2d(position.number("x"), position.number("y"));
            if (!Double.isFinite(point.x()) || !Double.isFinite(point.y())) {
                return Optional.empty();
            }
            points.add(point);
        }
        return Optional.of(new Path2d(points));
    }

    /// Poses along a path, 0.1 m apart at most, that look ahead. The points of the path are among them.
    public static List<Pose2d> poses(Path2d path) {
        List<Point2d> points = path.points();
        double step = Math.max(STEP, path.length() / MOST);
        var poses = new ArrayList<Pose2d>();
        double heading = 0;
        for (int i = 1; i < points.size(); i++) {
            Point2d from = points.get(i - 1);
            Point2d to = points.get(i);
            double length = from.distanceTo(to);
            if (length > 0) {
                heading = Math.atan2(to.y() - from.y(), to.x() - from.x());
            }
            int pieces = Math.max(1, (int) Math.ceil(length / step));
            for (int piece = 0; piece < pieces; piece++) {
                double share = (double) piece / pieces;
                poses.add(new Pose2d(
                        from.x() + share * (to.x() - from.x()), from.y() + share * (to.y() - from.y()), heading));
            }
        }
        if (!points.isEmpty()) {
            poses.add(new Pose2d(points.getLast().x(), points.getLast().y(), heading));
        }
        return poses;
    }

    /// Writes a path through these poses.
    public static CdrWriter write(CdrWriter to, Instant time, String frame, List<Pose2d> poses) {
        RosMessages.write(to, time).text(frame).int32(poses.size());
        for (Pose2d pose : poses) {
            RosMessages.write(to, time).text(frame);
            RosMessages.write(to, FrameTransform.of(pose));
        }
        return to;
    }
}
