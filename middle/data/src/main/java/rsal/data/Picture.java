package rsal.data;

/// A reading that is an image, which people can be shown as such.
public interface Picture {
    /// Columns [px].
    int width();

    /// Rows [px].
    int height();

    /// Color of a pixel, columns from the left and rows from the top: 0xRRGGBB.
    int color(int column, int row);
}
