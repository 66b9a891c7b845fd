package rsal.ros2.image;

import java.awt.image.BufferedImage;
import java.awt.image.ComponentColorModel;
import java.awt.image.Raster;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.ByteOrder;
import java.util.Arrays;
import java.util.Objects;
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
        ImageReader reader = ImageIO.getImageReadersByFormatName(format(data)).next(); // which the JDK has
        try (var in = new MemoryCacheImageInputStream(new ByteArrayInputStream(data))) {
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
            BufferedImage image = reader.read(0);
            return new ImageMessage(
                    image.getWidth(),
                    image.getHeight(),
                    "rgb8",
                    ByteOrder.LITTLE_ENDIAN,
                    COLORS * image.getWidth(),
                    rgb(image));
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
