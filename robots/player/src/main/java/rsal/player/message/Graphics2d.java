package rsal.player.message;

import java.util.List;

/// Interface `graphics2d`: what is drawn into the world [m].
public final class Graphics2d {
    public static final int CLEAR = 1;
    public static final int POINTS = 2;
    public static final int POLYLINE = 3;
    public static final int POLYGON = 4;
    public static final int LINES = 5;

    private Graphics2d() {}

    /// Of points, of a polyline, and of lines, each of two points.
    public record Points(List<Point> points, PlayerColor color) {}

    /// @param filled other than 0 when it is
    public record Polygon(List<Point> points, PlayerColor color, PlayerColor fill, int filled) {}
}
