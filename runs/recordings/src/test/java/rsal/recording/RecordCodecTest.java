package rsal.recording;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import rsal.data.Pose2d;
import rsal.data.Rgb;
import rsal.mcap.ByteSink;
import rsal.recording.proto.MessageType;
import rsal.recording.proto.ProtoWriter;
import rsal.robot.DeviceKinds;
import rsal.testkit.Rounds;

class RecordCodecTest {
    enum Word {
        ONE,
        OTHER
    }

    /// Of each type that a component may have.
    public record Any(
            double number,
            float small,
            int count,
            long many,
            boolean flag,
            String text,
            Word word,
            Pose2d baseFromThing,
            Rgb color,
            List<Inner> inner,
            float[] ranges,
            double[] values,
            byte[] pixels) {}

    public record Inner(int id, double sizeOfIt) {
        public Inner {
            if (id < 0) {
                throw new IllegalArgumentException("No id is negative.");
            }
        }
    }

    public record Odd(Map<String, String> map) {}

    private static <T> RecordCodec<T> codec(Class<T> type) {
        return RecordCodec.of(type, MessageType.named("test." + type.getSimpleName()), 3);
    }

    private static Any any(SplittableRandom random) {
        return new Any(
                random.nextDouble(-1e9, 1e9),
                (float) random.nextDouble(),
                random.nextInt(),
                random.nextLong(),
                random.nextBoolean(),
                random.nextBoolean() ? "" : "täxt " + random.nextInt(),
                random.nextBoolean() ? Word.ONE : Word.OTHER,
                new Pose2d(random.nextDouble(), -2, 3),
                new Rgb(random.nextInt(256), 0, 255),
                random.ints(random.nextInt(4), 0, 100)
                        .mapToObj(id -> new Inner(id, 0.5 * id))
                        .toList(),
                new float[] {1, Float.POSITIVE_INFINITY, 0},
                random.doubles(random.nextInt(5)).toArray(),
                new byte[random.nextInt(300)]);
    }

    private static <T> T again(RecordCodec<T> codec, T value) throws IOException {
        var sink = new ByteSink(64);
        codec.write(new ProtoWriter(sink), value);
        return codec.read(MessageFields.read(codec.message(), ByteBuffer.wrap(sink.toArray())));
    }

    @Test
    void whatIsWrittenIsRead() throws IOException {
        RecordCodec<Any> codec = codec(Any.class);
        var random = new SplittableRandom(4);
        for (int draw = 0; draw < Rounds.of(60, 300); draw++) {
            Any value = any(random);
            assertThat(again(codec, value)).usingRecursiveComparison().isEqualTo(value);
        }
    }

    @Test
    void fieldsAreCalledAsComponents() {
        assertThat(codec(Any.class).message().fields())
                .extracting(MessageType.Field::name)
                .startsWith("number", "small", "count")
                .contains("base_from_thing");
        assertThat(codec(Any.class).message().fields().getFirst().number()).isEqualTo(3);
        assertThat(codec(Inner.class).message().fields().get(1).name()).isEqualTo("size_of_it");
    }

    /// A file may be from anywhere.
    @Test
    void whatNoRecordCanBeIsRefused() throws IOException {
        MessageFields nothing = MessageFields.read(codec(Any.class).message(), ByteBuffer.allocate(0));
        assertThatIllegalArgumentException().isThrownBy(() -> codec(Any.class).read(nothing));
        var sink = new ByteSink(64);
        new ProtoWriter(sink).varint(3, -1);
        MessageFields negative = MessageFields.read(codec(Inner.class).message(), ByteBuffer.wrap(sink.toArray()));
        assertThatIllegalArgumentException().isThrownBy(() -> codec(Inner.class).read(negative));
    }

    @Test
    void aComponentThatCannotBeWrittenIsNamed() {
        assertThatIllegalArgumentException().isThrownBy(() -> codec(Odd.class)).withMessageContaining("'map'");
    }

    @Test
    void readingsOfAllKindsOfDevicesAreRecorded() {
        assertThat(DeviceKinds.all())
                .isNotEmpty()
                .allSatisfy(kind -> assertThat(ReadingType.named(kind.reads().getName()))
                        .hasValueSatisfying(type -> assertThat(type.reported()).isEqualTo(kind.reads())));
    }
}
