package rsal.map;

import java.awt.color.ColorSpace;
import java.awt.image.BufferedImage;
import java.awt.image.ComponentColorModel;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.MemoryCacheImageInputStream;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;

/// A map's picture turned into cells, the lowest row first.
record MapImage(int width, int height, byte[] cells) {
    /// A square kilometer at 0.125 m, or 400 m × 400 m at 0.05 m.
    static final int MAX_CELLS = 1 << 26;

    private static final byte[] PNG = {(byte) 0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};

    /// Reads a PNG or PGM (P2, P5).
    ///
    /// @param name the file's, for messages
    /// @throws InvalidSettings when it is none, broken, or too large
    static MapImage read(String name, byte[] bytes, Shading shading) {
        if (bytes.length >= PNG.length && java.util.Arrays.equals(bytes, 0, PNG.length, PNG, 0, PNG.length)) {
            return png(name, bytes, shading);
        }
        if (bytes.length >= 2 && bytes[0] == 'P' && (bytes[1] == '2' || bytes[1] == '5')) {
            return new Pgm(name, bytes).read(shading);
        }
        throw broken(name, "it is neither a PNG nor a PGM image");
    }

    private static MapImage png(String name, byte[] bytes, Shading shading) {
        ImageReader reader = ImageIO.getImageReadersByFormatName("png").next();
        try (var in = new MemoryCacheImageInputStream(new ByteArrayInputStream(bytes))) {
            reader.setInput(in, true, true);
            checkSize(name, reader.getWidth(0), reader.getHeight(0));
            return cells(reader.read(0), shading);
        } catch (InvalidSettings e) {
            throw e;
        } catch (IOException | RuntimeException e) { // a damaged PNG can make ImageIO throw almost anything
            throw broken(name, String.valueOf(e.getMessage()));
        } finally {
            reader.dispose();
        }
    }

    private static MapImage cells(BufferedImage image, Shading shading) {
        int width = image.getWidth();
        int height = image.getHeight();
        boolean gray = image.getColorModel() instanceof ComponentColorModel model
                && model.getColorSpace().getType() == ColorSpace.TYPE_GRAY;
        var cells = new byte[width * height];
        for (int row = 0; row < height; row++) {
            for (int column = 0; column < width; column++) {
                int line = height - 1 - row;
                cells[row * width + column] =
                        gray ? grayCell(image, column, line, shading) : colorCell(image.getRGB(column, line), shading);
            }
        }
        return new MapImage(width, height, cells);
    }

    private static byte colorCell(int argb, Shading shading) {
        int sum = (argb >> 16 & 0xff) + (argb >> 8 & 0xff) + (argb & 0xff);
        return shading.cell(sum / (3 * 255.0), argb >>> 24 == 0xff);
    }

    /// As the file has it: Java takes gray for linear and would make colors of it that are lighter.
    private static byte grayCell(BufferedImage image, int x, int y, Shading shading) {
        var raster = image.getRaster();
        double white = (1 << raster.getSampleModel().getSampleSize(0)) - 1;
        boolean opaque = raster.getNumBands() == 1 || raster.getSample(x, y, 1) == white;
        return shading.cell(raster.getSample(x, y, 0) / white, opaque);
    }

    static void checkSize(String name, long width, long height) {
        if (width < 1 || height < 1 || width > MAX_CELLS || height > MAX_CELLS || width * height > MAX_CELLS) {
            throw new InvalidSettings(
                    Location.of(name),
                    "The image has %d × %d pixels; 1 to %d are read.".formatted(width, height, MAX_CELLS),
                    "Use a coarser resolution.");
        }
    }

    static InvalidSettings broken(String name, String why) {
        return new InvalidSettings(
                Location.of(name),
                "The image can't be read: %s.".formatted(why),
                "Maybe it was cut short, or is another kind of file.");
    }
}
