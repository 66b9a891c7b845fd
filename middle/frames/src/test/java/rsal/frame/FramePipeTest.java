package rsal.frame;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class FramePipeTest {
    record Place(double x, String name) {}

    private static byte[] written(FramePipe.Content... contents) throws IOException {
        var bytes = new ByteArrayOutputStream();
        var frames = new FramePipe(new ByteArrayInputStream(new byte[0]), bytes);
        for (FramePipe.Content content : contents) {
            frames.write(content);
        }
        return bytes.toByteArray();
    }

    private static FramePipe reader(byte[] bytes) {
        return new FramePipe(new ByteArrayInputStream(bytes), new ByteArrayOutputStream());
    }

    @Test
    void wordsAndArraysAreReadAsTheyWereWritten() throws IOException {
        byte[] bytes = written(
                to -> to.put("place", new Place(Double.POSITIVE_INFINITY, "läb"))
                        .put("some", List.of(1, 2))
                        .put("map", Map.of("b", 1, "a", 2)),
                to -> to.put("ranges", new float[] {1.5f, Float.NaN}).put("counts", new int[] {-7}));
        FramePipe frames = reader(bytes);
        assertThat(frames.read())
                .isEqualTo(Map.of(
                        "place", Map.of("x", Double.POSITIVE_INFINITY, "name", "läb"),
                        "some", List.of(1, 2),
                        "map", Map.of("a", 2, "b", 1)));
        FramePipe.Frame frame = frames.readFrame();
        assertThat(frame.words())
                .isEqualTo(Map.of(
                        "ranges", Map.of("array", "f4", "at", 0, "count", 2),
                        "counts", Map.of("array", "i4", "at", 8, "count", 1)));
        assertThat(frame.arrays().getFloat()).isEqualTo(1.5f);
        assertThat(frame.arrays().getFloat()).isNaN();
        assertThat(frame.arrays().getInt()).isEqualTo(-7);
        assertThatThrownBy(frames::read).isInstanceOf(EOFException.class);
    }

    @Test
    void aLengthThatCannotBeIsRefused() {
        for (int[] lengths : new int[][] {{-1, 0}, {3, 4}, {1 << 27, 2}, {4, -1}}) {
            byte[] head = ByteBuffer.allocate(8)
                    .order(ByteOrder.LITTLE_ENDIAN)
                    .putInt(lengths[0])
                    .putInt(lengths[1])
                    .array();
            assertThatThrownBy(() -> reader(head).read())
                    .isInstanceOf(IOException.class)
                    .hasMessageContaining("can't have");
        }
    }

    /// Damage ends in an exception, never in a loop or a large array.
    @Test
    void damagedFramesAreReadOrRefused() throws IOException {
        byte[] whole = written(to -> to.put("a", List.of(1, "b")).put("c", new float[8]));
        var random = new SplittableRandom(3);
        for (int i = 0; i < 2000; i++) {
            byte[] damaged = whole.clone();
            damaged[random.nextInt(damaged.length)] ^= (byte) (1 << random.nextInt(8));
            try {
                reader(damaged).read();
            } catch (IOException e) {
                assertThat(e).hasMessageMatching("A frame can't have .*|The other side has ended.|The words of .*");
            }
        }
    }
}
