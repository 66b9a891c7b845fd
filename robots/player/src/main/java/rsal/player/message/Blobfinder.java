package rsal.player.message;

import java.util.List;

/// Interface `blobfinder`: patches of color in a picture, its origin at the top left [pixels].
public final class Blobfinder {
    public static final int BLOBS = 1;

    public static final int SET_COLOR = 1;
    public static final int SET_IMAGER = 2;
    public static final int COLOR = 3;

    private Blobfinder() {}

    /// @param color 0x00RRGGBB
    /// @param range how far it is [m]
    public record Blob(
            int id, int color, int area, int x, int y, int left, int right, int top, int bottom, float range) {}

    /// @param width of the picture; Stage tells 0 when it sees no blob
    public record Blobs(int width, int height, List<Blob> blobs) {}

    public record ColorRange(
            int channel, int minRed, int maxRed, int minGreen, int maxGreen, int minBlue, int maxBlue) {}

    /// @param brightness −1: as it was; so for all
    public record Imager(int brightness, int contrast, int colorMode, int autoGain) {}
}
