package rsal.world.yaml;

import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import rsal.data.Interval;
import rsal.data.Prism;
import rsal.data.Rgb;
import rsal.model.RobotModels;
import rsal.robot.RobotModel;
import rsal.robot.RobotModel.Axis;
import rsal.robot.RobotModel.Drive;
import rsal.robot.RobotModel.OdometryNoise;
import rsal.robot.RobotModel.Steering;
import rsal.robot.RobotSpec;
import rsal.scene.Block;
import rsal.scene.Entity;
import rsal.scene.Scene;
import rsal.scene.Surface;

/// Writes the models of a scene's robots, those of one make once.
final class ModelWriter {
    private static final double ROOT_OF_DEGREE = Math.sqrt(Math.toRadians(1));

    private final Scene scene;
    private final Map<String, Object> models = new LinkedHashMap<>();
    private final Map<String, Object> parts = new LinkedHashMap<>();
    private final Map<Make, String> names = new LinkedHashMap<>();
    private final IdentityHashMap<List<Block>, Map<Rgb, String>> known = new IdentityHashMap<>();

    ModelWriter(Scene scene) {
        this.scene = scene;
    }

    /// @param blocks of its body; those without a color have that of the robot
    private record Make(RobotModel model, List<Block> blocks) {}

    Map<String, Object> models() {
        return models;
    }

    Map<String, Object> parts() {
        return parts;
    }

    /// What the model of a robot is called in the file.
    String nameOf(RobotSpec robot) {
        Rgb color = Rgb.parse(robot.color()).orElse(Surface.PLAIN.color());
        Entity body = scene.robotBodies().get(robot.id());
        if (body == null) {
            return nameOf(
                    new Make(robot.model(), blocks(Entity.blocks(robot.model().body(), color), color)));
        }
        return known.computeIfAbsent(body.blocks(), _ -> new LinkedHashMap<>())
                .computeIfAbsent(color, c -> nameOf(new Make(robot.model(), blocks(body.blocks(), c))));
    }

    /// Colors that are not the robot's are told by each piece.
    private static List<Block> blocks(List<Block> blocks, Rgb robot) {
        return blocks.stream()
                .map(block -> {
                    Rgb color = block.surface().color();
                    Prism prism = block.prism();
                    return new Block(
                            new Prism(
                                    prism.shape(),
                                    prism.bottom(),
                                    prism.top(),
                                    color.equals(robot) ? Optional.empty() : Optional.of(color)),
                            block.surface().in(Surface.PLAIN.color()),
                            block.carrier());
                })
                .toList();
    }

    private String nameOf(Make make) {
        return names.computeIfAbsent(make, _ -> {
            String name = free(make.model().name(), models);
            models.put(name, model(make, name));
            return name;
        });
    }

    private static String free(String wanted, Map<String, Object> taken) {
        String name = wanted.equals(RobotModels.NO_PART) ? wanted + "-1" : wanted;
        for (int i = 2; taken.containsKey(name); i++) {
            name = wanted + "-" + i;
        }
        return name;
    }

    private Map<String, Object> model(Make make, String name) {
        RobotModel model = make.model();
        var written = new LinkedHashMap<String, Object>();
        if (!model.title().equals(name)) {
            written.put("title", model.title());
        }
        written.put("body", SceneWriter.body(make.blocks(), Surface.PLAIN, false));
        written.put("drive", drive(model.drive()));
        var mounts = new LinkedHashMap<String, Object>();
        var sensors = new LinkedHashMap<String, Object>();
        model.sensors().forEach((device, part) -> {
            var properties = PartWriter.write(part);
            var mount = new ArrayList<>(SceneWriter.pose(properties.mount(), 0));
            Double height = model.heights().get(device);
            if (height != null) {
                mount.add(height);
            }
            String carrier = model.carriers().get(device);
            mounts.put(device, carrier == null ? mount : onActuator(carrier, mount));
            sensors.put(device, partName(part.name(), properties.settings()));
        });
        if (!sensors.isEmpty()) {
            written.put("mounts", mounts);
            written.put("sensors", sensors);
        }
        return written;
    }

    private static Map<String, Object> onActuator(String carrier, List<?> pose) {
        var mount = new LinkedHashMap<String, Object>();
        mount.put("actuator", carrier);
        mount.put("pose", pose);
        return mount;
    }

    private String partName(String wanted, Map<String, Object> settings) {
        for (int i = 1; ; i++) {
            String name = i == 1 ? wanted : wanted + "-" + i;
            if (!name.equals(RobotModels.NO_PART) && settings.equals(parts.computeIfAbsent(name, _ -> settings))) {
                return name;
            }
        }
    }

    private static Map<String, Object> drive(Drive drive) {
        var written = new LinkedHashMap<String, Object>();
        switch (drive.steering()) {
            case Steering.Differential differential ->
                differential.wheels().ifPresent(wheels -> {
                    var sizes = new LinkedHashMap<String, Object>();
                    sizes.put("radius", wheels.radius());
                    sizes.put("track", wheels.track());
                    written.put("wheels", sizes);
                });
            case Steering.Omnidirectional _ -> written.put("type", "omnidirectional");
            case Steering.Car car -> {
                written.put("type", "car");
                written.put("wheelbase", car.wheelbase());
                written.put("maxSteeringAngle", YamlText.degrees(car.maxSteeringAngle()));
            }
        }
        axis(written, "maxSpeed", "maxAcceleration", drive.forward());
        if (drive.steering() instanceof Steering.Omnidirectional) {
            axis(written, "maxSideSpeed", "maxSideAcceleration", drive.sideways());
        }
        axis(
                written,
                "maxTurnRate",
                "maxTurnAcceleration",
                new Axis(degrees(drive.turn().speed()), degrees(drive.turn().acceleration())));
        OdometryNoise noise = drive.odometryNoise();
        var properties = new LinkedHashMap<String, Object>();
        properties.put("distancePerMeter", noise.distancePerMeter());
        properties.put("headingPerMeter", YamlText.degrees(noise.headingPerMeter()));
        properties.put(
                "headingPerDegree",
                YamlText.inverse(
                        noise.headingPerRadian(),
                        root -> ROOT_OF_DEGREE * root,
                        noise.headingPerRadian() / ROOT_OF_DEGREE));
        written.put("odometryNoise", properties);
        return written;
    }

    private static Interval degrees(Interval radians) {
        return new Interval(YamlText.degrees(radians.least()), YamlText.degrees(radians.most()));
    }

    private static void axis(Map<String, Object> written, String speed, String acceleration, Axis axis) {
        written.put(speed, bothWays(axis.speed()));
        written.put(acceleration, bothWays(axis.acceleration()));
    }

    private static Object bothWays(Interval interval) {
        return interval.least() == -interval.most()
                ? (Object) interval.most()
                : List.of(interval.least(), interval.most());
    }
}
