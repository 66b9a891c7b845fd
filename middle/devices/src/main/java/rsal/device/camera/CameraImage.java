package rsal.device.camera;

import java.util.Objects;
import rsal.data.Picture;
import rsal.data.Unit;

/// An image of a camera without distortion (a pinhole). As `sensor_msgs/Image` in `rgb8` and `16UC1`, and
/// `sensor_msgs/CameraInfo` of ROS. Its optical axis goes through the middle of the image. Rows come from the top,
/// columns from the left.
///
/// @param width number of columns [px]
/// @param height number of rows [px]
/// @param focalLength of columns and of rows [px]
/// @param rgb red, green and blue of each pixel, row by row; not to be changed
/// @param depth along the optical axis, of each pixel, row by row: two bytes each, the lower one first [mm]; 0
/// where nothing is in range (REP 118 for `16UC1`); not to be changed
public record CameraImage(
        @Unit(value = "px", isFixed = true) int width,
        @Unit(value = "px", isFixed = true) int height,
        @Unit(value = "px", isFixed = true) double focalLength,
        byte[] rgb,
        byte[] depth)
        implements Picture {
    public CameraImage {
        long pixels = (long) width * height;
        if (width < 1 || height < 1 || rgb.length != 3 * pixels || depth.length != 2 * pixels) {
            throw new IllegalArgumentException("An image of %d × %d px has no %d bytes of color and %d of depth."
                    .formatted(width, height, rgb.length, depth.length));
        }
    }

    @Override
    public int color(int column, int row) {
        int at = 3 * pixel(column, row);
        return (rgb[at] & 0xff) << 16 | (rgb[at + 1] & 0xff) << 8 | (rgb[at + 2] & 0xff);
    }

    /// Depth along the optical axis [m]; +∞ where nothing is in range.
    public double depth(int column, int row) {
        int at = 2 * pixel(column, row);
        int millimeters = (depth[at] & 0xff) | (depth[at + 1] & 0xff) << 8;
        return millimeters == 0 ? Double.POSITIVE_INFINITY : millimeters * 1e-3;
    }

    private int pixel(int column, int row) {
        return Objects.checkIndex(row, height) * width + Objects.checkIndex(column, width);
    }
}
