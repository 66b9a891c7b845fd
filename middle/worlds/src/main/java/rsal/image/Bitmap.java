package rsal.image;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;

/// Which pixels of an image are solid.
///
/// @param solid row by row, the lowest first, `width · height` bits; handed over, not shared
public record Bitmap(int width, int height, BitSet solid) {

    public boolean isSolid(int column, int row) {
        return column >= 0
                && column < width
                && row >= 0
                && row < height
                && solid.get(Math.addExact(Math.multiplyExact(row, width), column));
    }

    /// The smallest part that holds all that is solid; itself when nothing is.
    public Bitmap trimmed() {
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
        return new Bitmap(newWidth, newHeight, part);
    }

    /// All that is solid as rectangles: runs of pixels in a row, grown upwards while the rows above have them,
    /// too.
    ///
    /// @param most how many are enough; the list ends after one more
    /// @return for each its first column, the column behind its last, and the same of its rows
    public List<int[]> rectangles(int most) {
        var found = new ArrayList<int[]>();
        var left = (BitSet) solid.clone();
        for (int i = left.nextSetBit(0); i >= 0 && found.size() <= most; i = left.nextSetBit(i)) {
            int row = i / width;
            int first = i % width;
            int end = Math.min(left.nextClearBit(i), (row + 1) * width) - row * width;
            int top = row;
            while (top < height
                    && left.get(top * width + first)
                    && left.nextClearBit(top * width + first) >= top * width + end) {
                left.clear(top * width + first, top * width + end);
                top++;
            }
            found.add(new int[] {first, end, row, top});
        }
        return found;
    }

    /// The same after so many quarter turns, counter-clockwise.
    public Bitmap turned(int quarters) {
        int turns = Math.floorMod(quarters, 4);
        if (turns == 0) {
            return this;
        }
        var turned = new BitSet(width * height);
        for (int i = solid.nextSetBit(0); i >= 0; i = solid.nextSetBit(i + 1)) {
            int column = i % width;
            int row = i / width;
            turned.set(
                    switch (turns) {
                        case 1 -> column * height + (height - 1 - row);
                        case 2 -> (height - 1 - row) * width + (width - 1 - column);
                        default -> (width - 1 - column) * height + row;
                    });
        }
        return turns == 2 ? new Bitmap(width, height, turned) : new Bitmap(height, width, turned);
    }
}
