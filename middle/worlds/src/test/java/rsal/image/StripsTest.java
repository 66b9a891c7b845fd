package rsal.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.Random;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.MemoryCacheImageInputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class StripsTest {
    private static ImageReader reader(String format, int type, int width, int height, long seed) throws IOException {
        var random = new Random(seed);
        var image = new BufferedImage(width, height, type);
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                image.setRGB(x, y, random.nextInt());
            }
        }
        var bytes = new ByteArrayOutputStream();
        assertThat(ImageIO.write(image, format, bytes)).isTrue();
        ImageReader reader = ImageIO.getImageReadersByFormatName(format).next();
        reader.setInput(new MemoryCacheImageInputStream(new ByteArrayInputStream(bytes.toByteArray())), true, true);
        return reader;
    }

    @ParameterizedTest
    @CsvSource({
        "png, 2, 7", // ARGB
        "png, 1, 1",
        "png, 10, 5", // gray
        "png, 11, 9", // gray of 16 bits
        "png, 12, 3", // one bit
        "png, 13, 40", // a palette
        "gif, 13, 6",
        "bmp, 1, 4",
        "jpeg, 10, 8",
        "jpeg, 1, 11"
    })
    void stripsAreTheWholeImage(String format, int type, int mostRows) throws IOException {
        int width = 53;
        int height = 41;
        ImageReader whole = reader(format, type, width, height, 3);
        BufferedImage expected = whole.read(0);
        ImageReader reader = reader(format, type, width, height, 3);
        int most = mostRows * width * expected.getColorModel().getPixelSize() / 8;
        var seen = new boolean[height];
        Strips.read(reader, most, (strip, first) -> {
            assertThat(strip.getHeight()).isLessThanOrEqualTo(mostRows);
            for (int y = 0; y < strip.getHeight(); y++) {
                assertThat(seen[first + y]).isFalse();
                seen[first + y] = true;
                for (int x = 0; x < width; x++) {
                    assertThat(strip.getRGB(x, y)).isEqualTo(expected.getRGB(x, first + y));
                }
            }
        });
        assertThat(seen).doesNotContain(false);
    }

    @Test
    void anExhaustedHeapIsNotABrokenImage() throws IOException {
        ImageReader reader = reader("png", BufferedImage.TYPE_BYTE_GRAY, 9, 9, 1);
        assertThatExceptionOfType(Strips.NotEnoughMemory.class)
                .isThrownBy(() -> Strips.read(reader, (_, _) -> {
                    throw new OutOfMemoryError();
                }))
                .withMessageContaining("not enough memory");
    }
}
