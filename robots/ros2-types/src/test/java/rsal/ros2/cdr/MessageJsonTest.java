package rsal.ros2.cdr;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import rsal.ros2.type.DefinitionReader;
import rsal.ros2.type.Distribution;
import rsal.ros2.type.Field;
import rsal.ros2.type.RosType;
import rsal.ros2.type.TypeLibrary;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

class MessageJsonTest {
    private static final TypeLibrary JAZZY = TypeLibrary.of(Distribution.JAZZY);

    private static RosMessage message(String fields) {
        RosType type = DefinitionReader.message("a/msg/A", fields);
        return MessageCodec.of(type, JAZZY).zero();
    }

    private static JsonNode read(RosMessage message) {
        return JsonMapper.shared().readTree(MessageJson.of(message));
    }

    @Test
    void messagesWithinAreIndentedAndArraysAreNot() {
        RosMessage message = message("float32 co2\nbuiltin_interfaces/Time stamp\nint8[2] two\nstring name")
                .with("co2", 412.1)
                .with("two", new byte[] {1, -1})
                .with("name", "a \"gas\"\n");
        assertThat(MessageJson.of(message)).isEqualTo("""
                {
                  "co2": 412.1,
                  "stamp": {
                    "sec": 0,
                    "nanosec": 0
                  },
                  "two": [1, -1],
                  "name": "a \\"gas\\"\\n"
                }""");
    }

    @Test
    void messagesInArraysHaveLinesOfTheirOwn() {
        RosMessage message = message("builtin_interfaces/Time[2] times");
        assertThat(MessageJson.of(message)).isEqualTo("""
                {
                  "times": [
                    {
                      "sec": 0,
                      "nanosec": 0
                    },
                    {
                      "sec": 0,
                      "nanosec": 0
                    }
                  ]
                }""");
    }

    @Test
    void unsignedNumbersAreAboveZeroAndFlagsAreFlags() {
        RosMessage message = message("uint8[1] a\nuint16[1] b\nuint32[1] c\nuint64[1] d\nuint64 e\nbool[2] f\nbyte g")
                .with("a", new byte[] {-1})
                .with("b", new short[] {-1})
                .with("c", new int[] {-1})
                .with("d", new long[] {-1})
                .with("e", -1L)
                .with("f", new byte[] {0, 1})
                .with("g", 200L);
        assertThat(read(message).toString())
                .isEqualTo("{\"a\":[255],\"b\":[65535],\"c\":[4294967295],\"d\":[18446744073709551615],"
                        + "\"e\":18446744073709551615,\"f\":[false,true],\"g\":200}");
    }

    @Test
    void whatIsNotFiniteIsAText() {
        RosMessage message = message("float64 a\nfloat32[2] b")
                .with("a", Double.NaN)
                .with("b", new float[] {Float.POSITIVE_INFINITY, 0.1f});
        assertThat(read(message).toString()).isEqualTo("{\"a\":\"NaN\",\"b\":[\"Infinity\",0.1]}");
    }

    @Test
    void longArraysAndTextsAreCut() {
        RosMessage scan = message("float32[] ranges\nstring text\nstring[] names")
                .with("ranges", new float[1_000])
                .with("text", "x".repeat(2_500))
                .with("names", List.of("a", "b"));
        JsonNode json = read(scan);
        assertThat(json.get("ranges").size()).isEqualTo(129);
        assertThat(json.get("ranges").get(128).asString()).isEqualTo("… 872 more");
        assertThat(json.get("text").asString()).hasSizeLessThan(2_020).endsWith("x… 500 more");
        assertThat(json.get("names").toString()).isEqualTo("[\"a\",\"b\"]");
    }

    /// 128 points of 128 fields each would be 16,384.
    @Test
    void theWholeIsBoundedToo() {
        var field = new RosMessage(
                DefinitionReader.message("a/msg/B", "float32[] values"), Map.of("values", new float[200]));
        RosType outer = DefinitionReader.message("a/msg/A", "B[] all");
        var message = new RosMessage(outer, Map.of("all", java.util.Collections.nCopies(200, field)));
        JsonNode all = read(message).get("all");
        assertThat(MessageJson.of(message).length()).isLessThan(200_000);
        assertThat(all.get(all.size() - 1).asString()).endsWith(" more");
    }

    @ParameterizedTest
    @EnumSource
    void messagesOfAllTypesAreJson(Distribution distribution) {
        TypeLibrary library = TypeLibrary.of(distribution);
        var random = new RandomMessages(3, library);
        for (RosType type : library.all()) {
            JsonNode json = read(random.of(type));
            assertThat(json.propertyNames())
                    .as(type.name())
                    .containsExactlyElementsOf(
                            type.fields().stream().map(Field::name).toList());
        }
    }
}
