package rsal.map;

import java.awt.color.ColorSpace;
import java.awt.image.BufferedImage;
import java.awt.image.ComponentColorModel;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.util.Arrays;
import java.util.Map;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.MemoryCacheImageInputStream;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;

/// A map's picture turned into cells, the lowest row first.
record MapImage(int width, int height, byte[] cells) {
    /// A square kilometer at 0.125 m, or 400 m × 400 m at 0.05 m.
    static final int MAX_CELLS = 1 << 26;

    /// How files of the formats that Java reads begin.
    private static final Map<String, byte[]> FORMATS = Map.of(
            "png", new byte[] {(byte) 0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'},
            "bmp", new byte[] {'B', 'M'},
            "gif", new byte[] {'G', 'I', 'F', '8'},
            "jpeg", new byte[] {(byte) 0xff, (byte) 0xd8, (byte) 0xff});

    /// Reads a PGM (P2, P5), PNG, BMP, GIF or JPEG.
    ///
    /// @param name the file's, for messages
    /// @throws InvalidSettings when it is none, broken, or too large
    static MapImage read(String name, byte[] bytes, Shading shading) {
        if (bytes.length >= 2 && bytes[0] == 'P' && (bytes[1] == '2' || bytes[1] == '5')) {
            return new Pgm(name, bytes).read(shading);
        }
        return FORMATS.entrySet().stream()
                .filter(format -> format.getValue().length <= bytes.length
                        && Arrays.equals(
                                bytes, 0, format.getValue().length, format.getValue(), 0, format.getValue().length))
                .findFirst()
                .map(format -> read(name, bytes, format.getKey(), shading))
                .orElseThrow(() -> broken(name, "it is neither a PGM, PNG, BMP, GIF nor JPEG image"));
    }

    private static MapImage read(String name, byte[] bytes, String format, Shading shading) {
        ImageReader reader = ImageIO.getImageReadersByFormatName(format).next();
        try (var in = new MemoryCacheImageInputStream(new ByteArrayInputStream(bytes))) {
            reader.setInput(in, true, true);
            checkSize(name, reader.getWidth(0), reader.getHeight(0));
            return cells(reader.read(0), shading);
        } catch (InvalidSettings e) {
            throw e;
        } catch (IOException | RuntimeException e) { // a damaged image can make ImageIO throw almost anything
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
                        gray ? grayCell(image, column, line, shading) : colorCell(image, column, line, shading);
            }
        }
        return new MapImage(width, height, cells);
    }

    private static byte colorCell(BufferedImage image, int x, int y, Shading shading) {
        int argb = image.getRGB(x, y);
        double mean = ((argb >> 16 & 0xff) + (argb >> 8 & 0xff) + (argb & 0xff)) / (3 * 255.0);
        return image.getColorModel().hasAlpha() ? shading.cell(mean, (argb >>> 24) / 255.0) : shading.cell(mean);
    }

    /// As the file has it: Java takes gray for linear and would make colors of it that are lighter.
    private static byte grayCell(BufferedImage image, int x, int y, Shading shading) {
        var raster = image.getRaster();
        double white = (1 << raster.getSampleModel().getSampleSize(0)) - 1;
        double brightness = raster.getSample(x, y, 0) / white;
        return raster.getNumBands() == 1
                ? shading.cell(brightness)
                : shading.cell(brightness, raster.getSample(x, y, 1) / white);
    }

    static void checkSize(String name, long width, long height) {
        if (width < 1 || height < 1) {
            throw new InvalidSettings(
                    Location.of(name),
                    "The image has %d × %d pixels: there is nothing in it.".formatted(width, height),
                    "");
        }
        if (width > MAX_CELLS || height > MAX_CELLS || width * height > MAX_CELLS) {
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
