package rsal.ros2.bridge;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.ByteBuffer;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import rsal.data.Pose2d;
import rsal.ros2.cdr.CdrReader;
import rsal.ros2.cdr.InvalidCdr;
import rsal.ros2.cdr.MessageCodec;
import rsal.ros2.cdr.RosMessage;
import rsal.ros2.link.RosPublisher.Publication;
import rsal.ros2.message.FrameTransform;
import rsal.ros2.simulation.PublishedTime;
import rsal.ros2.type.Distribution;
import rsal.ros2.type.TypeLibrary;
import rsal.time.LockstepScheduler;

class MountedFramesTest {
    private static final TypeLibrary TYPES = TypeLibrary.of(Distribution.JAZZY);
    private static final MessageCodec CODEC = MessageCodec.of(TYPES.get("tf2_msgs/msg/TFMessage"), TYPES);

    private final List<byte[]> fixed = new ArrayList<>();
    private final List<byte[]> moving = new ArrayList<>();
    private final MountedFrames frames =
            new MountedFrames(to(fixed), to(moving), new PublishedTime(new LockstepScheduler()));

    private static Publication to(List<byte[]> messages) {
        return new Publication() {
            @Override
            public void publish(byte[] message) {
                messages.add(message);
            }

            @Override
            public void close() {
                // nothing is open
            }
        };
    }

    private void put(String frame, double x) {
        if (frames.put(Instant.EPOCH, "base_link", frame, FrameTransform.of(new Pose2d(x, 0, 0)))) {
            frames.publish(Instant.EPOCH);
        }
    }

    private static List<String> children(byte[] message) throws InvalidCdr {
        return CODEC.read(CdrReader.of(ByteBuffer.wrap(message))).messages("transforms").stream()
                .map((RosMessage transform) -> transform.text("child_frame_id"))
                .toList();
    }

    @Test
    void allAreFixedUntilOneMoves() throws Exception {
        put("laser", 0.1);
        put("sonar_0", 0.2);
        put("laser", 0.1);
        assertThat(fixed).hasSize(2);
        assertThat(children(fixed.getLast())).containsExactly("laser", "sonar_0");
        assertThat(moving).isEmpty();
        for (int i = 0; i < 3; i++) {
            put("laser", 0.2 + i);
        }
        put("laser", 0.1); // where it began
        assertThat(fixed).hasSize(3);
        assertThat(children(fixed.getLast())).containsExactly("sonar_0");
        assertThat(moving).hasSize(4);
        assertThat(children(moving.getLast())).containsExactly("laser");
    }

    @Test
    void thoseOfARobotThatLeftAreGone() throws Exception {
        put("r1/laser", 0.1);
        put("r2/laser", 0.1);
        frames.remove(Set.of("r1/laser"));
        put("r3/laser", 0.1);
        assertThat(children(fixed.getLast())).containsExactly("r2/laser", "r3/laser");
    }
}
