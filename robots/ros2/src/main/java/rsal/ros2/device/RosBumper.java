package rsal.ros2.device;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import rsal.data.BumperState;
import rsal.data.Pose2d;
import rsal.device.Bumper;
import rsal.device.DeviceInfo;
import rsal.device.Health;
import rsal.robot.RobotModel.Part;
import rsal.ros2.cdr.RosMessage;

/// Bumpers, each of which is a topic of the type `std_msgs/Bool`, as ROS has no type of its own for them. Topics may
/// tell changes only, so that silence means nothing: readings are repeated while all topics have publishers. Before a
/// bumper has told anything it is not pressed.
final class RosBumper extends RosSensor<BumperState> implements Bumper {
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
