package rsal.ros2.image;

import java.awt.image.BufferedImage;
import java.awt.image.ComponentColorModel;
import java.awt.image.Raster;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import java.util.Objects;
import java.util.function.Function;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.MemoryCacheImageInputStream;

/// Decodes what `sensor_msgs/CompressedImage` has: JPEG or PNG, told apart by their first bytes, as drivers call them
/// in many ways.
public final class CompressedImage {
    /// Of an image: somewhat more than 3840 × 2160.
    public static final int MOST_PIXELS = 1 << 23;

    private static final byte[] JPEG = {(byte) 0xff, (byte) 0xd8, (byte) 0xff};
    private static final byte[] PNG = {(byte) 0x89, 'P', 'N', 'G'};
    private static final int COLORS = 3; // in a pixel
    private static final int DEPTH_HEADER = 12; // bytes: an int, and two floats

    private CompressedImage() {}

    /// An image that can't be decoded. Its message says why.
    public static final class Unreadable extends Exception {
        private static final long serialVersionUID = 1;

        Unreadable(String why) {
            super(why);
        }
    }

    /// @return the image in `rgb8`; gray ones have three equal colors, transparency is ignored
    public static ImageMessage read(byte[] data) throws Unreadable {
        return decode(
                data,
                0,
                format(data),
                image -> new ImageMessage(
                        image.getWidth(),
                        image.getHeight(),
                        "rgb8",
                        ByteOrder.LITTLE_ENDIAN,
                        COLORS * image.getWidth(),
                        rgb(image)));
    }

    /// Depth, as `compressed_depth_image_transport` sends it: 12 bytes, then PNG with 16 bits for each pixel.
    /// These are millimeters for `16UC1`. For `32FC1`, they are a / depth + b, and 0 where there is nothing; the
    /// bytes in front have a and b.
    ///
    /// @param format `32FC1; compressedDepth png`
    /// @return the image in the encoding of the format
    public static ImageMessage readDepth(byte[] data, String format) throws Unreadable {
        String encoding = format.split(";", 2)[0].strip();
        boolean isMeters = encoding.equals("32FC1");
        if (!isMeters && !encoding.equals("16UC1")) {
            throw new Unreadable("depth is read in 16UC1 and 32FC1 only");
        }
        if (data.length <= DEPTH_HEADER + PNG.length
                || !Arrays.equals(data, DEPTH_HEADER, DEPTH_HEADER + PNG.length, PNG, 0, PNG.length)) {
            throw new Unreadable("its depth is not a PNG");
        }
        ByteBuffer header = ByteBuffer.wrap(data).order(ByteOrder.LITTLE_ENDIAN);
        float a = header.getFloat(Integer.BYTES);
        float b = header.getFloat(Integer.BYTES + Float.BYTES);
        return decode(data, DEPTH_HEADER, "png", image -> {
            Raster raster = image.getRaster();
            if (raster.getNumBands() != 1 || raster.getSampleModel().getSampleSize(0) != Short.SIZE) {
                throw new IllegalArgumentException("its depth has no 16 bits");
            }
            int pixel = isMeters ? Float.BYTES : Short.BYTES;
            ByteBuffer depths = ByteBuffer.allocate(pixel * raster.getWidth() * raster.getHeight())
                    .order(ByteOrder.LITTLE_ENDIAN);
            int[] row = new int[raster.getWidth()];
            for (int y = 0; y < raster.getHeight(); y++) {
                raster.getPixels(raster.getMinX(), raster.getMinY() + y, row.length, 1, row);
                for (int value : row) {
                    if (isMeters) {
                        depths.putFloat(value == 0 ? Float.NaN : a / (value - b));
                    } else {
                        depths.putShort((short) value);
                    }
                }
            }
            return new ImageMessage(
                    row.length,
                    raster.getHeight(),
                    encoding,
                    ByteOrder.LITTLE_ENDIAN,
                    pixel * row.length,
                    depths.array());
        });
    }

    /// @param from where it begins in the data
    private static ImageMessage decode(
            byte[] data, int from, String format, Function<BufferedImage, ImageMessage> converter) throws Unreadable {
        ImageReader reader = ImageIO.getImageReadersByFormatName(format).next(); // which the JDK has
        try (var in = new MemoryCacheImageInputStream(new ByteArrayInputStream(data, from, data.length - from))) {
            reader.setInput(in, true, true);
            long width = reader.getWidth(0);
            long height = reader.getHeight(0);
            if (width < 1
                    || height < 1
                    || width > ImageMessage.LONGEST
                    || height > ImageMessage.LONGEST
                    || width * height > MOST_PIXELS) {
                throw new Unreadable("it has %d × %d pixels; at most %d in a row, and %d in all, are read"
                        .formatted(width, height, ImageMessage.LONGEST, MOST_PIXELS));
            }
            return converter.apply(reader.read(0));
        } catch (IOException | RuntimeException e) { // a damaged image can make ImageIO throw almost anything
            throw new Unreadable("it is damaged (%s)"
                    .formatted(Objects.requireNonNullElse(
                            e.getMessage(), e.getClass().getSimpleName())));
        } finally {
            reader.dispose();
        }
    }

    private static String format(byte[] data) throws Unreadable {
        if (begins(data, JPEG)) {
            return "jpeg";
        }
        if (begins(data, PNG)) {
            return "png";
        }
        throw new Unreadable("it is neither JPEG nor PNG");
    }

    private static boolean begins(byte[] data, byte[] with) {
        return data.length > with.length && Arrays.equals(data, 0, with.length, with, 0, with.length);
    }

    private static byte[] rgb(BufferedImage image) {
        var colors = new byte[COLORS * image.getWidth() * image.getHeight()];
        if (image.getColorModel() instanceof ComponentColorModel) {
            copySamples(image.getRaster(), colors);
        } else {
            copyColors(image, colors);
        }
        return colors;
    }

    /// As they are stored: `BufferedImage` would change the brightness of gray ones.
    private static void copySamples(Raster raster, byte[] to) {
        int bands = raster.getNumBands();
        int shift = raster.getSampleModel().getSampleSize(0) - Byte.SIZE;
        int green = bands < COLORS ? 0 : 1; // gray has one band, or another one for transparency
        int blue = bands < COLORS ? 0 : 2;
        int[] row = new int[bands * raster.getWidth()];
        int at = 0;
        for (int y = 0; y < raster.getHeight(); y++) {
            raster.getPixels(raster.getMinX(), raster.getMinY() + y, raster.getWidth(), 1, row);
            for (int i = 0; i < row.length; i += bands) {
                to[at++] = (byte) (row[i] >> shift);
                to[at++] = (byte) (row[i + green] >> shift);
                to[at++] = (byte) (row[i + blue] >> shift);
            }
        }
    }

    /// Of a palette.
    private static void copyColors(BufferedImage image, byte[] to) {
        int[] row = new int[image.getWidth()];
        int at = 0;
        for (int y = 0; y < image.getHeight(); y++) {
            image.getRGB(0, y, row.length, 1, row, 0, row.length);
            for (int color : row) {
                to[at++] = (byte) (color >> 16);
                to[at++] = (byte) (color >> 8);
                to[at++] = (byte) color;
            }
        }
    }
}
