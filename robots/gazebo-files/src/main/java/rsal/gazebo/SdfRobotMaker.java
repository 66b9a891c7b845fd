package rsal.gazebo;

import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import rsal.data.Interval;
import rsal.data.Pose2d;
import rsal.data.Prism;
import rsal.data.Solid;
import rsal.model.xml.Transform;
import rsal.model.xml.XmlElement;
import rsal.robot.RobotModel;
import rsal.robot.RobotModel.Axis;
import rsal.robot.RobotModel.Drive;
import rsal.robot.RobotModel.OdometryNoise;
import rsal.robot.RobotModel.Part;
import rsal.robot.RobotModel.RangeNoise;
import rsal.robot.RobotModel.Steering;
import rsal.robot.SimulationLimits;
import rsal.scene.Block;
import rsal.scene.Surface;

/// Makes robots of those models that drive: by two rows of wheels, or in every direction. Lasers come along.
final class SdfRobotMaker {
    private static final double USUAL_SPEED = 0.5; // [m/s]
    private static final double USUAL_TURN_RATE = Math.PI / 2; // [rad/s]
    private static final double SLOWEST = 1e-6; // [m/s, rad/s] and per s, of what can't move that way
    private static final double FASTEST = 1e3; // the same; Gazebo has no limit of its own
    private static final int MOST_SAMPLES = 10_000; // of a laser
    private static final double USUAL_PERIOD = 0.1; // [s]
    private static final OdometryNoise USUAL_NOISE =
            new OdometryNoise(0.02, Math.toRadians(1), 0.2 * Math.sqrt(Math.toRadians(1)));

    private final BodyMaker bodies;
    private final SdfNotes notes;

    SdfRobotMaker(BodyMaker bodies, SdfNotes notes) {
        this.bodies = bodies;
        this.notes = notes;
    }

    /// A robot.
    ///
    /// @param modelFromBase where its base is: between the wheels, where it touches the floor
    record Made(RobotModel model, Transform modelFromBase) {}

    /// What a plugin is, by its file and name; they were called otherwise in each generation of Gazebo.
    private enum Kind {
        DIFFERENTIAL,
        OMNIDIRECTIONAL,
        CAR;

        static Optional<Kind> of(XmlElement plugin) {
            String name = (plugin.attribute("filename") + " " + plugin.attribute("name"))
                    .toLowerCase(Locale.ROOT)
                    .replaceAll("[-_]", "");
            if (name.contains("diffdrive") || name.contains("skidsteer")) {
                return Optional.of(DIFFERENTIAL);
            }
            if (Stream.of("mecanum", "planarmove", "velocitycontrol").anyMatch(name::contains)) {
                return Optional.of(OMNIDIRECTIONAL);
            }
            return name.contains("ackermann") ? Optional.of(CAR) : Optional.empty();
        }
    }

    /// The robot that a model is; empty for one that drives nowhere, or not in a way that is known.
    Optional<Made> robot(SdfModel model) {
        Optional<XmlElement> plugin = model.all("plugin").stream()
                .filter(reported -> Kind.of(reported).isPresent())
                .findFirst();
        Optional<Kind> kind = plugin.flatMap(Kind::of);
        if (model.isStatic() || kind.isEmpty() || kind.get() == Kind.CAR) {
            noteOther(model, kind.isPresent());
            return Optional.empty();
        }
        Transform flat = middle(model, plugin.get());
        List<Block> blocks = bodies.blocks(model, flat.inverse(), 0);
        if (blocks.isEmpty()) {
            noteOther(model, true);
            return Optional.empty();
        }
        double floor = blocks.stream()
                .mapToDouble(block -> block.prism().bottom())
                .min()
                .orElseThrow();
        Transform modelFromBase = flat.compose(Transform.of(new double[] {0, 0, floor}, new double[3]));
        Solid body =
                new Solid(blocks.stream().map(block -> raised(block, -floor)).toList());
        Drive drive = drive(model, plugin.get(), kind.get());
        var parts = new LinkedHashMap<String, Part>();
        var heights = new HashMap<String, Double>();
        lasers(model, modelFromBase.inverse(), parts, heights);
        String name = model.make().isEmpty() ? model.name() : model.make();
        var made = new RobotModel(name, name, body, drive, parts, heights);
        List<String> problems = SimulationLimits.problems(made);
        if (!problems.isEmpty()) {
            notes.add(
                    "robot " + name,
                    model.location(),
                    "Robot '%s' can't be simulated, and is a thing. %s"
                            .formatted(SdfText.shortened(name), String.join(" ", problems)),
                    "");
            return Optional.empty();
        }
        return Optional.of(new Made(made, modelFromBase));
    }

    private static Prism raised(Block block, double by) {
        Prism prism = block.prism();
        boolean plain = block.surface().color().equals(Surface.PLAIN.color());
        return new Prism(
                prism.shape(),
                prism.bottom() + by,
                prism.top() + by,
                plain ? Optional.empty() : Optional.of(block.surface().color()));
    }

    private void noteOther(SdfModel model, boolean drives) {
        if (drives) {
            notes.add(
                    "drive",
                    model.location(),
                    "Model '%s' drives in a way that is not known here, and is a thing."
                            .formatted(SdfText.shortened(model.name())),
                    "Differential drives, mecanum wheels and velocity control are known.");
            return;
        }
        var lasers = new ArrayList<XmlElement>();
        model.links(link ->
                link.element().all("sensor").filter(SdfRobotMaker::isLaser).forEach(lasers::add));
        if (!lasers.isEmpty()) {
            notes.add(
                    "sensors",
                    lasers.getFirst().location(),
                    "Model '%s' has a laser and no drive, and is a thing.".formatted(SdfText.shortened(model.name())),
                    "");
        }
    }

    /// Where the middle between its wheels is, in the model's frame; its origin when no joint of them is told.
    private Transform middle(SdfModel model, XmlElement plugin) {
        List<Transform> wheels = Stream.of("left_joint", "right_joint", "leftJoint", "rightJoint")
                .flatMap(plugin::all)
                .map(joint -> model.frames().find(joint.text(), Optional.of(joint.location())))
                .toList();
        return Transform.of(
                new double[] {
                    wheels.stream().mapToDouble(Transform::x).average().orElse(0),
                    wheels.stream().mapToDouble(Transform::y).average().orElse(0),
                    0
                },
                new double[3]);
    }

    private Drive drive(SdfModel model, XmlElement plugin, Kind kind) {
        Interval speed = limits(plugin, "linear_velocity", "velocity", USUAL_SPEED);
        Interval turnRate = limits(plugin, "angular_velocity", "velocity", USUAL_TURN_RATE);
        var forward = new Axis(speed, limits(plugin, "linear_acceleration", "acceleration", speed.most()));
        var turn = new Axis(turnRate, limits(plugin, "angular_acceleration", "acceleration", 2 * turnRate.most()));
        if (plugin.children().stream()
                .noneMatch(reported -> reported.name().matches("max_.*(velocity|acceleration)"))) {
            notes.add(
                    "limits",
                    plugin.location(),
                    "Model '%s' tells no speeds: %s m/s and 90 degrees/s are guessed."
                            .formatted(SdfText.shortened(model.name()), USUAL_SPEED),
                    "Write 'max_linear_velocity' and 'max_angular_velocity' into its plugin.");
        }
        return kind == Kind.OMNIDIRECTIONAL
                ? new Drive(new Steering.Omnidirectional(), forward, forward, turn, USUAL_NOISE)
                : new Drive(new Steering.Differential(), forward, Axis.NONE, turn, USUAL_NOISE);
    }

    /// From `min_` to `max_`, of which one alone counts both ways.
    ///
    /// @param other name under which both linear and angular limits can be
    private static Interval limits(XmlElement plugin, String name, String other, double usual) {
        Optional<Double> most = number(plugin, "max_" + name).or(() -> number(plugin, "max_" + other));
        Optional<Double> least = number(plugin, "min_" + name).or(() -> number(plugin, "min_" + other));
        double high = Math.abs(most.or(() -> least).orElse(usual));
        double low = -Math.abs(least.orElse(-high));
        return new Interval(Math.clamp(low, -FASTEST, -SLOWEST), Math.clamp(high, SLOWEST, FASTEST));
    }

    private static Optional<Double> number(XmlElement parent, String child) {
        return parent.first(child).map(XmlElement::number);
    }

    private static boolean isLaser(XmlElement sensor) {
        return List.of("gpu_lidar", "lidar", "ray", "gpu_ray").contains(sensor.attribute("type"));
    }

    private void lasers(SdfModel model, Transform baseFromModel, Map<String, Part> parts, Map<String, Double> heights) {
        model.links(link -> link.element().all("sensor").forEach(sensor -> {
            if (isLaser(sensor)) {
                laser(model, sensor, baseFromModel.compose(link.place(sensor)), parts, heights);
            } else {
                notes.add(
                        "sensor " + sensor.attribute("type"),
                        sensor.location(),
                        "A sensor of type '%s' is left out.".formatted(SdfText.shortened(sensor.attribute("type"))),
                        "");
            }
        }));
    }

    private void laser(
            SdfModel model,
            XmlElement sensor,
            Transform baseFromLaser,
            Map<String, Part> parts,
            Map<String, Double> heights) {
        Optional<XmlElement> lidar = sensor.first("lidar").or(() -> sensor.first("ray"));
        Optional<XmlElement> level = lidar.flatMap(reported -> reported.first("scan", "horizontal"));
        Optional<XmlElement> range = lidar.flatMap(reported -> reported.first("range"));
        if (level.isEmpty() || range.isEmpty() || !Shadow.isUpright(baseFromLaser)) {
            notes.add(
                    "laser",
                    sensor.location(),
                    "A laser of '%s' is left out: it is tilted, or has no 'scan' or 'range'."
                            .formatted(SdfText.shortened(model.name())),
                    "");
            return;
        }
        boolean upsideDown = baseFromLaser.r()[2][2] < 0;
        double least = number(level.get(), "min_angle").orElse(-Math.PI);
        double most = number(level.get(), "max_angle").orElse(Math.PI);
        double field = Math.min(2 * Math.PI, Math.abs(most - least));
        double first = upsideDown ? -Math.max(least, most) : Math.min(least, most);
        int samples = (int) Math.clamp(
                Math.rint(number(level.get(), "samples").orElse(640.0)
                        * number(level.get(), "resolution").orElse(1.0)),
                2,
                MOST_SAMPLES);
        double nearest = Math.clamp(number(range.get(), "min").orElse(0.0), 1e-3, 1e4);
        double farthest = Math.clamp(number(range.get(), "max").orElse(10.0), 2 * nearest, 1e5);
        double rate = number(sensor, "update_rate").orElse(0.0);
        String device = parts.isEmpty() ? "laser" : "laser-" + (parts.size() + 1);
        var pose = new Pose2d(baseFromLaser.x(), baseFromLaser.y(), baseFromLaser.heading());
        parts.put(
                device,
                new Part.Laser(
                        device,
                        pose,
                        first,
                        Math.max(1e-6, field / (samples - 1)),
                        samples,
                        nearest,
                        farthest,
                        RangeNoise.of(Math.max(
                                0,
                                lidar.get()
                                        .first("noise", "stddev")
                                        .map(XmlElement::number)
                                        .orElse(0.0))),
                        Duration.ofNanos((long) (1e9 * (rate > 0 ? Math.clamp(1 / rate, 0.01, 10.0) : USUAL_PERIOD)))));
        heights.put(device, Math.max(0, baseFromLaser.z()));
    }
}
