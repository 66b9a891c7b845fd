package rsal.navigation.traffic;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import org.jspecify.annotations.Nullable;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.navigation.passage.Passages;
import rsal.navigation.traffic.TrafficReport.Follower;

/// How robots agree on who has narrow passages. One for each robot; all calls on the run's thread.
interface Agreement {
    /// What keeps the robot from the passages that it wants.
    PassageAccess access(Instant now, OwnClaim wanted);

    /// What the robot does now. Called with each look, ten times a second, before it says anything to others.
    ///
    /// @param known the passages of the map
    /// @param mapFromPath corners of the path that is left, from the robot on; empty without one
    /// @param own what it wants or has, if anything
    void look(Instant now, Pose2d mapFromBase, Passages known, List<Point2d> mapFromPath, @Nullable OwnClaim own);

    /// Robots that it takes along in its direction.
    default List<Follower> followers() {
        return List.of();
    }

    /// It takes nobody along any more.
    default void leaveFollowers() {}

    /// Makes one for a robot.
    @FunctionalInterface
    interface Maker {
        Agreement of(Team team);
    }

    /// What an agreement of a robot is made of.
    ///
    /// @param batch robots in one direction while others wait
    /// @param claimDistance of path before a passage from which on it is claimed [m]
    /// @param mates what was heard of other robots
    /// @param report says to all others what this robot wants and has
    record Team(
            TrafficType.Participant self,
            int batch,
            double claimDistance,
            Mates mates,
            GateNeighbors neighbors,
            Runnable report) {
        /// Who says nothing for so long is taken for absent.
        static final Duration ABSENT = Duration.ofSeconds(3);
    }
}
