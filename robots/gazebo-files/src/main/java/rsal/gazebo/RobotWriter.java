package rsal.gazebo;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import rsal.data.Footprint;
import rsal.data.Interval;
import rsal.data.Point2d;
import rsal.data.Prism;
import rsal.data.Rgb;
import rsal.data.Shape;
import rsal.data.Solid;
import rsal.robot.RobotModel;
import rsal.robot.RobotModel.Drive;
import rsal.robot.RobotModel.Part;
import rsal.robot.RobotModel.Steering;
import rsal.robot.RobotSpec;
import rsal.scene.Block;
import rsal.scene.Entity;

/// Writes robots: those with two rows of wheels drive on two wheels and two balls inside their outline, which are
/// chosen here since models tell nothing of wheels; all others get the velocity that they are told.
final class RobotWriter {
    private static final double LARGEST_WHEEL = 0.1; // radius [m]
    private static final double SMALLEST_WHEEL = 0.004; // radius [m]; robots without room for it have none
    private static final double ABOVE = 0.03; // lens of a laser above what it stands on [m]
    private static final double DENSITY = 150; // [kg/m³]
    private static final Rgb BLACK = new Rgb(0x20, 0x20, 0x20);
    private static final int RATE = 20; // of odometry [Hz]

    private final SdfXml xml;
    private final ShapeWriter shapes;
    private final BridgeConfig bridge;
    private final Set<String> notes;

    RobotWriter(SdfXml xml, ShapeWriter shapes, BridgeConfig bridge, Set<String> notes) {
        this.xml = xml;
        this.shapes = shapes;
        this.bridge = bridge;
        this.notes = notes;
    }

    /// Wheels that a robot is given.
    ///
    /// @param radius [m]
    /// @param width how thick a wheel is [m]
    /// @param separation between the middles of both [m]
    /// @param front where the ball in front is [m]
    /// @param rear where the ball behind is [m]
    private record Wheels(double radius, double width, double separation, double front, double rear) {
        double ball() {
            return radius / 3;
        }
    }

    /// @param name of its model
    void write(String name, RobotSpec robot, Entity body) {
        String plain = name.replaceAll("[^A-Za-z0-9_]", "_");
        String namespace =
                "/" + (Character.isDigit(plain.charAt(0)) ? "_" + plain : plain); // as robot system ros2 has it
        String topics = "/model" + namespace;
        RobotModel model = robot.model();
        Optional<Wheels> wheels = model.drive().steering() instanceof Steering.Differential
                ? wheels(model.footprint(), model.body().top())
                : Optional.empty();
        xml.open("model", "name", name);
        xml.numbers(
                "pose",
                body.mapFromEntity().x(),
                body.mapFromEntity().y(),
                body.height(),
                0,
                0,
                body.mapFromEntity().theta());
        base(body.blocks(), wheels);
        lasers(model, namespace, topics);
        xml.close("link");
        wheels.ifPresent(this::wheels);
        drive(model.drive(), wheels, topics);
        xml.close("model");
        bridge.robot(namespace, topics);
    }

    /// The largest that fit into an outline.
    private static Optional<Wheels> wheels(Footprint outline, double top) {
        double radius = Math.min(Math.min(LARGEST_WHEEL, outline.inscribedRadius() / 2), top / 2);
        if (radius < SMALLEST_WHEEL) {
            return Optional.empty();
        }
        double reach =
                Math.min(halfWidth(outline, -radius), Math.min(halfWidth(outline, 0), halfWidth(outline, radius)));
        double width = radius * 0.4;
        double room = 1.01 * radius / 3; // for a ball, and a bit
        List<Point2d> turned = outline.corners().stream()
                .map(corner -> new Point2d(corner.y(), corner.x()))
                .toList();
        Interval length = cut(turned, 0);
        return Optional.of(new Wheels(radius, width, 2 * reach - width, length.most() - room, length.least() + room));
    }

    /// How far an outline reaches to the side on which it reaches less, at a place along the robot [m].
    private static double halfWidth(Footprint outline, double x) {
        return cut(outline.corners(), x).reach();
    }

    /// From where to where a line along y is inside a convex outline, which it crosses.
    private static Interval cut(List<Point2d> corners, double x) {
        double low = Double.POSITIVE_INFINITY;
        double high = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < corners.size(); i++) {
            Point2d a = corners.get(i);
            Point2d b = corners.get((i + 1) % corners.size());
            if (Math.min(a.x(), b.x()) <= x && x <= Math.max(a.x(), b.x())) {
                for (double y : a.x() == b.x()
                        ? new double[] {a.y(), b.y()}
                        : new double[] {a.y() + (x - a.x()) / (b.x() - a.x()) * (b.y() - a.y())}) {
                    low = Math.min(low, y);
                    high = Math.max(high, y);
                }
            }
        }
        return low <= high ? new Interval(low, high) : new Interval(0, 0);
    }

    private void base(List<Block> blocks, Optional<Wheels> wheels) {
        xml.open("link", "name", "base_link");
        var body = new Solid(blocks.stream().map(Block::prism).toList());
        double mass = Math.clamp(DENSITY * Shape.Polygon.of(body.hull()).area() * body.top(), 0.05, 500);
        shapes.inertia(body.hull(), 0, body.top(), mass);
        double clearance = wheels.map(w -> w.radius() / 2).orElse(0.0);
        for (int i = 0; i < blocks.size(); i++) {
            Block block = blocks.get(i);
            Prism lifted = lifted(block.prism(), clearance);
            if (block.surface().obstacle()) {
                shapes.collision("c" + i, lifted, wheels.isPresent() ? Optional.empty() : Optional.of(0.0));
            }
            if (block.surface().seenByRangers()) {
                shapes.visual("v" + i, lifted, block.surface().color());
            }
        }
        wheels.ifPresent(w -> {
            ball("front_ball", w.front(), w.ball());
            ball("rear_ball", w.rear(), w.ball());
        });
    }

    /// What would touch the floor ends above it.
    private static Prism lifted(Prism prism, double clearance) {
        double bottom = Math.max(prism.bottom(), Math.min(clearance, (prism.bottom() + prism.top()) / 2));
        return new Prism(prism.shape(), bottom, prism.top(), prism.color());
    }

    private void ball(String name, double x, double radius) {
        xml.open("collision", "name", name).numbers("pose", x, 0, radius, 0, 0, 0);
        xml.open("geometry")
                .open("sphere")
                .numbers("radius", radius)
                .close("sphere")
                .close("geometry");
        xml.open("surface").open("friction").open("ode").numbers("mu", 0).numbers("mu2", 0);
        xml.close("ode").close("friction").close("surface").close("collision");
    }

    private void wheels(Wheels wheels) {
        wheel("left_wheel", wheels.separation() / 2, wheels);
        wheel("right_wheel", -wheels.separation() / 2, wheels);
    }

    private void wheel(String name, double y, Wheels wheels) {
        double r = wheels.radius();
        double mass = Math.max(0.01, 1000 * Math.PI * r * r * wheels.width());
        xml.open("link", "name", name).numbers("pose", 0, y, r, -Math.PI / 2, 0, 0);
        xml.open("inertial");
        double across = mass / 12 * (3 * r * r + wheels.width() * wheels.width());
        shapes.moments(mass, across, across, mass / 2 * r * r);
        xml.close("inertial");
        for (String kind : List.of("collision", "visual")) {
            xml.open(kind, "name", kind).open("geometry").open("cylinder");
            xml.numbers("radius", r)
                    .numbers("length", wheels.width())
                    .close("cylinder")
                    .close("geometry");
            if (kind.equals("visual")) {
                shapes.color(BLACK);
            }
            xml.close(kind);
        }
        xml.close("link");
        xml.open("joint", "name", name + "_joint", "type", "revolute");
        xml.leaf("parent", "base_link").leaf("child", name);
        xml.open("axis").leaf("xyz", "0 0 1").close("axis").close("joint");
    }

    private void drive(Drive drive, Optional<Wheels> wheels, String topics) {
        if (wheels.isPresent()) {
            xml.open("plugin", "filename", "gz-sim-diff-drive-system", "name", "gz::sim::systems::DiffDrive");
            xml.leaf("left_joint", "left_wheel_joint").leaf("right_joint", "right_wheel_joint");
            xml.numbers("wheel_separation", wheels.get().separation());
            xml.numbers("wheel_radius", wheels.get().radius());
            limits(drive);
            xml.leaf("topic", topics + "/cmd_vel");
            odometry(topics, "frame_id", "child_frame_id");
            return;
        }
        if (!(drive.steering() instanceof Steering.Omnidirectional)) {
            notes.add("Cars, and robots without room for wheels, are written as robots that go in every direction.");
        }
        xml.open("plugin", "filename", "gz-sim-velocity-control-system", "name", "gz::sim::systems::VelocityControl");
        limits(drive);
        xml.leaf("topic", topics + "/cmd_vel").close("plugin");
        xml.open(
                "plugin",
                "filename",
                "gz-sim-odometry-publisher-system",
                "name",
                "gz::sim::systems::OdometryPublisher");
        odometry(topics, "odom_frame", "robot_base_frame");
    }

    private void odometry(String topics, String outer, String inner) {
        xml.leaf("odom_topic", topics + "/odom").leaf("tf_topic", topics + "/tf");
        xml.leaf(outer, "odom").leaf(inner, "base_link");
        xml.numbers("odom_publish_frequency", RATE).close("plugin");
    }

    private void limits(Drive drive) {
        limits("linear_velocity", drive.forward().speed());
        limits("angular_velocity", drive.turn().speed());
        limits("linear_acceleration", drive.forward().acceleration());
        limits("angular_acceleration", drive.turn().acceleration());
    }

    private void limits(String name, Interval interval) {
        xml.numbers("min_" + name, interval.least()).numbers("max_" + name, interval.most());
    }

    private void lasers(RobotModel model, String namespace, String topics) {
        var topicNames = new ArrayList<String>();
        for (Map.Entry<String, Part> entry : model.sensors().entrySet()) {
            if (entry.getValue() instanceof Part.Laser laser) {
                String device = entry.getKey().replaceAll("[^A-Za-z0-9_]", "_");
                String topic = topicNames.isEmpty() ? "scan" : device;
                topicNames.add(topic);
                laser(entry.getKey(), laser, model, topics + "/" + topic);
                bridge.laser(namespace, topics, topic);
            } else if (!(entry.getValue() instanceof Part.Own)) {
                notes.add("Of devices only lasers are written, not sonars, cameras, grippers and others.");
            }
        }
    }

    private void laser(String device, Part.Laser laser, RobotModel model, String topic) {
        Double written = model.heights().get(device);
        double height = written == null ? model.body().top() + ABOVE : written;
        if (written != null && written < model.body().top()) {
            notes.add("A laser below the top of its robot may see the robot itself in Gazebo.");
        }
        xml.open("sensor", "name", device.isEmpty() ? "laser" : device, "type", "gpu_lidar");
        xml.numbers(
                "pose",
                laser.baseFromLaser().x(),
                laser.baseFromLaser().y(),
                height,
                0,
                0,
                laser.baseFromLaser().theta());
        xml.leaf("topic", topic).leaf("gz_frame_id", device);
        xml.numbers("update_rate", 1e9 / laser.period().toNanos()).leaf("always_on", "true");
        xml.open("lidar").open("scan").open("horizontal");
        xml.numbers("samples", laser.samples()).numbers("resolution", 1);
        xml.numbers("min_angle", laser.angleMin());
        xml.numbers("max_angle", laser.angleMin() + (laser.samples() - 1) * laser.angleIncrement());
        xml.close("horizontal").close("scan");
        xml.open("range").numbers("min", laser.rangeMin()).numbers("max", laser.rangeMax());
        xml.numbers("resolution", 0.01).close("range");
        if (laser.noise().deviation() > 0) {
            xml.open("noise").leaf("type", "gaussian").numbers("mean", 0);
            xml.numbers("stddev", laser.noise().deviation()).close("noise");
        }
        xml.close("lidar").close("sensor");
    }
}
