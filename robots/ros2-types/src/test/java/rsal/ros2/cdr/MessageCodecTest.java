package rsal.ros2.cdr;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.lang.reflect.Array;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rsal.ros2.type.DefinitionReader;
import rsal.ros2.type.Distribution;
import rsal.ros2.type.InvalidDefinition;
import rsal.ros2.type.RosType;
import rsal.ros2.type.TypeLibrary;
import rsal.testkit.Rounds;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

class MessageCodecTest {
    private static final TypeLibrary JAZZY = TypeLibrary.of(Distribution.JAZZY);

    /// A message that others have written: rosbags 0.11.9 and Cyclone DDS 11.0.1, both the same bytes.
    record Vector(String name, Distribution distribution, String type, JsonNode value, byte[] bytes) {
        MessageCodec codec() {
            TypeLibrary library = TypeLibrary.of(distribution);
            return MessageCodec.of(library.get(type), library);
        }

        @Override
        public String toString() {
            return name;
        }
    }

    static List<Vector> vectors() throws IOException {
        try (var in = Objects.requireNonNull(MessageCodecTest.class.getResourceAsStream("/vectors.json"))) {
            var vectors = new ArrayList<Vector>();
            for (JsonNode each : JsonMapper.shared().readTree(in)) {
                vectors.add(new Vector(
                        each.get("name").asString(),
                        Distribution.valueOf(each.get("distro").asString().toUpperCase(Locale.ROOT)),
                        each.get("type").asString(),
                        each.get("value"),
                        HexFormat.of().parseHex(each.get("cdr").asString())));
            }
            return vectors;
        }
    }

    @ParameterizedTest
    @MethodSource("vectors")
    void bytesOfOthersAreReadAndWrittenAlike(Vector vector) throws Exception {
        RosMessage message = vector.codec().read(vector.bytes());
        assertSame(message, vector.value(), vector.type());
        assertThat(HexFormat.of().formatHex(vector.codec().write(message)))
                .isEqualTo(HexFormat.of().formatHex(vector.bytes()));
    }

    /// Fields of a message by those of JSON, in which numbers that are none are words.
    private static void assertSame(Object value, JsonNode expected, String at) {
        switch (value) {
            case RosMessage message ->
                message.fields().forEach((name, field) -> assertSame(field, expected.path(name), at + "." + name));
            case List<?> list -> {
                assertThat(expected.size()).as(at).isEqualTo(list.size());
                for (int i = 0; i < list.size(); i++) {
                    assertSame(list.get(i), expected.get(i), at + i);
                }
            }
            case String text -> assertThat(expected.asString()).as(at).isEqualTo(text);
            case Boolean flag -> assertThat(expected.asBoolean()).as(at).isEqualTo(flag);
            case Number number -> assertNumber(number, expected, at);
            default -> {
                assertThat(expected.size()).as(at).isEqualTo(Array.getLength(value));
                for (int i = 0; i < expected.size(); i++) {
                    assertNumber((Number) Array.get(value, i), expected.get(i), at + i);
                }
            }
        }
    }

    private static void assertNumber(Number number, JsonNode expected, String at) {
        double wanted = switch (expected.asString()) {
            case "NaN" -> Double.NaN;
            case "Infinity" -> Double.POSITIVE_INFINITY;
            case "-Infinity" -> Double.NEGATIVE_INFINITY;
            case "true" -> 1;
            case "false" -> 0;
            default -> expected.asDouble();
        };
        if (number instanceof Byte && wanted > Byte.MAX_VALUE) {
            wanted -= 256; // of arrays of uint8, the bits
        }
        if (number instanceof Float || number instanceof Double) {
            assertThat(Float.valueOf((float) number.doubleValue())).as(at).isEqualTo(Float.valueOf((float) wanted));
        } else {
            assertThat(number.doubleValue()).as(at).isEqualTo(wanted);
        }
    }

    static List<Distribution> distributions() {
        return List.of(Distribution.values());
    }

    @ParameterizedTest
    @MethodSource("distributions")
    void eachMessageOfEachTypeIsReadAsItWasWritten(Distribution distribution) throws Exception {
        TypeLibrary library = TypeLibrary.of(distribution);
        var random = new RandomMessages(7, library);
        assertThat(library.all()).hasSizeGreaterThan(300);
        for (RosType type : library.all()) {
            MessageCodec codec = MessageCodec.of(type, library);
            for (int i = 0; i < 5; i++) {
                RosMessage message = random.of(type);
                byte[] bytes = codec.write(message);
                RosMessage read = codec.read(bytes);
                assertThat(codec.write(read)).as(type.name()).isEqualTo(bytes);
                assertThat(plain(read)).as(type.name()).isEqualTo(plain(message));
            }
        }
    }

    /// With lists in place of arrays, which are equal to nothing but themselves.
    private static Object plain(Object value) {
        return switch (value) {
            case RosMessage message -> {
                var fields = new LinkedHashMap<String, Object>();
                message.fields().forEach((name, field) -> fields.put(name, plain(field)));
                yield fields;
            }
            case List<?> list -> list.stream().map(MessageCodecTest::plain).toList();
            case byte[] array -> Arrays.toString(array);
            case short[] array -> Arrays.toString(array);
            case int[] array -> Arrays.toString(array);
            case long[] array -> Arrays.toString(array);
            case float[] array -> Arrays.toString(array);
            case double[] array -> Arrays.toString(array);
            default -> value;
        };
    }

    @Test
    void bigEndianIsReadToo() throws Exception {
        MessageCodec codec = MessageCodec.of(JAZZY.get("builtin_interfaces/msg/Time"), JAZZY);
        RosMessage time = codec.read(HexFormat.of().parseHex("00000000" + "00000001" + "ffffffff"));
        assertThat(time.integer("sec")).isEqualTo(1);
        assertThat(time.integer("nanosec")).isEqualTo(4294967295L);
    }

    @Test
    void whatAnOlderPeerLacksAtTheEndIsZeroAndWhatANewerOneAddsIsIgnored() throws Exception {
        RosType old = DefinitionReader.message("a_msgs/msg/A", "int32 a\n");
        RosType now = DefinitionReader.message("a_msgs/msg/A", "int32 a\nstring b\nfloat64[2] c\nint8[] d\n");
        MessageCodec older = MessageCodec.of(old, JAZZY);
        MessageCodec newer = MessageCodec.of(now, JAZZY);
        RosMessage read = newer.read(older.write(new RosMessage(old, Map.of("a", 5L))));
        assertThat(read.integer("a")).isEqualTo(5);
        assertThat(read.text("b")).isEmpty();
        assertThat(read.get("c", double[].class)).containsExactly(0, 0);
        assertThat(read.get("d", byte[].class)).isEmpty();
        assertThat(older.read(newer.write(read)).integer("a")).isEqualTo(5);
    }

    /// As Cyclone DDS fills payloads up to a multiple of 4 bytes.
    @Test
    void bytesThatFillUpAreNoFields() throws Exception {
        RosType old = DefinitionReader.message("a_msgs/msg/A", "string a\n");
        RosType now = DefinitionReader.message("a_msgs/msg/A", "string a\nuint8 b\nint32 c\nTime d\nint8[] e\n");
        RosType time = DefinitionReader.message("a_msgs/msg/Time", "int64 sec\n");
        byte[] written = MessageCodec.of(old, JAZZY).write(new RosMessage(old, Map.of("a", "")));
        byte[] filled = Arrays.copyOf(written, 12);
        RosMessage read = MessageCodec.of(now, JAZZY.with(List.of(time))).read(filled);
        assertThat(read.integer("b")).isZero();
        assertThat(read.integer("c")).isZero();
        assertThat(read.message("d").integer("sec")).isZero();
        assertThat(read.get("e", byte[].class)).isEmpty();
    }

    @Test
    void countsThatCannotBeTakeNoMemory() {
        MessageCodec codec = MessageCodec.of(JAZZY.get("sensor_msgs/msg/PointCloud"), JAZZY);
        byte[] bytes = codec.write(codec.zero());
        Arrays.fill(bytes, 20, 24, (byte) 0x7f); // the number of points, behind the header
        assertThatThrownBy(() -> codec.read(bytes))
                .isInstanceOf(InvalidCdr.class)
                .hasMessageContaining("claims");
    }

    @Test
    void whatDoesNotFitIsRefused() {
        RosType type = DefinitionReader.message("a_msgs/msg/A", "int8[2] a\nstring<=3[<=1] b\n");
        MessageCodec codec = MessageCodec.of(type, JAZZY);
        assertThatThrownBy(() -> codec.write(new RosMessage(type, Map.of("a", new byte[3], "b", List.of()))))
                .hasMessage("Field 'a' has 3 elements instead of 2.");
        assertThatThrownBy(() -> codec.write(new RosMessage(type, Map.of("a", new byte[2], "b", List.of("", "")))))
                .hasMessage("Field 'b' has 2 elements instead of at most 1.");
        assertThatThrownBy(() -> codec.write(new RosMessage(type, Map.of("a", new byte[2]))))
                .hasMessage("A message of type 'a_msgs/msg/A' lacks its field 'b'.");
        assertThatThrownBy(() -> codec.write(new RosMessage(type, Map.of("a", "text", "b", List.of()))))
                .isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> codec.read(new byte[] {0, 9, 0, 0})).hasMessageContaining("0x0009");
        assertThatThrownBy(() -> codec.read(new byte[] {0, 1})).hasMessageContaining("2 bytes");
    }

    @Test
    void aTypeWithinItselfIsRefused() {
        RosType type = DefinitionReader.message("a_msgs/msg/A", "a_msgs/A a\n");
        assertThatThrownBy(() -> MessageCodec.of(type, TypeLibrary.of(List.of(type))))
                .isInstanceOf(InvalidDefinition.class)
                .hasMessageContaining("'a_msgs/msg/A'");
    }

    /// Bytes from a network may be anything.
    @Test
    void damagedMessagesAreReadOrRefused() throws Exception {
        var random = new SplittableRandom(5);
        List<Vector> vectors = vectors();
        int refused = 0;
        int rounds = Rounds.of(20_000, 1_000_000);
        for (int i = 0; i < rounds; i++) {
            Vector vector = vectors.get(random.nextInt(vectors.size()));
            byte[] bytes = Arrays.copyOf(
                    vector.bytes(),
                    random.nextBoolean() ? vector.bytes().length : random.nextInt(vector.bytes().length));
            for (int k = random.nextInt(4); k > 0 && bytes.length > 4; k--) {
                bytes[4 + random.nextInt(bytes.length - 4)] = (byte) random.nextInt();
            }
            try {
                vector.codec().read(bytes);
            } catch (InvalidCdr e) {
                refused++;
            }
        }
        assertThat(refused).isBetween(rounds / 20, rounds);
    }
}
