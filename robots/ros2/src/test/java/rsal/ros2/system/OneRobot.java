package rsal.ros2.system;

import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SplittableRandom;
import rsal.model.RobotModels;
import rsal.robot.RobotSpec;
import rsal.ros2.MemoryNetwork;
import rsal.ros2.setting.GripperSettings;
import rsal.ros2.setting.RosSettings;
import rsal.ros2.setting.Safety;
import rsal.ros2.type.Distribution;
import rsal.settings.FileSource;
import rsal.settings.Location;
import rsal.system.RealRobots.Waiting;
import rsal.testkit.contract.RobotBench;
import rsal.time.Scheduler;

/// The robot `r1` of most tests, a Pioneer 2-DX with some parts whose topics are in `/r1`. Its motors are on from the
/// beginning.
record OneRobot(MemoryNetwork network, Scheduler run, Optional<Distribution> distribution, GripperSettings gripper) {
    private static final Location HERE = Location.of("test");

    OneRobot(MemoryNetwork network, Scheduler run) {
        this(network, run, Optional.empty(), GripperSettings.USUAL);
    }

    /// @param parts that it has, by the names of devices
    static RobotSpec spec(Map<String, String> parts) {
        var choices = new LinkedHashMap<String, RobotModels.Choice>();
        parts.forEach((device, part) -> choices.put(device, new RobotModels.Choice(part, HERE)));
        var model = new RobotModels(FileSource.resources(RobotBench.class, "/")).read("pioneer2dx", HERE, choices);
        return new RobotSpec("r1", "tested", model, Optional.empty(), "#3366cc");
    }

    /// The robot system that has this robot alone.
    Ros2System system(Map<String, String> parts) {
        return new Ros2System(
                Map.of(spec(parts), "/r1"),
                "domain 0",
                network::join,
                distribution,
                new RosSettings(new Safety(Duration.ofMillis(500), true, "", ""), gripper, List.of(), true, false),
                Waiting.USUAL,
                run,
                new SplittableRandom(1));
    }
}
