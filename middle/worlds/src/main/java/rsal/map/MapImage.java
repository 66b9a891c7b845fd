package rsal.map;

import java.awt.color.ColorSpace;
import java.awt.image.BufferedImage;
import java.awt.image.ComponentColorModel;
import java.awt.image.Raster;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.util.Arrays;
import java.util.Map;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.MemoryCacheImageInputStream;
import rsal.image.Strips;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;

/// A map's image turned into cells, the lowest row first.
///
/// @param unknownGray how many pixels have the gray that map_saver writes for unknown space
record MapImage(int width, int height, byte[] cells, int unknownGray) {
    /// What ROS's map_saver writes for unknown space, 0 (black) to 1 (white).
    static final double UNKNOWN_GRAY = 205 / 255.0;

    private static final double SAME_GRAY = 1e-6;

    /// 11,585 × 11,585: 570 m × 570 m at 0.05 m.
    static final int MAX_CELLS = 1 << 27;

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
            return cells(reader, shading);
        } catch (InvalidSettings e) {
            throw e;
        } catch (Strips.NotEnoughMemory e) {
            throw new InvalidSettings(
                    Location.of(name),
                    "The image can't be read: %s.".formatted(e.getMessage()),
                    Strips.NotEnoughMemory.REMEDY);
        } catch (IOException | RuntimeException e) { // a damaged image can make ImageIO throw almost anything
            throw broken(name, String.valueOf(e.getMessage()));
        } finally {
            reader.dispose();
        }
    }

    private static MapImage cells(ImageReader reader, Shading shading) throws IOException {
        var cells = new Cells(reader.getWidth(0), reader.getHeight(0), shading);
        Strips.read(reader, (strip, firstRow) -> {
            for (int line = 0; line < strip.getHeight(); line++) {
                int row = cells.height - 1 - firstRow - line;
                if (isGray(strip)) {
                    grayRow(strip.getRaster(), line, cells, row);
                } else {
                    colorRow(strip, line, cells, row);
                }
            }
        });
        return cells.image();
    }

    private static boolean isGray(BufferedImage image) {
        return image.getColorModel() instanceof ComponentColorModel model
                && model.getColorSpace().getType() == ColorSpace.TYPE_GRAY;
    }

    private static void colorRow(BufferedImage image, int line, Cells cells, int row) {
        boolean alpha = image.getColorModel().hasAlpha();
        for (int column = 0; column < cells.width; column++) {
            int argb = image.getRGB(column, line);
            double mean = ((argb >> 16 & 0xff) + (argb >> 8 & 0xff) + (argb & 0xff)) / (3 * 255.0);
            if (alpha) {
                cells.set(column, row, mean, (argb >>> 24) / 255.0);
            } else {
                cells.set(column, row, mean);
            }
        }
    }

    /// As the file has it: Java takes gray for linear and would make colors of it that are lighter.
    private static void grayRow(Raster raster, int line, Cells cells, int row) {
        double white = (1 << raster.getSampleModel().getSampleSize(0)) - 1;
        boolean alpha = raster.getNumBands() > 1;
        for (int column = 0; column < cells.width; column++) {
            double brightness = raster.getSample(column, line, 0) / white;
            if (alpha) {
                cells.set(column, row, brightness, raster.getSample(column, line, 1) / white);
            } else {
                cells.set(column, row, brightness);
            }
        }
    }

    /// What pixels become, cell by cell.
    static final class Cells {
        private final int width;
        private final int height;
        private final Shading shading;
        private final byte[] cells;
        private int unknownGray;

        Cells(int width, int height, Shading shading) {
            this.width = width;
            this.height = height;
            this.shading = shading;
            this.cells = new byte[width * height];
        }

        /// @param row from the lowest
        /// @param brightness 0 (black) to 1 (white)
        void set(int column, int row, double brightness) {
            count(brightness);
            cells[row * width + column] = shading.cell(brightness);
        }

        /// @param opaque 0 (not to be seen) to 1
        void set(int column, int row, double brightness, double opaque) {
            count(brightness);
            cells[row * width + column] = shading.cell(brightness, opaque);
        }

        private void count(double brightness) {
            if (Math.abs(brightness - UNKNOWN_GRAY) < SAME_GRAY) {
                unknownGray++;
            }
        }

        MapImage image() {
            return new MapImage(width, height, cells, unknownGray);
        }
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
