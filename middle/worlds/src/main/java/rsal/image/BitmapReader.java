package rsal.image;

import java.awt.image.BufferedImage;
import java.awt.image.ComponentColorModel;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.util.BitSet;
import java.util.Iterator;
import java.util.Objects;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.MemoryCacheImageInputStream;

/// Reads which pixels of an image are solid: those whose first channel (red, or gray) is dark. PNG, GIF, JPEG, BMP,
/// TIFF and the portable formats (PBM, PGM, PPM) are known.
public final class BitmapReader {
    /// Of one image: 11,585 × 11,585, or 570 m × 570 m at 0.05 m.
    public static final int MAX_PIXELS = 1 << 27;

    private BitmapReader() {}

    /// Solid is what is at most half as bright as can be, as in Stage.
    ///
    /// @throws Unreadable when it is not an image, broken, or too large
    public static Bitmap read(byte[] bytes) throws Unreadable {
        return read(bytes, 0.5);
    }

    /// @param threshold how bright a pixel may be to be solid, 0 (black) to 1 (white)
    /// @throws Unreadable when it is not an image, broken, or too large
    public static Bitmap read(byte[] bytes, double threshold) throws Unreadable {
        if (bytes.length == 0) {
            throw new Unreadable("it is empty");
        }
        if (bytes.length >= 2 && bytes[0] == 'P' && bytes[1] >= '1' && bytes[1] <= '6') {
            return new PortableImage(bytes, threshold).read();
        }
        try (var in = new MemoryCacheImageInputStream(new ByteArrayInputStream(bytes))) {
            Iterator<ImageReader> readers = ImageIO.getImageReaders(in);
            if (!readers.hasNext()) {
                throw new Unreadable("it is not an image of a known kind (PNG, GIF, JPEG, BMP, TIFF, PBM, PGM, PPM)");
            }
            ImageReader reader = readers.next();
            try {
                reader.setInput(in, true, true);
                checkSize(reader.getWidth(0), reader.getHeight(0));
                return bitmap(reader, threshold);
            } finally {
                reader.dispose();
            }
        } catch (Strips.NotEnoughMemory e) {
            throw new Unreadable(String.valueOf(e.getMessage()), Strips.NotEnoughMemory.REMEDY);
        } catch (IOException | RuntimeException e) { // a damaged image can make ImageIO throw almost anything
            throw new Unreadable("it is broken (%s)"
                    .formatted(Objects.requireNonNullElse(
                            e.getMessage(), e.getClass().getSimpleName())));
        }
    }

    private static Bitmap bitmap(ImageReader reader, double threshold) throws IOException {
        int width = reader.getWidth(0);
        int height = reader.getHeight(0);
        var solid = new BitSet(width * height);
        Strips.read(reader, (strip, firstRow) -> add(strip, firstRow, height, threshold, solid));
        return new Bitmap(width, height, solid);
    }

    /// @param height of the whole image, whose lowest row is the first of the bitmap
    private static void add(BufferedImage image, int firstRow, int height, double threshold, BitSet solid) {
        int width = image.getWidth();
        boolean asStored = image.getColorModel() instanceof ComponentColorModel;
        int brightest = asStored ? (1 << image.getSampleModel().getSampleSize(0)) - 1 : 255;
        for (int line = 0; line < image.getHeight(); line++) {
            int row = height - 1 - firstRow - line;
            for (int column = 0; column < width; column++) {
                int first = asStored
                        ? image.getRaster().getSample(column, line, 0)
                        : image.getRGB(column, line) >> 16 & 0xff;
                solid.set(row * width + column, isSolid(first, brightest, threshold));
            }
        }
    }

    static boolean isSolid(int first, int brightest, double threshold) {
        return first <= threshold * brightest;
    }

    static void checkSize(long width, long height) throws Unreadable {
        if (width < 1 || height < 1 || width > MAX_PIXELS || height > MAX_PIXELS || width * height > MAX_PIXELS) {
            throw new Unreadable(
                    "it has %d × %d pixels; 1 to %d are read".formatted(width, height, MAX_PIXELS),
                    "Use one of another size; worlds need no finer pixels than what robots can meet.");
        }
    }

    /// Why an image can't be read.
    public static final class Unreadable extends Exception {
        private static final long serialVersionUID = 1;

        private final String remedy;

        Unreadable(String why) {
            this(why, "Maybe it was cut short, or is another kind of file.");
        }

        Unreadable(String why, String remedy) {
            super(why);
            this.remedy = remedy;
        }

        public String why() {
            return String.valueOf(getMessage());
        }

        /// What to try.
        public String remedy() {
            return remedy;
        }
    }
}
