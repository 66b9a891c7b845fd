package rsal.ros2.type;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import rsal.ros2.type.FieldType.Repeat;

class DefinitionReaderTest {
    private static FieldType one(Element element) {
        return new FieldType(element, Repeat.ONE, 0);
    }

    @Test
    void readsAllFormsOfFields() {
        RosType type = DefinitionReader.message("my_msgs/msg/All", """
                # a comment
                Header header
                float64[9] k   # an array
                uint8[] data
                string<=10[<=3] names
                wstring wide "a # b"
                geometry_msgs/Point32[] points
                Other other
                int32 FIRST=1
                string NAME = "x # y"
                char letter
                float32 factor 1.5
                """);
        assertThat(type.fields())
                .containsExactly(
                        new Field("header", one(new Element.Nested("std_msgs/msg/Header")), ""),
                        new Field("k", new FieldType(Primitive.FLOAT64, Repeat.ARRAY, 9), ""),
                        new Field("data", new FieldType(Primitive.UINT8, Repeat.ANY, 0), ""),
                        new Field("names", new FieldType(new Element.Text(false, 10), Repeat.BOUNDED, 3), ""),
                        new Field("wide", one(new Element.Text(true, 0)), "\"a # b\""),
                        new Field(
                                "points",
                                new FieldType(new Element.Nested("geometry_msgs/msg/Point32"), Repeat.ANY, 0),
                                ""),
                        new Field("other", one(new Element.Nested("my_msgs/msg/Other")), ""),
                        new Field("letter", one(Primitive.UINT8), ""),
                        new Field("factor", one(Primitive.FLOAT32), "1.5"));
    }

    @Test
    void aTypeWithoutFieldsHasOne() {
        assertThat(DefinitionReader.message("std_msgs/msg/Empty", "# nothing\n").fields())
                .extracting(Field::name)
                .containsExactly("structure_needs_at_least_one_member");
    }

    @Test
    void servicesAndActionsHaveMessages() {
        assertThat(DefinitionReader.service("std_srvs/srv/SetBool", "bool data\n---\nbool success\nstring message\n"))
                .containsExactly(
                        TypeLibrary.of(Distribution.JAZZY).get("std_srvs/srv/SetBool_Request"),
                        TypeLibrary.of(Distribution.JAZZY).get("std_srvs/srv/SetBool_Response"));
        List<RosType> action = DefinitionReader.action("nav2_msgs/action/Spin", """
                float32 target_yaw
                ---
                ---
                float32 angular_distance_traveled
                """);
        assertThat(action)
                .extracting(RosType::name)
                .contains("nav2_msgs/action/Spin_SendGoal_Request", "nav2_msgs/action/Spin_FeedbackMessage");
        assertThat(action)
                .filteredOn(type ->
                        type.name().contains("_SendGoal_") || type.name().endsWith("Message"))
                .allSatisfy(type -> assertThat(type)
                        .isEqualTo(TypeLibrary.of(Distribution.JAZZY).get(type.name())));
    }

    @Test
    void aSchemaOfMcapHasAllThatItNeeds() {
        List<RosType> types =
                DefinitionReader.withDependencies("a_msgs/msg/A", """
                std_msgs/Header header
                %s
                MSG: std_msgs/Header
                builtin_interfaces/Time stamp
                string frame_id
                %s
                MSG: builtin_interfaces/Time
                int32 sec
                uint32 nanosec
                """.formatted("=".repeat(80), "=".repeat(80)));
        assertThat(types)
                .extracting(RosType::name)
                .containsExactly("a_msgs/msg/A", "std_msgs/msg/Header", "builtin_interfaces/msg/Time");
    }

    @ParameterizedTest
    @CsvSource(quoteCharacter = '`', textBlock = """
            float32,            'float32' is not a field
            float32 9lives,     'float32 9lives' is not a field
            float32[0] none,    'none' needs a number above 0
            float32[<=] none,   'none' needs a number above 0
            float32[-1] none,   'float32[-1] none' is not a field
            """)
    void errorsAreReportedWithTheirLine(String text, String message) {
        assertThatThrownBy(() -> DefinitionReader.message("a_msgs/msg/A", "\n" + text))
                .isInstanceOf(InvalidDefinition.class)
                .hasMessageContaining("a_msgs/msg/A:2: " + message);
    }

    @Test
    void namesAreWrittenInFull() {
        assertThatThrownBy(() -> DefinitionReader.message("LaserScan", ""))
                .hasMessageContaining("'LaserScan' is not a name of a type");
        assertThatThrownBy(() -> DefinitionReader.service("a_msgs/srv/A", "int8 x\n"))
                .hasMessageContaining("a_msgs/srv/A has 1 parts, separated by '---', instead of 2.");
    }

    @Test
    void typesHaveNamesInDds() {
        assertThat(TypeLibrary.of(Distribution.JAZZY)
                        .get("sensor_msgs/msg/LaserScan")
                        .ddsName())
                .isEqualTo("sensor_msgs::msg::dds_::LaserScan_");
    }

    @Test
    void aMessageWithinNeedsTheNameOfItsPackage() {
        String text = "a_msgs/B b\n%s\nMSG: B\nint8 x\n".formatted("=".repeat(80));
        assertThatThrownBy(() -> DefinitionReader.withDependencies("a_msgs/msg/A", text))
                .isInstanceOf(InvalidDefinition.class)
                .hasMessageContaining("'MSG: B'");
    }

    @ParameterizedTest
    @EnumSource
    void whatIsWrittenIsReadAgain(Distribution distribution) {
        TypeLibrary library = TypeLibrary.of(distribution);
        for (RosType type : library.all()) {
            List<RosType> read =
                    DefinitionReader.withDependencies(type.name(), DefinitionWriter.withDependencies(type, library));
            assertThat(read.getFirst()).isEqualTo(type);
            assertThat(read)
                    .allSatisfy(each -> assertThat(library.get(each.name())).isEqualTo(each));
            assertThat(TypeHash.of(type, TypeLibrary.of(read))).isEqualTo(TypeHash.of(type, library));
        }
    }

    @Test
    void aTypeIsLikeAnotherThatHasItsFields() {
        TypeLibrary ours = TypeLibrary.of(Distribution.JAZZY);
        String scan = "sensor_msgs/msg/LaserScan";
        assertThat(TypeLibrary.of(Distribution.HUMBLE).isLike(scan, ours)).isTrue();
        List<RosType> other = DefinitionReader.withDependencies(
                scan,
                DefinitionWriter.withDependencies(ours.get(scan), ours).replace("string frame_id", "string frame_no"));
        assertThat(ours.with(other).isLike(scan, ours)).isFalse();
        assertThat(TypeLibrary.of(List.of()).isLike(scan, ours)).isFalse();
    }

    /// Whatever stands in a file, it is read or refused.
    @Test
    void nothingBreaksTheReader() {
        var random = new SplittableRandom(7);
        String letters = "int8[]<=09 string\"#=-/\n\tabc MSG:";
        for (int i = 0; i < 20_000; i++) {
            var text = new StringBuilder();
            int length = random.nextInt(40);
            for (int k = 0; k < length; k++) {
                text.append(letters.charAt(random.nextInt(letters.length())));
            }
            try {
                assertThat(DefinitionReader.withDependencies("a_msgs/msg/A", text.toString()))
                        .isNotEmpty();
            } catch (InvalidDefinition e) {
                assertThat(e).hasMessageContaining("'");
            }
        }
    }
}
