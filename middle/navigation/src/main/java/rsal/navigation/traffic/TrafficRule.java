package rsal.navigation.traffic;

import java.time.Instant;
import java.util.List;
import java.util.function.Supplier;
import rsal.data.Point2d;
import rsal.data.Pose2d;

/// Decides for one robot when it may drive where others are in the way. All calls on the run's thread.
public interface TrafficRule {
    /// One that never minds others.
    TrafficRule NONE = new TrafficRule() {
        @Override
        public TrafficAdvice advise(Instant now, Pose2d mapFromBase, Supplier<List<Point2d>> mapFromPath) {
            return new TrafficAdvice.Proceed();
        }

        @Override
        public void stands(Instant now, Pose2d mapFromBase) {}

        @Override
        public List<Point2d> closed(Instant now) {
            return List.of();
        }
    };

    /// What to do now. Asked with each look of a robot that has a path, ten times a second.
    ///
    /// @param mapFromPath corners of the path that is left, from the robot on; only computed when it is asked for
    TrafficAdvice advise(Instant now, Pose2d mapFromBase, Supplier<List<Point2d>> mapFromPath);

    /// The robot has no path now, but is there, maybe in the way of others. Called as often.
    void stands(Instant now, Pose2d mapFromBase);

    /// Places in the map frame through which no path is to lead, as what broke down stands there.
    List<Point2d> closed(Instant now);

    /// Whether robots of the team are so near that they may hide from this one what the map shows.
    default boolean isAmongOthers(Instant now, Pose2d mapFromBase) {
        return false;
    }

    /// Whether robots of the team are there that keep to the right of corridors as this one does.
    default boolean keepsLanes() {
        return false;
    }
}
