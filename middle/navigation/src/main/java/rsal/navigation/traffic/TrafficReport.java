package rsal.navigation.traffic;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import rsal.data.Point2d;
import rsal.data.Pose2d;

/// What a robot says to others about its way through narrow passages. All places in the map frame. Robots name a
/// passage by a place in it, so that also one with another size, which has other passages, understands.
///
/// @param number counts the reports of a robot; an older one that comes later does not count
/// @param claim the passages that the robot wants or has; empty for none
/// @param isAsking whether it wants an answer
/// @param heard newest ticket that it has heard of each robot, by id
/// @param done the robot wants nothing any more by its own tickets up to this one
/// @param followers robots that go behind it in the same direction; each has what this robot has, also after this
/// one has left, until it says itself that it is done
record TrafficReport(
        long number,
        Pose2d mapFromBase,
        Optional<Claim> claim,
        boolean isAsking,
        Map<String, Long> heard,
        long done,
        List<Follower> followers) {
    TrafficReport {
        heard = Map.copyOf(heard);
        followers = List.copyOf(followers);
    }

    /// @param ticket the lower one goes first
    /// @param isHeld whether the robot has the passages, else it wants them
    /// @param entry gate through which it comes
    /// @param passages a place in each
    /// @param exit the next 2.5 m of its path behind them
    /// @param waiting where it waits
    record Claim(
            long ticket,
            boolean isHeld,
            Point2d entry,
            List<Point2d> passages,
            List<Point2d> exit,
            Optional<Point2d> waiting) {
        Claim {
            passages = List.copyOf(passages);
            exit = List.copyOf(exit);
        }
    }

    /// @param ticket of its claim
    /// @param passages of the claim
    /// @param entry gate through which it comes
    record Follower(String robot, long ticket, List<Point2d> passages, Point2d entry) {
        Follower {
            passages = List.copyOf(passages);
        }
    }
}
