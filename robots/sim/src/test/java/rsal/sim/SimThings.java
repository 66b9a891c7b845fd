package rsal.sim;

import java.nio.file.Path;
import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.Map;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Rgb;
import rsal.data.Shape;
import rsal.data.Solid;
import rsal.device.SimulationControl.Thing;
import rsal.model.RobotModels;
import rsal.robot.RobotModel;
import rsal.robot.RobotModel.Part;
import rsal.settings.FileSource;
import rsal.settings.Location;

/// Things and parts to test with.
final class SimThings {
    static final Rgb RED = new Rgb(255, 0, 0);

    private SimThings() {}

    static Thing can(String name, double x, double y, double radius, double height) {
        Solid body = Solid.standing(new Shape.Disc(new Point2d(0, 0), radius), height);
        return Thing.of(name, new Pose2d(x, y, 0), body, RED);
    }

    /// Open from x = 0.3 to 0.5 of a robot, 0.24 m across, 0.2 m high, 2 s from open to closed and from down to up.
    /// Tells of every step.
    static Part.Gripper gripper() {
        return gripper(false, false, false);
    }

    static Part.Gripper gripper(boolean closed, boolean raised, boolean snatches) {
        return new Part.Gripper(
                "gripper",
                new Pose2d(0.35, 0, 0),
                0.3,
                0.3,
                0.2,
                0.2,
                0.03,
                Duration.ofSeconds(2),
                Duration.ofSeconds(2),
                closed,
                raised,
                snatches,
                Duration.ofMillis(10));
    }

    /// A Pioneer with all parts there are.
    static RobotModel pioneer() {
        var choices = new LinkedHashMap<String, RobotModels.Choice>();
        Map.of(
                        "laser", "urg04lx",
                        "camera", "blob-camera",
                        "fiducials", "fiducials180",
                        "gripper", "pioneer-gripper",
                        "bumper", "pioneer2dx-bumpers",
                        "turntable", "turntable",
                        "battery", "pioneer-battery",
                        "light", "beacon")
                .entrySet()
                .stream()
                .sorted(Map.Entry.comparingByKey())
                .forEach(e -> choices.put(e.getKey(), new RobotModels.Choice(e.getValue(), Location.of("test"))));
        return new RobotModels(FileSource.folder(Path.of("."))).read("pioneer2dx", Location.of("test"), choices);
    }
}
