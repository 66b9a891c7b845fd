package rsal.world.yaml;

import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import rsal.data.ActuatorState.Joint;
import rsal.data.Pose2d;
import rsal.device.Canvas;
import rsal.device.Device;
import rsal.device.Docking;
import rsal.device.Localizer;
import rsal.device.Mapper;
import rsal.device.Planner;
import rsal.robot.RobotModel.Part;
import rsal.robot.RobotModel.RangeNoise;

/// Writes parts of robots as part files have them.
final class PartWriter {
    private static final double FULL_TURN = 360;
    private static final double STRAIGHT_UP = 90;

    private PartWriter() {}

    /// @param mount where on the robot it sits
    /// @param settings what it is
    record Reported(Pose2d mount, Map<String, Object> settings) {}

    static Reported write(Part part) {
        var properties = new LinkedHashMap<String, Object>();
        Pose2d mount = switch (part) {
            case Part.Laser laser -> laser(properties, laser);
            case Part.Sonars sonars -> {
                properties.put("type", "sonars");
                properties.put(
                        "sensors",
                        sonars.baseFromSensors().stream()
                                .map(pose -> SceneWriter.pose(pose, 0))
                                .toList());
                properties.put("fieldOfView", YamlText.degrees(sonars.fieldOfView()));
                properties.put("range", List.of(sonars.rangeMin(), sonars.rangeMax()));
                noise(properties, sonars.noise());
                yield Pose2d.ORIGIN;
            }
            case Part.BlobFinder finder -> {
                properties.put("type", "blob-finder");
                properties.put("image", List.of((long) finder.width(), (long) finder.height()));
                properties.put("fieldOfView", fieldOfView(finder.fieldOfView()));
                properties.put("range", finder.rangeMax());
                if (!finder.colors().isEmpty()) {
                    properties.put(
                            "colors",
                            finder.colors().stream().map(Object::toString).toList());
                }
                yield finder.baseFromCamera();
            }
            case Part.FiducialFinder finder -> {
                properties.put("type", "fiducial-finder");
                properties.put("fieldOfView", fieldOfView(finder.fieldOfView()));
                properties.put("range", finder.rangeMax());
                properties.put("idRange", finder.idRange());
                properties.put("key", (long) finder.key());
                flag(properties, "allHeights", finder.allHeights());
                yield finder.baseFromFinder();
            }
            case Part.Gripper gripper -> gripper(properties, gripper);
            case Part.Bumper bumper -> {
                properties.put("type", "bumper");
                properties.put(
                        "bumpers",
                        bumper.pads().stream()
                                .map(pad -> {
                                    var row = new ArrayList<>(SceneWriter.pose(pad.baseFromPad(), 0));
                                    row.add(pad.length());
                                    return row;
                                })
                                .toList());
                yield Pose2d.ORIGIN;
            }
            case Part.Actuator actuator -> actuator(properties, actuator);
            case Part.Battery battery -> {
                properties.put("type", "battery");
                properties.put("capacity", battery.capacity());
                properties.put("charge", battery.charge());
                properties.put("idlePower", battery.idlePower());
                properties.put("energyPerMeter", battery.energyPerMeter());
                properties.put(
                        "energyPerDegree",
                        YamlText.inverse(
                                battery.energyPerRadian(), Math::toDegrees, Math.toRadians(battery.energyPerRadian())));
                properties.put("chargingPower", battery.chargingPower());
                properties.put("givingPower", battery.givingPower());
                yield Pose2d.ORIGIN;
            }
            case Part.Light light -> {
                properties.put("type", "light");
                properties.put("color", light.color().toString());
                properties.put("flashPeriod", seconds(light.signal().period()));
                properties.put("dutyCycle", light.signal().dutyCycle());
                yield light.baseFromLight();
            }
            case Part.Registered other -> {
                properties.put("type", other.kind().key());
                properties.putAll(other.arguments().written());
                yield other.baseFromDevice();
            }
            case Part.Own own -> {
                properties.put("type", own(own.makes()));
                yield Pose2d.ORIGIN;
            }
        };
        period(part).ifPresent(period -> properties.put("period", seconds(period)));
        return new Reported(mount, properties);
    }

    private static String own(Class<? extends Device> made) {
        if (made.equals(Mapper.class)) {
            return "map";
        }
        if (made.equals(Canvas.class)) {
            return "canvas";
        }
        if (made.equals(Planner.class)) {
            return "planner";
        }
        if (made.equals(Docking.class)) {
            return "docking";
        }
        return made.equals(Localizer.class) ? "localizer" : "navigator";
    }

    /// Beams that are not the same to both sides are turned together.
    private static Pose2d laser(Map<String, Object> properties, Part.Laser laser) {
        double middle = laser.angleMin() + laser.angleIncrement() * (laser.samples() - 1) / 2;
        boolean even = Math.abs(middle) < 1e-12;
        properties.put("type", "laser");
        properties.put(
                "fieldOfView",
                fieldOfView(even ? -2 * laser.angleMin() : laser.angleIncrement() * (laser.samples() - 1)));
        properties.put("samples", (long) laser.samples());
        properties.put("range", List.of(laser.rangeMin(), laser.rangeMax()));
        noise(properties, laser.noise());
        return even ? laser.baseFromLaser() : laser.baseFromLaser().compose(new Pose2d(0, 0, middle));
    }

    private static void noise(Map<String, Object> properties, RangeNoise noise) {
        properties.put("noise", noise.deviation());
        if (noise.share() != 0) {
            properties.put("relativeNoise", noise.share());
        }
        if (noise.angle() != 0) {
            properties.put("angularNoise", YamlText.degrees(noise.angle()));
        }
    }

    private static void flag(Map<String, Object> properties, String key, boolean on) {
        if (on) {
            properties.put(key, true);
        }
    }

    private static Pose2d gripper(Map<String, Object> properties, Part.Gripper gripper) {
        properties.put("type", "gripper");
        properties.put("length", gripper.length());
        properties.put("width", gripper.width());
        properties.put("height", gripper.height());
        properties.put("paddleLength", gripper.paddleLength());
        properties.put("paddleWidth", gripper.paddleWidth());
        properties.put("closingTime", seconds(gripper.closingTime()));
        if (gripper.hasLift()) {
            properties.put("liftingTime", seconds(gripper.liftingTime()));
        }
        flag(properties, "closed", gripper.closed());
        flag(properties, "raised", gripper.raised());
        flag(properties, "snatches", gripper.snatches());
        return gripper.baseFromGripper();
    }

    private static Pose2d actuator(Map<String, Object> properties, Part.Actuator actuator) {
        boolean turns = actuator.joint() == Joint.ROTATIONAL;
        double unit = turns ? Math.toRadians(1) : 1;
        double least = inUnits(actuator.limits().least(), unit);
        double most = inUnits(actuator.limits().most(), unit);
        properties.put("type", "actuator");
        properties.put("joint", turns ? "rotational" : "linear");
        if (actuator.slope() != 0) {
            properties.put("slope", Math.clamp(YamlText.degrees(actuator.slope()), -STRAIGHT_UP, STRAIGHT_UP));
        }
        properties.put("limits", List.of(least, most));
        properties.put("maxSpeed", inUnits(actuator.maxSpeed(), unit));
        properties.put("home", Math.clamp(inUnits(actuator.home(), unit), least, most));
        return actuator.baseFromJoint();
    }

    private static double inUnits(double value, double unit) {
        return YamlText.inverse(value, properties -> properties * unit, value / unit);
    }

    private static double fieldOfView(double radians) {
        return Math.min(FULL_TURN, YamlText.degrees(radians));
    }

    private static double seconds(Duration duration) {
        return duration.toNanos() / 1e9;
    }

    private static Optional<Duration> period(Part part) {
        return switch (part) {
            case Part.Laser laser -> Optional.of(laser.period());
            case Part.Sonars sonars -> Optional.of(sonars.period());
            case Part.BlobFinder finder -> Optional.of(finder.period());
            case Part.FiducialFinder finder -> Optional.of(finder.period());
            case Part.Gripper gripper -> Optional.of(gripper.period());
            case Part.Bumper bumper -> Optional.of(bumper.period());
            case Part.Actuator actuator -> Optional.of(actuator.period());
            case Part.Battery battery -> Optional.of(battery.period());
            case Part.Light light -> Optional.of(light.period());
            case Part.Registered other -> Optional.of(other.period());
            case Part.Own _ -> Optional.empty();
        };
    }
}
