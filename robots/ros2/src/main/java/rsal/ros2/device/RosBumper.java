package rsal.ros2.device;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import rsal.data.Angles;
import rsal.data.BumperState;
import rsal.data.Pose2d;
import rsal.device.Bumper;
import rsal.device.DeviceInfo;
import rsal.device.Health;
import rsal.robot.RobotModel.Part;
import rsal.ros2.cdr.RosMessage;
import rsal.ros2.message.RosMessages;

/// Bumpers, each of which is a topic of the type `std_msgs/Bool`, as ROS has no type of its own for them; or all
/// of them are in the hazards of an iRobot Create 3. Topics may tell changes only, so that silence means nothing:
/// readings are repeated while all topics have publishers. Before a bumper has told anything it is not pressed.
final class RosBumper extends RosSensor<BumperState> implements Bumper {
    private static final int BUMP = 1; // of the types of hazards

    /// Where the parts of a Create 3's bumper are that its hazards name by their frames: angles at the base's origin
    /// [rad].
    private static final Map<String, Double> ZONES = Map.of(
            "bump_left", 0.4 * Math.PI,
            "bump_front_left", 0.2 * Math.PI,
            "bump_front_center", 0.0,
            "bump_front_right", -0.2 * Math.PI,
            "bump_right", -0.4 * Math.PI);

    private final Duration period;
    private final List<Pose2d> baseFromBumpers;
    private final BitSet pressed = new BitSet();
    private final Frames frames;
    private Instant repeated = Instant.MIN;

    RosBumper(DeviceInfo info, Part.Bumper part, Frames frames) {
        super(info, info.robot() + "/base_link", info.name());
        this.period = part.period();
        this.frames = frames;
        baseFromBumpers = part.pads().stream().map(Part.Bumper.Pad::baseFromPad).toList();
    }

    /// @param message `std_msgs/Bool` of one of them
    void take(int bumper, RosMessage message) {
        boolean isPressed = message.get("data", Boolean.class);
        if (pressed.get(bumper) != isPressed) {
            pressed.set(bumper, isPressed);
            repeat();
        }
    }

    /// @param message `irobot_create_msgs/HazardDetectionVector`: the hazards that there are now
    void takeHazards(RosMessage message) {
        var now = new BitSet();
        for (RosMessage hazard : message.messages("detections")) {
            String frame = RosMessages.frame(hazard.message("header").text("frame_id"));
            Double angle = ZONES.get(frame.substring(frame.lastIndexOf('/') + 1));
            if (hazard.integer("type") == BUMP && angle != null) {
                now.set(nearest(angle));
            }
        }
        if (!now.equals(pressed)) {
            pressed.clear();
            pressed.or(now);
            repeat();
        }
    }

    /// The model's bumper in a direction.
    private int nearest(double angle) {
        return IntStream.range(0, baseFromBumpers.size())
                .boxed()
                .min(Comparator.comparingDouble(i -> {
                    Pose2d bumper = baseFromBumpers.get(i);
                    return Math.abs(Angles.difference(Math.atan2(bumper.y(), bumper.x()), angle));
                }))
                .orElseThrow();
    }

    private void repeat() {
        var all = new ArrayList<Boolean>();
        for (int i = 0; i < baseFromBumpers.size(); i++) {
            all.add(pressed.get(i));
        }
        repeated = frames.now();
        publish(repeated, new BumperState(baseFromBumpers, all));
    }

    /// @param silent of the topics that nobody publishes, for people
    void look(Instant now, List<String> silent) {
        if (!silent.isEmpty()) {
            health(new Health.Lost("Nobody publishes %s.".formatted(String.join(", ", silent))));
        } else if (!repeated.plus(period).isAfter(now)) {
            repeat();
        }
    }
}
