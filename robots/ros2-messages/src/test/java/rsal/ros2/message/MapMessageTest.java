package rsal.ros2.message;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Instant;
import org.junit.jupiter.api.Test;
import rsal.data.OccupancyGrid;
import rsal.data.Pose2d;
import rsal.ros2.cdr.CdrReader;
import rsal.ros2.cdr.CdrWriter;
import rsal.ros2.cdr.MessageCodec;
import rsal.ros2.cdr.RosMessage;
import rsal.ros2.type.Distribution;
import rsal.ros2.type.TypeLibrary;

class MapMessageTest {
    private static final TypeLibrary JAZZY = TypeLibrary.of(Distribution.JAZZY);
    private static final MessageCodec CODEC = MessageCodec.of(JAZZY.get("nav_msgs/msg/OccupancyGrid"), JAZZY);

    private static RosMessage message(int width, int height, Pose2d origin, byte... cells) throws Exception {
        var writer = new CdrWriter();
        writer.int32(0)
                .int32(0)
                .text("map")
                .int32(0)
                .int32(0)
                .float32(0.05f)
                .int32(width)
                .int32(height);
        writer.float64(origin.x()).float64(origin.y()).float64(0).float64(0).float64(0);
        writer.float64(Math.sin(origin.theta() / 2)).float64(Math.cos(origin.theta() / 2));
        writer.int32(cells.length).int8s(cells);
        return CODEC.read(CdrReader.of(writer.toBytes()));
    }

    @Test
    void ourOwnMapComesBackAsItWas() throws Exception {
        var map = new OccupancyGrid(3, 2, 0.05, -1, 2, new byte[] {0, 100, -1, 100, 0, -1});
        byte[] bytes = new RosMessages().map(Instant.EPOCH, map, "map");
        assertThat(MapMessage.of(CODEC.read(CdrReader.of(bytes))).orElseThrow())
                .usingRecursiveComparison()
                .isEqualTo(map);
    }

    @Test
    void percentsAreThoseOfTheMapServer() throws Exception {
        OccupancyGrid map = MapMessage.of(
                        message(6, 1, Pose2d.ORIGIN, (byte) 0, (byte) 19, (byte) 20, (byte) 64, (byte) 65, (byte) -1))
                .orElseThrow();
        byte unknown = OccupancyGrid.UNKNOWN;
        assertThat(map.cells()).containsExactly((byte) 0, (byte) 0, unknown, unknown, (byte) 100, unknown);
        assertThat(map.resolution()).isEqualTo(0.05);
    }

    @Test
    void whatIsNoMapIsLeftOut() throws Exception {
        assertThat(MapMessage.of(message(2, 2, Pose2d.ORIGIN, (byte) 0))).isEmpty();
        assertThat(MapMessage.of(message(0, 0, Pose2d.ORIGIN))).isEmpty();
        assertThat(MapMessage.of(message(-1, -1, Pose2d.ORIGIN, (byte) 0))).isEmpty();
        assertThat(MapMessage.of(message(65_536, 65_536, Pose2d.ORIGIN))).isEmpty();
        assertThat(MapMessage.of(message(1, 1, new Pose2d(0, 0, 1), (byte) 0))).isEmpty();
        assertThat(MapMessage.of(message(1, 1, new Pose2d(Double.NaN, 0, 0), (byte) 0)))
                .isEmpty();
    }
}
