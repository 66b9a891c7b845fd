package rsal.player.message;

import java.util.List;
import rsal.player.wire.Times;

/// What had another body up to Player 3.0.
public final class Version30 {
    private Version30() {}

    /// @param covariance xx, yy, θθ [m², rad²]
    /// @param weight among all of them
    public record Hypothesis(Pose mapFromBase, @Times(3) double[] covariance, double weight) {}

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
