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

    private static RosMessage update(int x, int y, int width, int height, byte... cells) throws Exception {
        MessageCodec codec = MessageCodec.of(JAZZY.get("map_msgs/msg/OccupancyGridUpdate"), JAZZY);
        var writer = new CdrWriter();
        writer.int32(0).int32(0).text("map").int32(x).int32(y).int32(width).int32(height);
        return codec.read(CdrReader.of(writer.int32(cells.length).int8s(cells).toBytes()));
    }

    @Test
    void anUpdateChangesARectangleOfACopy() throws Exception {
        var map = new OccupancyGrid(4, 3, 0.05, -1, 2, new byte[12]);
        OccupancyGrid changed = MapMessage.updated(
                        map, update(1, 1, 2, 2, (byte) 100, (byte) 70, (byte) 50, (byte) 10), CellMeaning.OCCUPANCY)
                .orElseThrow();
        assertThat(map.cells()).containsOnly(0);
        assertThat(changed.cells()).containsExactly(0, 0, 0, 0, 0, 100, 100, 0, 0, -1, 0, 0);
        assertThat(changed.originX()).isEqualTo(-1);
        assertThat(MapMessage.updated(map, update(0, 0, 0, 0), CellMeaning.OCCUPANCY))
                .hasValueSatisfying(same -> assertThat(same.cells()).containsOnly(0));
    }

    @Test
    void anUpdateThatDoesNotFitIsLeftOut() throws Exception {
        var map = new OccupancyGrid(4, 3, 0.05, -1, 2, new byte[12]);
        int most = Integer.MAX_VALUE;
        int[][] all = {
            {3, 0, 2, 1},
            {0, 2, 1, 2},
            {-1, 0, 2, 1},
            {0, -1, 2, 1},
            {most, most, 2, 1},
            {0, 0, -1, -2},
            {0, 0, 1, 1},
            {1, 0, -1, 2},
            {0, 0, 2, -1},
            {0, 0, 0x10000, 0x10000}
        };
        for (int[] wrong : all) {
            RosMessage update = update(wrong[0], wrong[1], wrong[2], wrong[3], (byte) 1, (byte) 1);
            assertThat(MapMessage.updated(map, update, CellMeaning.OCCUPANCY)).isEmpty();
        }
        assertThat(map.cells()).containsOnly(0);
    }

    /// Of Nav2's costmaps: where the middle of the robot can't be is 99.
    @Test
    void costsAreThoseOfOurs() throws Exception {
        OccupancyGrid costs = MapMessage.of(
                        message(5, 1, Pose2d.ORIGIN, (byte) 0, (byte) 98, (byte) 99, (byte) 100, (byte) -1),
                        CellMeaning.COSTS)
                .orElseThrow();
        assertThat(costs.cells()).containsExactly(0, 98, 100, 100, -1);
    }
}
