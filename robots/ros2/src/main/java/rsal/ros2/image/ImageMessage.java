package rsal.ros2.image;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Optional;
import rsal.ros2.cdr.RosMessage;

/// A `sensor_msgs/Image`, row by row from the top.
///
/// @param width [px]
/// @param height [px]
/// @param encoding `rgb8`, `16UC1`, …
/// @param step from one row to the next [bytes]
/// @param data handed over
public record ImageMessage(int width, int height, String encoding, ByteOrder order, int step, byte[] data) {
    /// Of an image [px].
    public static final int LONGEST = 8_192;

    private static final double MILLIMETERS = 1_000; // in a meter
    private static final int FARTHEST = 0xffff; // mm

    /// Empty when its data are not those of such an image.
    public static Optional<ImageMessage> of(RosMessage message) {
        long width = message.integer("width");
        long height = message.integer("height");
        long step = message.integer("step");
        String encoding = message.text("encoding");
        byte[] data = message.get("data", byte[].class);
        int pixel = size(encoding);
        boolean isValid = pixel > 0
                && width > 0
                && height > 0
                && width <= LONGEST
                && height <= LONGEST
                && step >= width * pixel
                && step * height <= data.length;
        return isValid
                ? Optional.of(new ImageMessage(
                        (int) width,
                        (int) height,
                        encoding,
                        message.integer("is_bigendian") == 0 ? ByteOrder.LITTLE_ENDIAN : ByteOrder.BIG_ENDIAN,
                        (int) step,
                        data))
                : Optional.empty();
    }

    /// Of a pixel [bytes]; 0 when it is not known here.
    private static int size(String encoding) {
        return switch (encoding) {
            case "mono8", "8UC1" -> 1;
            case "16UC1", "mono16" -> 2;
            case "rgb8", "bgr8", "8UC3" -> 3;
            case "rgba8", "bgra8", "32FC1" -> 4;
            default -> 0;
        };
    }

    /// Red, green and blue of each pixel; empty when it has no colors.
    public Optional<byte[]> rgb() {
        return switch (encoding) {
            case "rgb8" -> Optional.of(rgb(0, 1, 2));
            case "bgr8", "8UC3" -> Optional.of(rgb(2, 1, 0));
            case "rgba8" -> Optional.of(rgb(0, 1, 2));
            case "bgra8" -> Optional.of(rgb(2, 1, 0));
            case "mono8", "8UC1" -> Optional.of(rgb(0, 0, 0));
            default -> Optional.empty();
        };
    }

    /// @param red where it is in a pixel
    /// @param green where it is in a pixel
    /// @param blue where it is in a pixel
    private byte[] rgb(int red, int green, int blue) {
        int pixel = size(encoding);
        var colors = new byte[3 * width * height];
        int at = 0;
        for (int row = 0; row < height; row++) {
            for (int from = row * step; from < row * step + width * pixel; from += pixel) {
                colors[at++] = data[from + red];
                colors[at++] = data[from + green];
                colors[at++] = data[from + blue];
            }
        }
        return colors;
    }

    /// Depth of each pixel, two bytes each, the lower one first [mm]; 0 for none. Empty when it has no depth.
    ///
    /// @param columns of the image wanted, of the same view
    /// @param rows of the image wanted
    public Optional<byte[]> depth(int columns, int rows) {
        boolean isMeters = encoding.equals("32FC1");
        if (!isMeters && size(encoding) != Short.BYTES) {
            return Optional.empty();
        }
        ByteBuffer bytes = ByteBuffer.wrap(data).order(order);
        ByteBuffer depths = ByteBuffer.allocate(2 * columns * rows).order(ByteOrder.LITTLE_ENDIAN);
        int pixel = size(encoding);
        for (int row = 0; row < rows; row++) {
            int begin = (int) ((long) row * height / rows) * step;
            for (int column = 0; column < columns; column++) {
                int at = begin + (int) ((long) column * width / columns) * pixel;
                depths.putShort(isMeters ? millimeters(bytes.getFloat(at)) : bytes.getShort(at));
            }
        }
        return Optional.of(depths.array());
    }

    /// @param meters NaN where there is nothing, as infinities (REP 118)
    private static short millimeters(float meters) {
        long rounded = Math.round(meters * MILLIMETERS);
        return (short) (meters > 0 && rounded <= FARTHEST ? rounded : 0);
    }
}
