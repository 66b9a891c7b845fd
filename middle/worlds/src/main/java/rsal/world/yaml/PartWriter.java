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
    record Told(Pose2d mount, Map<String, Object> settings) {}

    static Told write(Part part) {
        var told = new LinkedHashMap<String, Object>();
        Pose2d mount = switch (part) {
            case Part.Laser laser -> laser(told, laser);
            case Part.Sonars sonars -> {
                told.put("type", "sonars");
                told.put(
                        "sensors",
                        sonars.baseFromSensors().stream()
                                .map(pose -> SceneWriter.pose(pose, 0))
                                .toList());
                told.put("fieldOfView", YamlText.degrees(sonars.fieldOfView()));
                told.put("range", List.of(sonars.rangeMin(), sonars.rangeMax()));
                noise(told, sonars.noise());
                yield Pose2d.ORIGIN;
            }
            case Part.BlobFinder finder -> {
                told.put("type", "blob-finder");
                told.put("image", List.of((long) finder.width(), (long) finder.height()));
                told.put("fieldOfView", fieldOfView(finder.fieldOfView()));
                told.put("range", finder.rangeMax());
                if (!finder.colors().isEmpty()) {
                    told.put(
                            "colors",
                            finder.colors().stream().map(Object::toString).toList());
                }
                yield finder.baseFromCamera();
            }
            case Part.FiducialFinder finder -> {
                told.put("type", "fiducial-finder");
                told.put("fieldOfView", fieldOfView(finder.fieldOfView()));
                told.put("range", finder.rangeMax());
                told.put("idRange", finder.idRange());
                told.put("key", (long) finder.key());
                flag(told, "allHeights", finder.allHeights());
                yield finder.baseFromFinder();
            }
            case Part.Gripper gripper -> gripper(told, gripper);
            case Part.Bumper bumper -> {
                told.put("type", "bumper");
                told.put(
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
            case Part.Actuator actuator -> actuator(told, actuator);
            case Part.Battery battery -> {
                told.put("type", "battery");
                told.put("capacity", battery.capacity());
                told.put("charge", battery.charge());
                told.put("idlePower", battery.idlePower());
                told.put("energyPerMeter", battery.energyPerMeter());
                told.put(
                        "energyPerDegree",
                        YamlText.inverse(
                                battery.energyPerRadian(), Math::toDegrees, Math.toRadians(battery.energyPerRadian())));
                told.put("chargingPower", battery.chargingPower());
                told.put("givingPower", battery.givingPower());
                yield Pose2d.ORIGIN;
            }
            case Part.Light light -> {
                told.put("type", "light");
                told.put("color", light.color().toString());
                told.put("flashPeriod", seconds(light.signal().period()));
                told.put("dutyCycle", light.signal().dutyCycle());
                yield light.baseFromLight();
            }
            case Part.Registered other -> {
                told.put("type", other.kind().key());
                told.putAll(other.arguments().written());
                yield other.baseFromDevice();
            }
            case Part.Own own -> {
                told.put("type", own(own.makes()));
                yield Pose2d.ORIGIN;
            }
        };
        period(part).ifPresent(period -> told.put("period", seconds(period)));
        return new Told(mount, told);
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
    private static Pose2d laser(Map<String, Object> told, Part.Laser laser) {
        double middle = laser.angleMin() + laser.angleIncrement() * (laser.samples() - 1) / 2;
        boolean even = Math.abs(middle) < 1e-12;
        told.put("type", "laser");
        told.put(
                "fieldOfView",
                fieldOfView(even ? -2 * laser.angleMin() : laser.angleIncrement() * (laser.samples() - 1)));
        told.put("samples", (long) laser.samples());
        told.put("range", List.of(laser.rangeMin(), laser.rangeMax()));
        noise(told, laser.noise());
        return even ? laser.baseFromLaser() : laser.baseFromLaser().compose(new Pose2d(0, 0, middle));
    }

    private static void noise(Map<String, Object> told, RangeNoise noise) {
        told.put("noise", noise.deviation());
        if (noise.share() != 0) {
            told.put("relativeNoise", noise.share());
        }
        if (noise.angle() != 0) {
            told.put("angularNoise", YamlText.degrees(noise.angle()));
        }
    }

    private static void flag(Map<String, Object> told, String key, boolean on) {
        if (on) {
            told.put(key, true);
        }
    }

    private static Pose2d gripper(Map<String, Object> told, Part.Gripper gripper) {
        told.put("type", "gripper");
        told.put("length", gripper.length());
        told.put("width", gripper.width());
        told.put("height", gripper.height());
        told.put("paddleLength", gripper.paddleLength());
        told.put("paddleWidth", gripper.paddleWidth());
        told.put("closingTime", seconds(gripper.closingTime()));
        if (gripper.hasLift()) {
            told.put("liftingTime", seconds(gripper.liftingTime()));
        }
        flag(told, "closed", gripper.closed());
        flag(told, "raised", gripper.raised());
        flag(told, "snatches", gripper.snatches());
        return gripper.baseFromGripper();
    }

    private static Pose2d actuator(Map<String, Object> told, Part.Actuator actuator) {
        boolean turns = actuator.joint() == Joint.ROTATIONAL;
        double unit = turns ? Math.toRadians(1) : 1;
        double least = inUnits(actuator.limits().least(), unit);
        double most = inUnits(actuator.limits().most(), unit);
        told.put("type", "actuator");
        told.put("joint", turns ? "rotational" : "linear");
        if (actuator.slope() != 0) {
            told.put("slope", Math.clamp(YamlText.degrees(actuator.slope()), -STRAIGHT_UP, STRAIGHT_UP));
        }
        told.put("limits", List.of(least, most));
        told.put("maxSpeed", inUnits(actuator.maxSpeed(), unit));
        told.put("home", Math.clamp(inUnits(actuator.home(), unit), least, most));
        return actuator.baseFromJoint();
    }

    private static double inUnits(double value, double unit) {
        return YamlText.inverse(value, told -> told * unit, value / unit);
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
