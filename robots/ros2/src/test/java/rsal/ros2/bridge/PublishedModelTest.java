package rsal.ros2.bridge;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import rsal.device.Actuator;
import rsal.ros2.MemoryNetwork;
import rsal.ros2.cdr.CdrReader;
import rsal.ros2.cdr.InvalidCdr;
import rsal.ros2.cdr.MessageCodec;
import rsal.ros2.cdr.RosMessage;
import rsal.ros2.link.Profile;
import rsal.ros2.link.RosLink;
import rsal.ros2.link.RosTopic;
import rsal.ros2.tf.StampedTransform;
import rsal.ros2.tf.TransformBuffer;
import rsal.ros2.type.Distribution;
import rsal.ros2.type.TypeLibrary;
import rsal.sim.SimProvider;
import rsal.system.Bridge;
import rsal.system.RobotSystemProvider;
import rsal.testkit.contract.RobotBench;

/// Joints of a robot that has some.
class PublishedModelTest extends RobotBench {
    private static final TypeLibrary TYPES = TypeLibrary.of(Distribution.JAZZY);

    private final MemoryNetwork network = new MemoryNetwork();
    private final RosLink there = network.join();

    @Override
    protected RobotSystemProvider provider() {
        return new SimProvider();
    }

    @Override
    protected Map<String, String> parts() {
        return Map.of("turntable", "turntable");
    }

    private List<RosMessage> hear(String topic, String type) {
        var heard = new ArrayList<RosMessage>();
        MessageCodec codec = MessageCodec.of(TYPES.get(type), TYPES);
        there.subscribe(new RosTopic(topic, type), Profile.DEFAULT, bytes -> {
            try {
                heard.add(codec.read(CdrReader.of(bytes)));
            } catch (InvalidCdr e) {
                throw new AssertionError(topic, e);
            }
        });
        return heard;
    }

    @Test
    void jointsAndTheirFramesAreTold() {
        try (Bridge bridge = PublishedRobots.publish(List.of(robot()), WORLD.grid(), network.join(), run)) {
            List<RosMessage> joints = hear("/r1/joint_states", "sensor_msgs/msg/JointState");
            List<RosMessage> transforms = hear("/r1/tf", "tf2_msgs/msg/TFMessage");
            Actuator turntable = robot().require(Actuator.class);
            turntable.goTo(0.4);
            advance(5);
            RosMessage last = joints.getLast();
            List<?> names = last.get("name", List.class);
            assertThat(names).isEqualTo(List.of("turntable"));
            double position = last.get("position", double[].class)[0];
            assertThat(position).isCloseTo(0.4, within(0.01));
            assertThat(last.get("velocity", double[].class)).hasSize(1);
            var frames = new TransformBuffer(TransformBuffer.HISTORY);
            transforms.forEach(each -> StampedTransform.of(each).forEach(frames::add));
            assertThat(frames.find("base_link", "turntable", 0)
                            .transform()
                            .orElseThrow()
                            .planar()
                            .theta())
                    .isCloseTo(position, within(1e-6));
            assertThat(bridge.offers()).isNotEmpty();
        }
    }
}
