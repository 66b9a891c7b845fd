package rsal.agents.swarm;

import java.util.List;
import java.util.random.RandomGenerator;
import rsal.data.Point2d;
import rsal.data.Pose2d;

/// What a robot knows when it asks its rule.
///
/// @param time of the run [s]
/// @param robot its id
/// @param mapFromBase where it believes to be
/// @param speed at which it drives at most [m/s]
/// @param neighbors those of whose poses it has heard lately, by id
/// @param toObstacle from the robot to the nearest thing that it senses, also a robot, in the map frame [m]; longer
/// than any sensor sees when there is none
/// @param random a stream of the robot's own
public record SwarmView(
        double time,
        String robot,
        Pose2d mapFromBase,
        double speed,
        List<Neighbor> neighbors,
        Point2d toObstacle,
        RandomGenerator random) {
    public SwarmView {
        neighbors = List.copyOf(neighbors);
    }

    /// A robot nearby.
    ///
    /// @param mapFromBase where it said to be
    public record Neighbor(String robot, Pose2d mapFromBase) {}
}
