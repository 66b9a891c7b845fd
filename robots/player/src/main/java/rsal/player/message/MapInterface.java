package rsal.player.message;

import java.util.List;
import rsal.player.wire.CountOf;

/// Interface `map`.
public final class MapInterface {
    public static final int INFO_DATA = 1;

    public static final int INFO = 1;
    public static final int TILE = 2;
    public static final int LINES = 3;

    /// Cells that a tile can have: Player's messages hold 8 MiB.
    public static final int LARGEST_TILE = 8_000_000;

    private MapInterface() {}

    /// @param scale of a cell [m]
    /// @param width [cells]
    /// @param origin of the cell at the lower left
    public record Extent(float scale, int width, int height, Pose origin) {}

    /// A part of the map, row 0 at the bottom [cells].
    ///
    /// @param range what a cell has that is occupied; −that is free, 0 unknown
    /// @param cells row by row; over a connection packed by zlib (RFC 1950)
    public record Tile(
            int column,
            int row,
            int width,
            int height,
            @CountOf("cells") int count,
            int range,
            byte[] cells) {}

    public record Lines(float minX, float maxX, float minY, float maxY, List<Segment> lines) {}
}
