package rsal.ros2.rosbridge;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import rsal.ros2.cdr.MessageCodec;
import rsal.ros2.type.Distribution;
import rsal.ros2.type.TypeLibrary;

/// Whatever a server sends is a message, or is refused.
class DamagedMessagesTest {
    private static final long ROUNDS = Boolean.getBoolean("rsal.test.all") ? 500_000 : 5_000; // of each encoding
    private static final List<String> TYPES = List.of(
            "sensor_msgs/msg/LaserScan",
            "nav_msgs/msg/Odometry",
            "tf2_msgs/msg/TFMessage",
            "sensor_msgs/msg/BatteryState",
            "sensor_msgs/msg/Image",
            "nav_msgs/msg/OccupancyGrid");

    private final TypeLibrary types = TypeLibrary.of(Distribution.JAZZY);
    private final PythonMessages server = new PythonMessages(types, false);
    private final MessageValues values = new MessageValues(types, RosVersion.ROS_2);
    private final SplittableRandom random = new SplittableRandom(46);

    private byte[] damaged(byte[] whole) {
        byte[] bytes = whole.clone();
        int changes = 1 + random.nextInt(4);
        for (int i = 0; i < changes; i++) {
            bytes[random.nextInt(bytes.length)] = (byte) random.nextInt(256);
        }
        return random.nextInt(4) == 0 ? Arrays.copyOf(bytes, random.nextInt(bytes.length + 1)) : bytes;
    }

    private String json(String type) {
        return server.toJson(MessageCodec.of(types.get(type), types).zero()).toString();
    }

    @Test
    void jsonIsReadOrRefused() {
        int refused = 0;
        for (long i = 0; i < ROUNDS; i++) {
            String type = TYPES.get(random.nextInt(TYPES.size()));
            byte[] bytes = damaged(json(type).getBytes(StandardCharsets.UTF_8));
            try {
                values.toCdr(type, ValueReader.json(new String(bytes, StandardCharsets.UTF_8)));
            } catch (InvalidMessage e) {
                assertThat(e.getMessage()).isNotEmpty();
                refused++;
            }
        }
        assertThat(refused).isBetween(1, (int) ROUNDS - 1);
    }

    @Test
    void cborIsReadOrRefused() throws PythonMessages.Refused {
        var whole = new ArrayList<byte[]>();
        var ranges = new CborWriter.Tagged(85, CborWriter.little(new float[] {1, 2, Float.NaN}));
        whole.add(CborWriter.write(Map.of("ranges", ranges, "header", Map.of("frame_id", "laser"))));
        for (String type : TYPES) {
            if (values.isForCbor(type)) {
                whole.add(CborWriter.write(
                        server.toCbor(MessageCodec.of(types.get(type), types).zero())));
            }
        }
        int refused = 0;
        for (long i = 0; i < ROUNDS; i++) {
            byte[] bytes = damaged(whole.get(random.nextInt(whole.size())));
            try {
                WireValue value = ValueReader.cbor(ByteBuffer.wrap(bytes));
                for (String type : TYPES) {
                    values.toCdr(type, value);
                }
            } catch (InvalidMessage e) {
                assertThat(e.getMessage()).isNotEmpty();
                refused++;
            }
        }
        assertThat(refused).isBetween(1, (int) ROUNDS);
    }

    @Test
    void anyBytesAreReadOrRefused() {
        for (long i = 0; i < ROUNDS; i++) {
            var bytes = new byte[random.nextInt(40)];
            random.nextBytes(bytes);
            try {
                assertThat(ValueReader.cbor(ByteBuffer.wrap(bytes)).words()).isNotNull();
            } catch (InvalidMessage e) {
                assertThat(e.getMessage()).isNotEmpty();
            }
        }
    }

    @Test
    void whatIsNestedTooDeeplyIsRefused() {
        byte[] lists = new byte[100_000];
        Arrays.fill(lists, (byte) 0x81); // a list of one
        assertThat(refusal(() -> ValueReader.cbor(ByteBuffer.wrap(lists)))).contains("not CBOR");
        assertThat(refusal(() -> ValueReader.json("[".repeat(100_000)))).contains("not JSON");
    }

    @Test
    void nothingIsAllocatedForWhatIsClaimed() {
        byte[] list = {(byte) 0x9a, 0x7f, (byte) 0xff, (byte) 0xff, (byte) 0xff}; // of two billion
        assertThat(refusal(() -> ValueReader.cbor(ByteBuffer.wrap(list)))).contains("not CBOR");
        byte[] bytes = {0x5b, (byte) 0xff, (byte) 0xff, (byte) 0xff, (byte) 0xff, 0, 0, 0, 0};
        assertThat(refusal(() -> ValueReader.cbor(ByteBuffer.wrap(bytes)))).contains("not CBOR");
    }

    private interface Reading {
        Object read() throws InvalidMessage;
    }

    private static String refusal(Reading reading) {
        try {
            return "read: " + reading.read();
        } catch (InvalidMessage e) {
            return String.valueOf(e.getMessage());
        }
    }
}
