package rsal.ros2.device;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import rsal.device.Device;
import rsal.device.DeviceInfo;
import rsal.robot.RobotModel;
import rsal.robot.RobotModel.Part;
import rsal.ros2.health.ReportNames;
import rsal.ros2.setting.RosSettings;

/// Parts of models that become devices by topics and actions.
final class RosParts {
    private static final List<Maker> ALL = List.of(
            new LaserMaker(),
            new SonarMaker(),
            new BatteryMaker(),
            new ImuMaker(),
            new GripperMaker(),
            new BlobFinderMaker(),
            new CameraMaker(),
            new LocalizerMaker(),
            new NavigatorMaker(),
            new PlannerMaker(),
            new DockingMaker(),
            new BumperMaker(),
            new MapMaker());

    private RosParts() {}

    /// Whether a part is a device that the robot's own programs make.
    static boolean isOwn(Part part, Class<? extends Device> type) {
        return part instanceof Part.Own own && own.makes().equals(type);
    }

    /// Makes devices of one kind of parts.
    interface Maker {
        boolean makes(Part part);

        /// By which names the robot's programs speak of its devices.
        ReportNames reportNames();

        /// Whether a robot has the topics that the part needs.
        boolean isThere(Wanted wanted, RobotTopics topics, RosSettings settings);

        /// Whether it has all topics by which the part can do more.
        default boolean isComplete(Wanted wanted, RobotTopics topics, RosSettings settings) {
            return isThere(wanted, topics, settings);
        }

        /// @param wanted one that is there
        RosDevice make(DeviceInfo info, Wanted wanted, RosContext context);
    }

    /// A part of a robot's model, and what makes its device.
    ///
    /// @param name the device's
    /// @param number how many parts of its kind come before it
    record Wanted(String name, Part part, int number, Maker maker) {
        boolean isThere(RobotTopics topics, RosSettings settings) {
            return maker.isThere(this, topics, settings);
        }

        boolean isComplete(RobotTopics topics, RosSettings settings) {
            return maker.isComplete(this, topics, settings);
        }
    }

    /// All parts of a model of which devices can be made, in its order.
    static List<Wanted> wanted(RobotModel model) {
        var all = new ArrayList<Wanted>();
        var counts = new HashMap<Maker, Integer>();
        for (Map.Entry<String, Part> sensor : model.sensors().entrySet()) {
            maker(sensor.getValue())
                    .ifPresent(maker -> all.add(new Wanted(
                            sensor.getKey(), sensor.getValue(), counts.merge(maker, 1, Integer::sum) - 1, maker)));
        }
        return all;
    }

    /// What makes a device of a part.
    static Optional<Maker> maker(Part part) {
        return ALL.stream().filter(maker -> maker.makes(part)).findFirst();
    }
}
