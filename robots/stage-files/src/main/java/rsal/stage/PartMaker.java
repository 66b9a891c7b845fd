package rsal.stage;

import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.ToDoubleFunction;
import rsal.data.ActuatorState.Joint;
import rsal.data.Interval;
import rsal.data.LightState.Signal;
import rsal.data.Pose2d;
import rsal.data.Rgb;
import rsal.robot.RobotModel.Part;
import rsal.robot.RobotModel.RangeNoise;

/// Makes parts of the models that a robot carries, called after what they are: `laser`, `laser-2`, `sonar`.
final class PartMaker {
    private static final double RAY = Math.toRadians(1); // as wide as what the simulation takes for a single ray
    private static final int PADDLE_STEPS = 20; // updates that Stage's paddles and lifts take
    private static final double JOULES_PER_KILOGRAM_METER = 10; // what Stage makes a base take to move its mass

    private final Duration step;
    private final Map<String, Integer> names = new HashMap<>();
    private final List<Device> devices = new ArrayList<>();
    private Optional<String> carrier = Optional.empty(); // of what is added

    /// @param step between two states of the world
    PartMaker(Duration step) {
        this.step = step;
    }

    /// A part on a robot.
    ///
    /// @param name of the device
    /// @param height above the underside of the robot [m]
    /// @param carrier the actuator that it stands on
    /// @param model that it was made of
    record Device(String name, Part part, double height, Optional<String> carrier, StageModel model) {}

    List<Device> devices() {
        return devices;
    }

    /// Adds what a model becomes, if it is one that senses or acts.
    ///
    /// @param robotFromModel where it is on the robot, its height above the robot's underside
    /// @param carrier the actuator that it stands on
    /// @return the actuator that carries what is in the model
    Optional<String> add(StageModel model, Placement robotFromModel, Optional<String> carrier) {
        this.carrier = carrier;
        add(model, robotFromModel);
        boolean carries = model.traits().kind() instanceof ModelKind.Actuator actuator && actuator.maxSpeed() > 0;
        return carries ? Optional.of(devices.getLast().name()) : carrier;
    }

    private void add(StageModel model, Placement robotFromModel) {
        Duration period = period(model.traits().updateInterval());
        Pose2d pose = robotFromModel.pose();
        String name = model.macro();
        double height = robotFromModel.z();
        switch (model.traits().kind()) {
            case ModelKind.Ranger ranger -> ranger(model, ranger, robotFromModel, period);
            case ModelKind.Blobfinder finder ->
                device(
                        "blob-finder",
                        model,
                        height,
                        new Part.BlobFinder(
                                name,
                                pose.compose(new Pose2d(0, 0, finder.pan())),
                                finder.columns(),
                                finder.rows(),
                                finder.fov(),
                                finder.range(),
                                finder.colors().stream()
                                        .map(color -> Rgb.of(color.rgb()))
                                        .toList(),
                                period));
            case ModelKind.Fiducial finder ->
                device(
                        "fiducial-finder",
                        model,
                        height,
                        new Part.FiducialFinder(
                                name,
                                pose,
                                finder.fov(),
                                finder.range().max(),
                                Math.min(finder.idRange(), finder.range().max()),
                                finder.key(),
                                finder.ignoresHeight(),
                                period));
            case ModelKind.Gripper gripper -> device("gripper", model, height, gripper(model, gripper, pose, period));
            case ModelKind.Bumper bumper ->
                device(
                        "bumper",
                        model,
                        height,
                        new Part.Bumper(
                                name,
                                bumper.strips().stream()
                                        .map(strip -> new Part.Bumper.Pad(
                                                pose.compose(
                                                        strip.bumperFromStrip().pose()),
                                                strip.length()))
                                        .toList(),
                                period));
            case ModelKind.Actuator actuator ->
                device("actuator", model, height, actuator(name, actuator, pose, period));
            case ModelKind.Blinkenlight light ->
                device(
                        "light",
                        model,
                        height,
                        new Part.Light(
                                name,
                                pose,
                                Rgb.of(model.traits()
                                        .color()
                                        .orElse(StageColor.GREEN)
                                        .rgb()),
                                new Signal(
                                        light.period().isPositive() ? light.period() : step,
                                        light.enabled() ? light.dutyCycle() : 0),
                                period));
            case ModelKind.Position _, ModelKind.Thing _, ModelKind.Camera _, ModelKind.LightIndicator _ -> {}
        }
    }

    /// Adds the battery of a robot that has one; what never runs dry is none. What is on the robot and has no store of
    /// its own charges it and is charged from it.
    ///
    /// @param use of all that it carries while it works [W]
    void battery(StageModel robot, double use) {
        Traits.Energy energy = robot.traits().energy();
        OptionalDouble stored = energy.stored();
        OptionalDouble capacity = energy.capacity();
        carrier = Optional.empty();
        if (stored.isPresent() && capacity.isPresent() && Double.isFinite(capacity.getAsDouble())) {
            device(
                    "battery",
                    robot,
                    0,
                    new Part.Battery(
                            robot.macro(),
                            capacity.getAsDouble(),
                            Math.min(stored.getAsDouble(), capacity.getAsDouble()),
                            1 + use, // as Stage adds for every base
                            JOULES_PER_KILOGRAM_METER * robot.traits().mass(),
                            JOULES_PER_KILOGRAM_METER * robot.traits().mass(),
                            all(robot, Traits.Energy::take),
                            all(robot, Traits.Energy::give),
                            period(robot.traits().updateInterval())));
        }
    }

    private static double all(StageModel model, ToDoubleFunction<Traits.Energy> power) {
        double sum = power.applyAsDouble(model.traits().energy());
        for (StageModel child : model.children()) {
            sum += child.traits().energy().stored().isEmpty() ? all(child, power) : 0;
        }
        return sum;
    }

    private static Part gripper(StageModel model, ModelKind.Gripper gripper, Pose2d pose, Duration period) {
        Size size = model.traits().size();
        Duration moving = model.traits().updateInterval().multipliedBy(PADDLE_STEPS);
        return new Part.Gripper(
                model.macro(),
                pose.compose(model.traits().origin().pose()),
                size.x(),
                size.y(),
                size.z(),
                gripper.paddle().x(),
                gripper.paddle().y(),
                moving,
                moving,
                gripper.closed(),
                gripper.up(),
                gripper.snatches(),
                period);
    }

    private static Interval limits(ModelKind.Actuator actuator) {
        return new Interval(
                Math.min(actuator.positions().min(), actuator.positions().max()),
                Math.max(actuator.positions().min(), actuator.positions().max()));
    }

    /// Where an actuator is at first, and all that is in it: Stage moves it from its pose by where it starts.
    static Placement atStart(ModelKind.Actuator actuator) {
        double start = limits(actuator).clamp(actuator.start());
        return actuator.turning()
                ? Placement.of(0, 0, 0, start)
                : Placement.of(start * actuator.x(), start * actuator.y(), start * actuator.z(), 0);
    }

    private static Part actuator(String name, ModelKind.Actuator actuator, Pose2d pose, Duration period) {
        Interval limits = limits(actuator);
        double axis = actuator.turning() ? 0 : Math.atan2(actuator.y(), actuator.x());
        double slope = actuator.turning() ? 0 : Math.atan2(actuator.z(), Math.hypot(actuator.x(), actuator.y()));
        return new Part.Actuator(
                name,
                pose.compose(new Pose2d(0, 0, axis)),
                actuator.turning() ? Joint.ROTATIONAL : Joint.LINEAR,
                slope,
                limits,
                actuator.maxSpeed(),
                limits.clamp(actuator.start()),
                period);
    }

    /// Transducers of one ray each that are alike in all but their place.
    private record Alike(rsal.stage.ValueRange range, RangeNoise noise, double height) {}

    private void ranger(StageModel model, ModelKind.Ranger ranger, Placement robotFromModel, Duration period) {
        var rings = new LinkedHashMap<Alike, List<Pose2d>>();
        for (ModelKind.Transducer eye : ranger.transducers()) {
            Placement placed = robotFromModel.compose(eye.rangerFromTransducer());
            double height = placed.z() + eye.size().z() / 2;
            if (eye.spacing() > 0) {
                device(
                        "laser",
                        model,
                        height,
                        new Part.Laser(
                                model.macro(),
                                placed.pose(),
                                eye.first(),
                                eye.spacing(),
                                eye.samples(),
                                Math.max(0, eye.range().min()),
                                eye.range().max(),
                                noise(eye),
                                period));
            } else {
                rings.computeIfAbsent(new Alike(eye.range(), noise(eye), height), _ -> new ArrayList<>())
                        .add(placed.pose());
            }
        }
        rings.forEach((alike, poses) -> device(
                "sonar",
                model,
                alike.height(),
                new Part.Sonars(
                        model.macro(),
                        poses,
                        RAY,
                        Math.max(0, alike.range().min()),
                        alike.range().max(),
                        alike.noise(),
                        period)));
    }

    /// Stage turns rays by a part of the angle between them.
    private static RangeNoise noise(ModelKind.Transducer eye) {
        ModelKind.RangeNoise noise = eye.noise();
        return new RangeNoise(
                Math.sqrt(Math.max(0, noise.variance())),
                Math.min(1, Math.abs(noise.relative())),
                Math.min(Math.PI, eye.spacing() * Math.abs(noise.angular()) / 2));
    }

    private void device(String kind, StageModel model, double height, Part part) {
        int number = names.merge(kind, 1, Integer::sum);
        devices.add(new Device(number == 1 ? kind : kind + "-" + number, part, height, carrier, model));
    }

    /// Readings are taken at steps.
    private Duration period(Duration interval) {
        long steps = Math.max(1, Math.ceilDiv(interval.toNanos(), step.toNanos()));
        return step.multipliedBy(steps);
    }
}
