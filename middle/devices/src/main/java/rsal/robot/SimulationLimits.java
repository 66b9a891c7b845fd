package rsal.robot;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import rsal.device.Device;
import rsal.device.Localizer;
import rsal.device.Mapper;
import rsal.device.Navigator;
import rsal.device.Planner;
import rsal.robot.RobotModel.Axis;
import rsal.robot.RobotModel.Part;

/// Which models of robots a simulation can do: what would need to be different in one that it cannot. Readers of world
/// files look here before a simulator does.
public final class SimulationLimits {
    private static final int MOST_RAYS = 100_000; // of a sensor

    private static final Map<Class<? extends Device>, String> INSTEAD = Map.of(
            Localizer.class,
            "Maybe {type: amcl}?",
            Navigator.class,
            "Maybe {type: navigator}?",
            Planner.class,
            "Maybe {type: wavefront}?",
            Mapper.class,
            "Maybe {type: explorer}?");

    private SimulationLimits() {}

    /// One sentence for each thing that is out of its range; none when the model can be simulated.
    public static List<String> problems(RobotModel model) {
        var problems = new ArrayList<String>();
        RobotModel.Drive drive = model.drive();
        axis(problems, "forward", "m", drive.forward());
        axis(problems, "turn", "rad", drive.turn());
        if (drive.steering() instanceof RobotModel.Steering.Omnidirectional) {
            axis(problems, "sideways", "m", drive.sideways());
        }
        for (Part part : model.sensors().values()) {
            String its = "Part '%s': its ".formatted(part.name());
            switch (part) {
                case Part.Laser laser -> {
                    positive(problems, its + "period [s]", seconds(laser.period()));
                    positive(problems, its + "range [m]", laser.rangeMax());
                    positive(problems, its + "angle between beams [rad]", laser.angleIncrement());
                    count(problems, its + "number of beams", laser.samples());
                }
                case Part.Sonars sonars -> {
                    positive(problems, its + "period [s]", seconds(sonars.period()));
                    positive(problems, its + "range [m]", sonars.rangeMax());
                    positive(problems, its + "field of view [rad]", sonars.fieldOfView());
                    count(
                            problems,
                            its + "number of sonars",
                            sonars.baseFromSensors().size());
                }
                case Part.BlobFinder finder -> {
                    positive(problems, its + "period [s]", seconds(finder.period()));
                    positive(problems, its + "range [m]", finder.rangeMax());
                    positive(problems, its + "field of view [rad]", finder.fieldOfView());
                    count(problems, its + "number of columns", finder.width());
                    count(problems, its + "number of rows", finder.height());
                }
                case Part.FiducialFinder finder -> {
                    positive(problems, its + "period [s]", seconds(finder.period()));
                    positive(problems, its + "range [m]", finder.rangeMax());
                }
                case Part.Gripper gripper -> {
                    positive(problems, its + "period [s]", seconds(gripper.period()));
                    positive(problems, its + "time to close [s]", seconds(gripper.closingTime()));
                    positive(problems, its + "paddles' length [m]", gripper.paddleLength());
                    positive(problems, its + "opening [m]", gripper.opening());
                    positive(problems, its + "height [m]", gripper.height());
                }
                case Part.Bumper bumper -> {
                    positive(problems, its + "period [s]", seconds(bumper.period()));
                    bumper.pads().forEach(pad -> positive(problems, its + "pads' length [m]", pad.length()));
                }
                case Part.Actuator actuator -> {
                    positive(problems, its + "period [s]", seconds(actuator.period()));
                    positive(problems, its + "speed [m/s or rad/s]", actuator.maxSpeed());
                }
                case Part.Battery battery -> {
                    positive(problems, its + "period [s]", seconds(battery.period()));
                    positive(problems, its + "capacity [J]", battery.capacity());
                }
                case Part.Light light -> positive(problems, its + "period [s]", seconds(light.period()));
                case Part.Registered other -> positive(problems, its + "period [s]", seconds(other.period()));
                case Part.Own own ->
                    problems.add("Simulated robots have no computers of their own, and so no '%s'. %s"
                            .formatted(own.name(), INSTEAD.getOrDefault(own.makes(), "Remove it.")));
            }
        }
        return problems;
    }

    private static void axis(List<String> problems, String name, String unit, Axis axis) {
        String its = "Its drive's " + name + " ";
        positive(
                problems,
                its + "speed [" + unit + "/s]",
                axis.speed().most() - axis.speed().least());
        positive(
                problems,
                its + "acceleration [" + unit + "/s²]",
                axis.acceleration().most());
        positive(
                problems,
                its + "deceleration [" + unit + "/s²]",
                -axis.acceleration().least());
    }

    private static double seconds(Duration duration) {
        return duration.toNanos() * 1e-9;
    }

    private static void positive(List<String> problems, String what, double value) {
        if (!(value > 0 && Double.isFinite(value))) {
            problems.add("%s must be positive and finite to be simulated, not '%s'.".formatted(what, value));
        }
    }

    private static void count(List<String> problems, String what, int value) {
        if (value < 1 || value > MOST_RAYS) {
            problems.add("%s must be from 1 to %d to be simulated, not '%d'.".formatted(what, MOST_RAYS, value));
        }
    }
}
