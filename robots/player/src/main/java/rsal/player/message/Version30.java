package rsal.player.message;

import java.util.Arrays;
import java.util.List;
import rsal.player.wire.Times;

/// What had another body up to Player 3.0.
public final class Version30 {
    private Version30() {}

    /// The same as newer servers and clients say it; what is no different as it is.
    static Record newer(Record body) {
        return switch (body) {
            case Hypotheses(int pending, double time, List<Hypothesis> all) ->
                new Localize.Hypotheses(
                        pending, time, all.stream().map(Hypothesis::newer).toList());
            case SetPose(Pose mapFromBase, double[] covariance) ->
                new Localize.SetPose(mapFromBase, Arrays.copyOf(covariance, 6));
            case Waypoints(List<Pose> waypoints) -> new PlannerInterface.Waypoints(0, waypoints);
            case Tile(int column, int row, int width, int height, byte[] cells) ->
                new MapInterface.Tile(column, row, width, height, cells.length, 1, cells);
            default -> body;
        };
    }

    /// The same as older servers and clients understand it; what is no different as it is.
    static Record older(Record body) {
        return switch (body) {
            case Localize.Hypotheses(int pending, double time, List<Localize.Hypothesis> all) ->
                new Hypotheses(pending, time, all.stream().map(Hypothesis::of).toList());
            case Localize.SetPose(Pose mapFromBase, double[] covariance) ->
                new SetPose(mapFromBase, Arrays.copyOf(covariance, 3));
            case MapInterface.Tile tile ->
                new Tile(tile.column(), tile.row(), tile.width(), tile.height(), tile.cells());
            case PlannerInterface.Waypoints ways -> new Waypoints(ways.waypoints());
            default -> body;
        };
    }

    /// @param covariance xx, yy, θθ [m², rad²]
    /// @param weight among all of them
    public record Hypothesis(Pose mapFromBase, @Times(3) double[] covariance, double weight) {
        static Hypothesis of(Localize.Hypothesis newest) {
            return new Hypothesis(newest.mapFromBase(), Arrays.copyOf(newest.covariance(), 3), newest.weight());
        }

        Localize.Hypothesis newer() {
            return new Localize.Hypothesis(mapFromBase, Arrays.copyOf(covariance, 6), weight);
        }
    }

    /// @param pending readings that were not looked at yet
    /// @param pendingTime of the oldest of those [s]
    /// @param hypotheses likeliest first
    public record Hypotheses(int pending, double pendingTime, List<Hypothesis> hypotheses) {}

    /// @param covariance xx, yy, θθ [m², rad²]
    public record SetPose(Pose mapFromBase, @Times(3) double[] covariance) {}

    /// A part of a map, row 0 at the bottom [cells].
    ///
    /// @param cells row by row: 1 occupied, 0 unknown, −1 free; over a connection packed by zlib (RFC 1950)
    public record Tile(int column, int row, int width, int height, byte[] cells) {}

    public record Waypoints(List<Pose> waypoints) {}
}
