package rsal.ros2.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.SplittableRandom;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.ros2.image.CompressedImage.Unreadable;
import rsal.testkit.Rounds;

class CompressedImageTest {
    /// A square of one color on another one, large enough for the blocks of JPEG.
    private static BufferedImage image(int type) {
        var image = new BufferedImage(32, 16, type);
        for (int y = 0; y < 16; y++) {
            for (int x = 0; x < 32; x++) {
                image.setRGB(x, y, x < 16 ? 0xff2040c0 : 0xffe0e0e0);
            }
        }
        return image;
    }

    private static byte[] encoded(BufferedImage image, String format) throws IOException {
        var out = new ByteArrayOutputStream();
        assertThat(ImageIO.write(image, format, out)).isTrue();
        return out.toByteArray();
    }

    private static int[] pixel(ImageMessage image, int x, int y) {
        byte[] rgb = image.rgb().orElseThrow();
        int at = 3 * (y * image.width() + x);
        return new int[] {rgb[at] & 0xff, rgb[at + 1] & 0xff, rgb[at + 2] & 0xff};
    }

    @Test
    void jpegHasNearlyTheColorsThatItHad() throws Exception {
        ImageMessage read = CompressedImage.read(encoded(image(BufferedImage.TYPE_INT_RGB), "jpeg"));
        assertThat(read.width()).isEqualTo(32);
        assertThat(read.height()).isEqualTo(16);
        int[] left = pixel(read, 3, 8);
        for (int i = 0; i < 3; i++) {
            assertThat(left[i]).isBetween(new int[] {0x20, 0x40, 0xc0}[i] - 8, new int[] {0x20, 0x40, 0xc0}[i] + 8);
        }
    }

    @ParameterizedTest
    @ValueSource(
            ints = {
                BufferedImage.TYPE_INT_RGB,
                BufferedImage.TYPE_3BYTE_BGR,
                BufferedImage.TYPE_INT_ARGB,
                BufferedImage.TYPE_4BYTE_ABGR
            })
    void pngHasTheSameColors(int type) throws Exception {
        ImageMessage read = CompressedImage.read(encoded(image(type), "png"));
        assertThat(pixel(read, 3, 8)).containsExactly(0x20, 0x40, 0xc0);
        assertThat(pixel(read, 31, 15)).containsExactly(0xe0, 0xe0, 0xe0);
    }

    @Test
    void grayPaletteAndSixteenBitsAreReadToo() throws Exception {
        var gray = new BufferedImage(2, 1, BufferedImage.TYPE_BYTE_GRAY);
        gray.getRaster().setSample(1, 0, 0, 100);
        assertThat(pixel(CompressedImage.read(encoded(gray, "png")), 1, 0)).containsExactly(100, 100, 100);
        var deep = new BufferedImage(2, 1, BufferedImage.TYPE_USHORT_GRAY);
        deep.getRaster().setSample(1, 0, 0, 0x64ff);
        assertThat(pixel(CompressedImage.read(encoded(deep, "png")), 1, 0)).containsExactly(0x64, 0x64, 0x64);
        var palette = new BufferedImage(2, 1, BufferedImage.TYPE_BYTE_INDEXED);
        palette.setRGB(1, 0, 0xffff0000);
        assertThat(pixel(CompressedImage.read(encoded(palette, "png")), 1, 0)).containsExactly(255, 0, 0);
        var soft = new BufferedImage(32, 32, BufferedImage.TYPE_BYTE_GRAY);
        soft.getRaster().setSamples(0, 0, 32, 32, 0, filled(32 * 32, 100));
        assertThat(pixel(CompressedImage.read(encoded(soft, "jpeg")), 9, 9)[0]).isBetween(98, 102);
    }

    private static int[] filled(int count, int value) {
        var all = new int[count];
        Arrays.fill(all, value);
        return all;
    }

    @Test
    void whatIsNoImageOrTooLargeIsRefused() throws Exception {
        assertThatThrownBy(() -> CompressedImage.read(new byte[0])).hasMessage("it is neither JPEG nor PNG");
        assertThatThrownBy(() -> CompressedImage.read("GIF89a....".getBytes(StandardCharsets.US_ASCII)))
                .hasMessage("it is neither JPEG nor PNG");
        byte[] cut = encoded(image(BufferedImage.TYPE_INT_RGB), "png");
        assertThatThrownBy(() -> CompressedImage.read(Arrays.copyOf(cut, cut.length / 2)))
                .isInstanceOf(Unreadable.class)
                .hasMessageStartingWith("it is damaged");
        byte[] large = encoded(new BufferedImage(4096, 2049, BufferedImage.TYPE_BYTE_BINARY), "png");
        assertThat(large).as("it is small as a file").hasSizeLessThan(10_000);
        assertThatThrownBy(() -> CompressedImage.read(large))
                .hasMessage("it has 4096 × 2049 pixels; at most 8192 in a row, and 8388608 in all, are read");
        byte[] wide = encoded(new BufferedImage(8193, 1, BufferedImage.TYPE_BYTE_BINARY), "png");
        assertThatThrownBy(() -> CompressedImage.read(wide)).hasMessageContaining("8193 × 1 pixels");
    }

    private static byte[] depth(int type) throws Exception {
        byte[] png = encoded(image(type), "png");
        return ByteBuffer.allocate(12 + png.length)
                .order(ByteOrder.LITTLE_ENDIAN)
                .putInt(0)
                .putFloat(0)
                .putFloat(0)
                .put(png)
                .array();
    }

    @Test
    void depthThatCantBeIsRefused() throws Exception {
        assertThatThrownBy(() -> CompressedImage.readDepth(new byte[40], "16UC1; compressedDepth rvl"))
                .hasMessage("its depth is not a PNG");
        assertThatThrownBy(() -> CompressedImage.readDepth(new byte[3], "16UC1; compressedDepth png"))
                .hasMessage("its depth is not a PNG");
        assertThatThrownBy(() -> CompressedImage.readDepth(new byte[40], "rgb8; compressedDepth"))
                .hasMessage("depth is read in 16UC1 and 32FC1 only");
        byte[] colored = depth(BufferedImage.TYPE_INT_RGB);
        assertThatThrownBy(() -> CompressedImage.readDepth(colored, "16UC1; compressedDepth png"))
                .hasMessage("it is damaged (its depth has no 16 bits)");
    }

    @ParameterizedTest
    @ValueSource(strings = {"16UC1", "32FC1"})
    void damagedDepthIsReadOrRefused(String encoding) throws Exception {
        byte[] whole = depth(BufferedImage.TYPE_USHORT_GRAY);
        var random = new SplittableRandom(12);
        int refused = 0;
        for (int i = 0; i < Rounds.of(2_000, 1_000_000); i++) {
            byte[] damaged =
                    Arrays.copyOf(whole, random.nextInt(10) == 0 ? random.nextInt(whole.length) : whole.length);
            for (int change = random.nextInt(6); change >= 0 && damaged.length > 8; change--) {
                damaged[random.nextInt(damaged.length)] = (byte) random.nextInt();
            }
            try {
                ImageMessage image = CompressedImage.readDepth(damaged, encoding + "; compressedDepth png");
                assertThat(image.depth(image.width(), image.height()).orElseThrow())
                        .hasSize(2 * image.width() * image.height());
            } catch (Unreadable e) {
                refused++;
            }
        }
        assertThat(refused).isPositive();
    }

    @ParameterizedTest
    @ValueSource(strings = {"jpeg", "png"})
    void damagedImagesAreReadOrRefused(String format) throws Exception {
        byte[] whole = encoded(image(BufferedImage.TYPE_INT_RGB), format);
        var random = new SplittableRandom(11);
        int refused = 0;
        for (int i = 0; i < Rounds.of(2_000, 1_000_000); i++) {
            byte[] damaged =
                    Arrays.copyOf(whole, random.nextInt(10) == 0 ? random.nextInt(whole.length) : whole.length);
            for (int change = random.nextInt(6); change >= 0 && damaged.length > 8; change--) {
                damaged[4 + random.nextInt(damaged.length - 4)] = (byte) random.nextInt();
            }
            try {
                ImageMessage image = CompressedImage.read(damaged);
                assertThat(image.rgb().orElseThrow()).hasSize(3 * image.width() * image.height());
            } catch (Unreadable e) {
                refused++;
            }
        }
        assertThat(refused).isPositive();
    }
}
