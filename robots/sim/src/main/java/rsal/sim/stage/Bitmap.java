package rsal.sim.stage;

import java.util.BitSet;

/// Which pixels of an image are solid.
///
/// @param file it came from
/// @param solid row by row, the lowest first, `width · height` bits; handed over, not shared
public record Bitmap(String file, int width, int height, BitSet solid) {

    public boolean isSolid(int column, int row) {
        return column >= 0
                && column < width
                && row >= 0
                && row < height
                && solid.get(Math.addExact(Math.multiplyExact(row, width), column));
    }

    /// The smallest part that holds all that is solid; itself when nothing is.
    Bitmap trimmed() {
        int left = width;
        int right = -1;
        int bottom = height;
        int top = -1;
        for (int row = 0; row < height; row++) {
            int first = solid.nextSetBit(row * width);
            if (first >= 0 && first < (row + 1) * width) {
                int last = solid.previousSetBit((row + 1) * width - 1);
                left = Math.min(left, first - row * width);
                right = Math.max(right, last - row * width);
                bottom = Math.min(bottom, row);
                top = row;
            }
        }
        if (right < 0 || (right - left + 1 == width && top - bottom + 1 == height)) {
            return this;
        }
        int newWidth = right - left + 1;
        int newHeight = top - bottom + 1;
        var part = new BitSet(newWidth * newHeight);
        for (int row = 0; row < newHeight; row++) {
            int from = (row + bottom) * width + left;
            for (int i = solid.nextSetBit(from); i >= 0 && i < from + newWidth; i = solid.nextSetBit(i + 1)) {
                part.set(row * newWidth + i - from);
            }
        }
        return new Bitmap(file, newWidth, newHeight, part);
    }
}
