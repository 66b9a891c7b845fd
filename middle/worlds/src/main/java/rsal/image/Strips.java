package rsal.image;

import java.awt.Rectangle;
import java.awt.image.BufferedImage;
import java.io.IOException;
import javax.imageio.ImageReadParam;
import javax.imageio.ImageReader;

/// Reads an image strip by strip, so that a large one is never in memory as a whole: 64 MB in place of 512 MB for a PNG
/// of 8,192 × 8,192 pixels with colors and opacity of 16 bits. Each strip is decoded from the image's beginning; most
/// images are one strip.
@SuppressWarnings("exports") // the types of AWT are for the packages of this module alone
public final class Strips {
    private static final int MOST_BYTES = 1 << 26; // of a strip

    private Strips() {}

    /// Takes one strip.
    public interface Taker {
        /// @param firstRow of the strip in the image, from the top
        void take(BufferedImage strip, int firstRow);
    }

    /// @param reader whose input is set
    /// @throws IOException when the image is broken, or has more pixels than there is memory for
    public static void read(ImageReader reader, Taker taker) throws IOException {
        read(reader, MOST_BYTES, taker);
    }

    /// @param most bytes of a strip
    static void read(ImageReader reader, int most, Taker taker) throws IOException {
        try {
            int width = reader.getWidth(0);
            int height = reader.getHeight(0);
            long bits = (long) width * bitsPerPixel(reader);
            int rows = Math.clamp(8L * most / bits, 1, height);
            for (int first = 0; first < height; first += rows) {
                ImageReadParam strip = reader.getDefaultReadParam();
                strip.setSourceRegion(new Rectangle(0, first, width, Math.min(rows, height - first)));
                taker.take(reader.read(0, strip), first);
            }
        } catch (OutOfMemoryError e) {
            throw new NotEnoughMemory(e);
        } catch (IOException | RuntimeException e) { // readers of images catch errors, too
            for (Throwable why = e; why != null; why = why.getCause()) {
                if (why instanceof OutOfMemoryError) {
                    throw new NotEnoughMemory(e);
                }
            }
            throw e;
        }
    }

    private static int bitsPerPixel(ImageReader reader) throws IOException {
        return reader.getImageTypes(0).next().getColorModel().getPixelSize();
    }

    /// The image may be whole, but Java's heap has no room for it.
    public static final class NotEnoughMemory extends IOException {
        private static final long serialVersionUID = 1;

        /// What to try.
        public static final String REMEDY =
                "Use an image with fewer pixels, or give Java more memory: JAVA_TOOL_OPTIONS=-Xmx4g.";

        NotEnoughMemory(Throwable cause) {
            super("there is not enough memory for its pixels", cause);
        }
    }
}
