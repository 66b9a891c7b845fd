package rsal.cli.run;

import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import rsal.cli.terminal.Destination;
import rsal.data.OccupancyGrid;
import rsal.data.Stamped;
import rsal.device.Mapper;
import rsal.engine.LiveRun;
import rsal.engine.report.RobotView;
import rsal.map.RosMap;
import rsal.scenario.RunPlan;
import rsal.scenario.RunPlan.PlannedRobot;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;

/// Maps that robots drew in a run, as files that ROS and scenarios read.
final class SavedMaps {
    private final Destination folder;

    private SavedMaps(Destination folder) {
        this.folder = folder;
    }

    /// Looks before the run whether there will be maps, and whether they can be written.
    ///
    /// @throws InvalidSettings when not
    static SavedMaps to(String folder, RunPlan plan, boolean force) {
        List<String> robots = plan.robots().stream()
                .filter(SavedMaps::draws)
                .map(robot -> robot.spec().id())
                .toList();
        if (robots.isEmpty()) {
            throw new InvalidSettings(
                    Location.of("--save-maps"),
                    "No robot of this run draws a map.",
                    "Robots with an explorer do: devices: {laser: urg04lx, localizer: {type: slam}, navigator: {},"
                            + " explorer: {}}.");
        }
        List<String> names = robots.stream()
                .flatMap(robot -> Stream.of(yaml(robot), image(robot)))
                .toList();
        return new SavedMaps(Destination.of(folder, names, force).prepare());
    }

    private static boolean draws(PlannedRobot robot) {
        return robot.drivers().stream()
                .anyMatch(made -> Mapper.class.isAssignableFrom(made.driver().makes()));
    }

    /// Writes what robots have drawn until now, and tells which files that are.
    void write(LiveRun run, PrintWriter err) {
        var contents = new LinkedHashMap<String, byte[]>();
        for (RobotView robot : run.snapshot().robots()) {
            robot.map().map(Stamped::value).ifPresent(map -> put(contents, robot.id(), map));
        }
        folder.write(contents);
        if (contents.isEmpty()) {
            err.println("No map was saved: none was drawn.");
        }
        contents.keySet().stream()
                .filter(name -> name.endsWith(".yaml"))
                .forEach(name -> err.println("Map saved: " + folder.resolve(name)));
    }

    private static void put(Map<String, byte[]> contents, String robot, OccupancyGrid map) {
        contents.put(image(robot), RosMap.pgm(map));
        contents.put(yaml(robot), RosMap.yaml(map, image(robot)).getBytes(StandardCharsets.UTF_8));
    }

    private static String yaml(String robot) {
        return robot + ".yaml";
    }

    private static String image(String robot) {
        return robot + ".pgm";
    }
}
