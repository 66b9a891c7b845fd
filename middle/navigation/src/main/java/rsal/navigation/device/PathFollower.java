package rsal.navigation.device;

import java.util.List;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Twist2d;
import rsal.navigation.avoid.Controller;
import rsal.navigation.avoid.Controller.Target;
import rsal.navigation.device.PathNavigator.Situation;

/// Gives a controller a path in the frame of the base.
///
/// @param lookahead how far ahead on a path its targets are [m]
record PathFollower(Controller controller, double lookahead) {
    /// Whether a target is the end of its path.
    boolean isLast(Point2d mapFromTarget, Point2d mapFromEnd) {
        return mapFromTarget.distanceTo(mapFromEnd) < lookahead / 8;
    }

    /// What to command now.
    ///
    /// @param last whether the target is the end
    /// @param mapFromWay points of the path from the robot on
    Twist2d drive(Situation now, Point2d mapFromTarget, boolean last, List<Point2d> mapFromWay) {
        Pose2d baseFromMap = now.mapFromBase().inverse();
        List<Point2d> way = mapFromWay.stream().map(baseFromMap::transform).toList();
        return controller.drive(
                now.obstacles(), new Target(baseFromMap.transform(mapFromTarget), last, way), now.motion());
    }
}
