package rsal.cli.show;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import rsal.cli.terminal.FileError;
import rsal.cli.terminal.TextTable;
import rsal.data.OccupancyGrid;
import rsal.robot.RobotModel;
import rsal.robot.RobotModel.Steering;
import rsal.robot.RobotSpec;
import rsal.scene.RobotService;
import rsal.scene.Scene;
import rsal.settings.Problem;

/// What is in a world, as `rsal show --json FILE.world` prints it.
///
/// @param extent left, bottom, right, top of its map [m]
/// @param step of simulated time [s]
/// @param end simulated time after which a run of it ends [s]
/// @param models how many of which kind the file has
/// @param walls floor plans, in cells
/// @param services that its file asks servers to offer
/// @param image where it is drawn
record ShownWorld(
        String file,
        String title,
        List<Double> extent,
        Optional<Double> step,
        Optional<Double> end,
        Map<String, Integer> models,
        List<Plan> walls,
        int things,
        List<Make> robots,
        List<Served> services,
        List<FileError> warnings,
        String image) {

    record Plan(int columns, int rows, double cell) {}

    /// @param needs what its driver works with
    record Served(String driver, int port, List<String> devices, List<String> needs, Optional<String> robot) {
        static Served of(RobotService service) {
            return new Served(service.driver(), service.port(), service.devices(), service.needs(), service.robot());
        }
    }

    /// Robots of one role and model.
    ///
    /// @param devices by name, with the type of each
    /// @param carriers the actuators that devices stand on, by the device's name
    /// @param programs what drives how many of them where the world comes from
    record Make(
            String role,
            int count,
            List<String> ids,
            String drive,
            Map<String, String> devices,
            Map<String, String> carriers,
            Map<String, Integer> programs) {}

    static ShownWorld of(String file, Scene scene, String image) {
        OccupancyGrid map = scene.map();
        return new ShownWorld(
                file,
                scene.title(),
                List.of(
                        rounded(map.originX()),
                        rounded(map.originY()),
                        rounded(map.originX() + map.width() * map.resolution()),
                        rounded(map.originY() + map.height() * map.resolution())),
                scene.step().map(step -> step.toNanos() / 1e9),
                scene.end().map(end -> end.toNanos() / 1e9),
                scene.contents(),
                scene.walls().stream()
                        .map(wall -> new Plan(wall.width(), wall.height(), wall.cellX()))
                        .toList(),
                scene.things().size(),
                makes(scene),
                scene.services().stream().map(Served::of).toList(),
                FileError.of(scene.warnings()),
                image);
    }

    private static List<Make> makes(Scene scene) {
        record Kind(String role, RobotModel model) {}
        var byKind = new LinkedHashMap<Kind, List<String>>();
        for (RobotSpec robot : scene.robots()) {
            byKind.computeIfAbsent(new Kind(robot.role(), robot.model()), _ -> new ArrayList<>())
                    .add(robot.id());
        }
        var makes = new ArrayList<Make>();
        byKind.forEach((kind, ids) -> {
            RobotModel model = kind.model;
            var devices = new LinkedHashMap<String, String>();
            model.sensors()
                    .forEach((name, part) -> devices.put(name, part.makes().getSimpleName()));
            var programs = new TreeMap<String, Integer>();
            ids.forEach(id -> Optional.ofNullable(scene.programs().get(id))
                    .ifPresent(program -> programs.merge(program, 1, Integer::sum)));
            makes.add(new Make(
                    kind.role,
                    ids.size(),
                    ids,
                    drive(model.drive()),
                    devices,
                    new TreeMap<>(model.carriers()),
                    programs));
        });
        return List.copyOf(makes);
    }

    private static String drive(RobotModel.Drive drive) {
        String steering = switch (drive.steering()) {
            case Steering.Differential _ -> "differential";
            case Steering.Omnidirectional _ -> "omnidirectional";
            case Steering.Car _ -> "car";
        };
        return String.format(
                Locale.ROOT, "%s, %.2f m/s, %.0f°/s", steering, drive.maxSpeed(), Math.toDegrees(drive.maxTurnRate()));
    }

    private static String on(@Nullable String carrier) {
        return carrier == null ? "" : " on '%s'".formatted(carrier);
    }

    private static double rounded(double value) {
        return Math.round(value * 1e3) / 1e3;
    }

    /// For people.
    String text() {
        var text = new StringBuilder();
        text.append("%s%s%n".formatted(file, title.isEmpty() ? "" : ": " + title));
        text.append(String.format(
                Locale.ROOT,
                "from (%.2f, %.2f) to (%.2f, %.2f) m, in steps of %.3g s%s%n",
                extent.get(0),
                extent.get(1),
                extent.get(2),
                extent.get(3),
                step.orElse(0.1),
                end.map(" for %.0f s"::formatted).orElse("")));
        var contents = new TextTable("  ");
        models.forEach((name, count) -> contents.row(String.valueOf(count), name));
        section(text, "Models", contents);
        var solid = new TextTable("  ");
        walls.forEach(plan -> solid.row(
                "floor plan",
                String.format(Locale.ROOT, "%d × %d cells of %.3g m", plan.columns, plan.rows, plan.cell)));
        solid.row("things", String.valueOf(things));
        section(text, "What is solid", solid);
        var moving = new TextTable("  ");
        for (Make make : robots) {
            moving.row(make.role, make.count + " × " + make.drive, programs(make));
            make.devices.forEach((name, type) -> moving.row("", name + ": " + type + on(make.carriers.get(name))));
        }
        section(text, "Robots", moving);
        var offered = new TextTable("  ");
        for (Served service : services) {
            offered.row(
                    String.valueOf(service.port()),
                    service.robot().orElse(""),
                    String.join(", ", service.devices()),
                    service.driver() + (service.needs().isEmpty() ? "" : " on " + String.join(", ", service.needs())));
        }
        section(text, "Served at ports", offered);
        if (!warnings.isEmpty()) {
            text.append("\nWarnings\n");
        }
        return text.toString();
    }

    private static String programs(Make make) {
        return make.programs.entrySet().stream()
                .map(program -> "%sdriven by %s"
                        .formatted(program.getValue() < make.count ? program.getValue() + " " : "", program.getKey()))
                .collect(Collectors.joining(", "));
    }

    private static void section(StringBuilder text, String heading, TextTable table) {
        if (!table.isEmpty()) {
            text.append('\n').append(heading).append('\n').append(table);
        }
    }

    /// A warning as people read it.
    static String line(Problem warning) {
        return "  " + warning;
    }
}
