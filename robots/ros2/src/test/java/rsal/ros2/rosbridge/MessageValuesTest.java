package rsal.ros2.rosbridge;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.ByteBuffer;
import java.util.Base64;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.ros2.cdr.RosMessage;
import rsal.ros2.type.Distribution;
import rsal.ros2.type.TypeLibrary;

class MessageValuesTest {
    private static final String SCAN = "sensor_msgs/msg/LaserScan";
    private static final TypeLibrary TYPES = TypeLibrary.of(Distribution.JAZZY);

    private final MessageValues ros2 = new MessageValues(TYPES, RosVersion.ROS_2);
    private final MessageValues ros1 = new MessageValues(TYPES, RosVersion.ROS_1);

    private RosMessage read(String type, String json) throws InvalidMessage {
        return ros2.ofCdr(type, ros2.toCdr(type, ValueReader.json(json)));
    }

    private RosMessage readCbor(String type, Object value) throws InvalidMessage {
        return ros2.ofCdr(type, ros2.toCdr(type, ValueReader.cbor(ByteBuffer.wrap(CborWriter.write(value)))));
    }

    @Test
    void nullIsNoNumberAsRosbridgeWritesNanAndInfinity() throws InvalidMessage {
        RosMessage scan = read(SCAN, "{\"ranges\": [1.5, null, 2, NaN, Infinity], \"range_max\": null}");
        assertThat(scan.get("ranges", float[].class))
                .containsExactly(1.5f, Float.NaN, 2, Float.NaN, Float.POSITIVE_INFINITY);
        assertThat(scan.number("range_max")).isNaN();
    }

    @Test
    void fieldsMayLackAndBeUnknown() throws InvalidMessage {
        RosMessage header = read("std_msgs/msg/Header", "{\"seq\": 7, \"frame_id\": \"map\"}");
        assertThat(header.text("frame_id")).isEqualTo("map");
        assertThat(header.message("stamp").integer("sec")).isZero();
    }

    @Test
    void timesOfRos1HaveOtherNames() throws InvalidMessage {
        RosMessage header = read("std_msgs/msg/Header", "{\"stamp\": {\"secs\": 5, \"nsecs\": 6}}");
        assertThat(header.message("stamp").integer("sec")).isEqualTo(5);
        assertThat(header.message("stamp").integer("nanosec")).isEqualTo(6);
        assertThat(OperationWriter.write(out -> {
                    out.writeName("of1");
                    ros1.write(header.message("stamp"), out);
                    out.writeName("of2");
                    ros2.write(header.message("stamp"), out);
                }))
                .isEqualTo("{\"of1\":{\"secs\":5,\"nsecs\":6},\"of2\":{\"sec\":5,\"nanosec\":6}}");
    }

    @Test
    void bytesAreBase64OrLists() throws InvalidMessage {
        String base64 = Base64.getEncoder().encodeToString(new byte[] {1, -1, 3});
        String image = "sensor_msgs/msg/Image";
        assertThat(read(image, "{\"data\": \"%s\"}".formatted(base64)).get("data", byte[].class))
                .containsExactly(1, -1, 3);
        assertThat(read(image, "{\"data\": [1, 255, 3]}").get("data", byte[].class))
                .containsExactly(1, -1, 3);
        RosMessage message = readCbor(image, Map.of("data", new byte[] {1, -1, 3}));
        assertThat(message.get("data", byte[].class)).containsExactly(1, -1, 3);
        assertThat(OperationWriter.write(out -> {
                    out.writeName("image");
                    ros2.write(message, out);
                }))
                .contains("\"data\":\"%s\"".formatted(base64));
    }

    @Test
    void arraysOfCborKeepWhatIsInfinite() throws InvalidMessage {
        float[] ranges = {1.5f, Float.POSITIVE_INFINITY, Float.NaN, -0.25f};
        RosMessage scan = readCbor(
                SCAN, Map.of("ranges", new CborWriter.Tagged(85, CborWriter.little(ranges)), "angle_min", -1.5));
        assertThat(scan.get("ranges", float[].class)).containsExactly(ranges);
        assertThat(scan.number("angle_min")).isEqualTo(-1.5);
        byte[] cells = {-1, 0, 100};
        assertThat(readCbor("nav_msgs/msg/OccupancyGrid", Map.of("data", new CborWriter.Tagged(72, cells)))
                        .get("data", byte[].class))
                .containsExactly(cells);
    }

    @ParameterizedTest
    @CsvSource({
        "std_msgs/msg/UInt16MultiArray, 69, 0100ffff, '1, -1'",
        "std_msgs/msg/UInt16MultiArray, 65, 0001ffff, '1, -1'", // big endian
        "std_msgs/msg/Int16MultiArray, 77, 0100feff, '1, -2'",
        "std_msgs/msg/Int32MultiArray, 78, 01000000feffffff, '1, -2'",
        "std_msgs/msg/UInt32MultiArray, 70, 01000000ffffffff, '1, -1'",
        "std_msgs/msg/Int64MultiArray, 79, 0100000000000000feffffffffffffff, '1, -2'",
        "std_msgs/msg/Float32MultiArray, 85, 0000803f000080bf, '1.0, -1.0'",
        "std_msgs/msg/Float32MultiArray, 84, 003c00bc, '1.0, -1.0'", // of 16 bits
        "std_msgs/msg/Float64MultiArray, 86, 000000000000f03f, '1.0'",
        "std_msgs/msg/Float64MultiArray, 85, 0000803f, '1.0'" // of another size than the field
    })
    void arraysOfCborHaveAllTypes(String type, int tag, String hex, String values) throws InvalidMessage {
        var bytes = java.util.HexFormat.of().parseHex(hex);
        RosMessage message = readCbor(type, Map.of("data", new CborWriter.Tagged(tag, bytes)));
        assertThat(message.fields().get("data")).asString().isNotEmpty();
        assertThat(java.util.stream.IntStream.range(
                                0,
                                java.lang.reflect.Array.getLength(
                                        message.fields().get("data")))
                        .mapToObj(i -> String.valueOf(
                                java.lang.reflect.Array.get(message.fields().get("data"), i)))
                        .toList())
                .isEqualTo(List.of(values.split(", ")));
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "[]",
                "5",
                "{\"ranges\": 5}",
                "{\"ranges\": [\"a\"]}",
                "{\"ranges\": \"AAAA\"}",
                "{\"header\": 5}",
                "{\"header\": {\"frame_id\": 5}}",
                "{\"header\": {\"stamp\": {\"sec\": 4294967296}}}",
                "{\"header\": {\"stamp\": {\"sec\": 1.5}}}"
            })
    void whatIsNoSuchMessageIsRefused(String json) {
        assertThatThrownBy(() -> read(SCAN, json)).isInstanceOf(InvalidMessage.class);
    }

    @Test
    void fixedArraysHaveTheirLength() {
        assertThatThrownBy(() -> read("nav_msgs/msg/Odometry", "{\"pose\": {\"covariance\": [1, 2]}}"))
                .isInstanceOf(InvalidMessage.class)
                .hasMessageContaining("36");
    }

    @Test
    void messagesWithoutFieldsAreEmpty() {
        RosMessage empty = ros2.ofCdr("std_msgs/msg/Empty", new byte[] {0, 1, 0, 0, 0});
        assertThat(OperationWriter.write(out -> {
                    out.writeName("msg");
                    ros2.write(empty, out);
                }))
                .isEqualTo("{\"msg\":{}}");
    }

    @ParameterizedTest
    @CsvSource({
        "sensor_msgs/msg/LaserScan, true",
        "nav_msgs/msg/OccupancyGrid, true",
        "tf2_msgs/msg/TFMessage, true",
        "sensor_msgs/msg/Image, true",
        "nav_msgs/msg/Odometry, false", // float64[36]
        "sensor_msgs/msg/JointState, false", // string[]
        "diagnostic_msgs/msg/DiagnosticArray, false" // byte
    })
    void typesThatServersFailToWriteAsCborComeAsJson(String type, boolean isForCbor) {
        assertThat(ros2.isForCbor(type)).isEqualTo(isForCbor);
    }
}
