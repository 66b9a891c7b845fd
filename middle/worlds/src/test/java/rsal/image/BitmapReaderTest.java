package rsal.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.image.BitmapReader.Unreadable;

/// Which pixels are solid.
class BitmapReaderTest {
    @ParameterizedTest
    @ValueSource(
            strings = {
                "P1\n# a comment\n3 2\n1 0 1\n001",
                "P2 3 2 255 0 128 127 255 255 100",
                "P2 3 2 9 4 5 0 9 9 4",
                "P3 3 2 255 0 255 255  255 0 0  1 1 1  255 0 0  200 0 0  9 9 9",
                "P4 3 2\n\u00a0 ",
                "P5 3 2 255\n\u0000\u0080\u007f\u00ff\u00ff\u0001",
                "P5 3 2 65535\n\u0000\u00ff\u0080\u0000\u007f\u00ff\u00ff\u0000\u00ff\u0000\u0001\u0000",
                "P6 3 2 255\n\u0000\u00ff\u00ff\u00ff\u0000\u0000\u0001\u0001\u0001\u00ff\u0000\u0000\u00c8\u0000\u0000\u0009\u0009\u0009"
            })
    void portableImagesAreReadByTheirFirstChannel(String image) throws Unreadable {
        assertThat(drawn(image.getBytes(StandardCharsets.ISO_8859_1))).isEqualTo("#.#\n..#");
    }

    @ParameterizedTest
    @CsvSource({"png, 1", "png, 2", "png, 5", "png, 6", "png, 10", "png, 11", "png, 12", "png, 13", "bmp, 1", "bmp, 13"
    })
    void picturesAreReadByTheirFirstChannel(String format, int type) throws Unreadable, IOException {
        var image = new BufferedImage(3, 2, type);
        int[][] colors = {{0xff000000, 0xffffffff, 0xff00ff00}, {0xffff0000, 0xffff00ff, 0xff0000ff}};
        boolean gray = type == 10 || type == 11 || type == 12;
        for (int y = 0; y < 2; y++) {
            for (int x = 0; x < 3; x++) {
                int red = colors[y][x] >> 16 & 0xff;
                image.setRGB(x, y, gray ? 0xff000000 | red * 0x010101 : colors[y][x]);
            }
        }
        var out = new ByteArrayOutputStream();
        assertThat(ImageIO.write(image, format, out)).isTrue();
        assertThat(drawn(out.toByteArray())).isEqualTo("#.#\n..#");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "what            | it is not an image of a known kind (PNG, GIF, JPEG, BMP, TIFF, PBM, PGM, PPM)",
                "P2 0 3 255      | it has 0 × 3 pixels; 1 to 134217728 are read",
                "P5 60000 60000 255 | it has 60000 × 60000 pixels; 1 to 134217728 are read",
                "P2 2 2 255 0 0  | it ends early",
                "P2 2 2 0 0 0    | its brightest value is '0', not 1 to 65535",
                "P2 x            | a number is missing in it",
                "P2 99999999999  | it has a number that is too large",
                "P1 1 1 2        | a bit is neither 0 nor 1"
            })
    void whatIsNoImageIsRefused(String bytes, String why) {
        assertThatExceptionOfType(Unreadable.class)
                .isThrownBy(() -> BitmapReader.read(bytes.getBytes(StandardCharsets.ISO_8859_1)))
                .withMessage(why);
    }

    @Test
    void anEmptyFileIsNoImage() {
        assertThatExceptionOfType(Unreadable.class)
                .isThrownBy(() -> BitmapReader.read(new byte[0]))
                .withMessage("it is empty");
    }

    @Test
    void anImageOfTooManyPixelsIsNotTakenForABrokenOne() {
        assertThatExceptionOfType(Unreadable.class)
                .isThrownBy(() -> BitmapReader.read("P5 60000 60000 255".getBytes(StandardCharsets.US_ASCII)))
                .satisfies(e -> assertThat(e.remedy()).startsWith("Use one of another size"));
    }

    @Test
    void aBrokenPictureIsRefused() throws IOException {
        var out = new ByteArrayOutputStream();
        ImageIO.write(new BufferedImage(50, 50, BufferedImage.TYPE_INT_RGB), "png", out);
        byte[] bytes = Arrays.copyOf(out.toByteArray(), 50);
        assertThatExceptionOfType(Unreadable.class)
                .isThrownBy(() -> BitmapReader.read(bytes))
                .withMessageStartingWith("it is broken");
    }

    private static String drawn(byte[] bytes) throws Unreadable {
        Bitmap bitmap = BitmapReader.read(bytes);
        var lines = new ArrayList<String>();
        for (int row = bitmap.height() - 1; row >= 0; row--) {
            var line = new StringBuilder();
            for (int column = 0; column < bitmap.width(); column++) {
                line.append(bitmap.isSolid(column, row) ? '#' : '.');
            }
            lines.add(line.toString());
        }
        return String.join("\n", lines);
    }
}
