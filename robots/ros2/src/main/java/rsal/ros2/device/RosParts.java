package rsal.ros2.device;

import java.util.List;
import java.util.Optional;
import rsal.device.DeviceInfo;
import rsal.robot.RobotModel.Part;

/// Parts of models that become devices by topics, beside those that [RosRobot] itself knows.
final class RosParts {
    private static final List<Maker> ALL =
            List.of(new ImuMaker(), new GripperMaker(), new BlobFinderMaker(), new CameraMaker());

    private RosParts() {}

    /// Makes devices of one kind of parts.
    interface Maker {
        boolean makes(Part part);

        /// Whether a robot has the topics that the part needs.
        ///
        /// @param name the device's
        boolean isThere(String name, Part part, RobotTopics topics, RosSettings settings);

        /// Whether it has all topics by which the part can do more.
        default boolean isComplete(String name, Part part, RobotTopics topics, RosSettings settings) {
            return isThere(name, part, topics, settings);
        }

        /// @param part one that is there
        RosDevice make(DeviceInfo info, Part part, RosContext context);
    }

    /// Who makes a device of a part.
    static Optional<Maker> maker(Part part) {
        return ALL.stream().filter(maker -> maker.makes(part)).findFirst();
    }
}
