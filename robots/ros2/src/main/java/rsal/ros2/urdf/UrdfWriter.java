package rsal.ros2.urdf;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import rsal.data.ActuatorState.Joint;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Prism;
import rsal.data.Rgb;
import rsal.data.Shape;
import rsal.robot.RobotModel;
import rsal.robot.RobotModel.Part;
import rsal.robot.RobotModel.Steering;
import rsal.robot.RobotModel.Wheels;
import rsal.ros2.message.FrameTransform;
import rsal.ros2.message.FrameTransform.Quaternion;

/// A robot model as URDF: its body, the frames of its lasers and sonars, its actuators as joints of their names, and
/// the two wheels of a differential drive if the model has them. The origin of `base_link` is on the floor. A piece
/// that is neither a disc nor a rectangle is the box around it, as URDF has no prisms.
public final class UrdfWriter {
    public static final String BASE = "base_link";

    /// Joints of the wheels, as many robots have them.
    public static final String LEFT_WHEEL = "wheel_left_joint";

    public static final String RIGHT_WHEEL = "wheel_right_joint";

    private static final Rgb PLAIN = new Rgb(0x99, 0x99, 0x99);
    private static final double SQUARE = 1e-6; // how large the cosine of a right angle may be

    private final RobotModel model;
    private final StringBuilder xml = new StringBuilder();

    private UrdfWriter(RobotModel model) {
        this.model = model;
    }

    /// @param name the robot's
    public static String urdf(String name, RobotModel model) {
        return new UrdfWriter(model).write(name);
    }

    /// Where a laser or a single sonar is. Poses are known in the plane; the model has heights.
    ///
    /// @param frame the device's name; of sonars with a number, `sonar_3`
    public static FrameTransform mounting(RobotModel model, String frame, Pose2d baseFromFrame) {
        String device = model.sensors().containsKey(frame) ? frame : frame.replaceFirst("_\\d+$", "");
        return level(baseFromFrame, model.height(device));
    }

    private static FrameTransform level(Pose2d pose, double height) {
        FrameTransform flat = FrameTransform.of(pose);
        return new FrameTransform(flat.x(), flat.y(), height, flat.rotation());
    }

    /// What carries a device: the base, or an actuator.
    public static String carrier(RobotModel model, String device) {
        return model.carriers().getOrDefault(device, BASE);
    }

    /// Where what an actuator moves is, in the frame of what carries it.
    ///
    /// @param device name of the actuator
    /// @param actuator the part that it is
    /// @param position of its joint [m or rad]
    public static FrameTransform moved(RobotModel model, String device, Part.Actuator actuator, double position) {
        FrameTransform home = home(model, device, actuator);
        double distance = position - actuator.home();
        FrameTransform motion = switch (actuator.joint()) {
            case ROTATIONAL -> level(new Pose2d(0, 0, distance), 0);
            case LINEAR ->
                level(new Pose2d(distance * Math.cos(actuator.slope()), 0, 0), distance * Math.sin(actuator.slope()));
        };
        return home.compose(motion);
    }

    /// Those of a differential drive; empty where the model does not say.
    public static Optional<Wheels> wheels(RobotModel model) {
        return model.drive().steering() instanceof Steering.Differential drive ? drive.wheels() : Optional.empty();
    }

    /// The link that turns with a wheel's joint.
    public static String link(String wheel) {
        return wheel.replace("_joint", "_link");
    }

    /// Where a wheel is in the frame of the base.
    ///
    /// @param joint one of [#LEFT_WHEEL] and [#RIGHT_WHEEL]
    /// @param angle by which it has turned forward [rad]
    public static FrameTransform wheel(Wheels wheels, String joint, double angle) {
        double y = (joint.equals(LEFT_WHEEL) ? 1 : -1) * wheels.track() / 2;
        return new FrameTransform(
                0, y, wheels.radius(), new Quaternion(0, Math.sin(angle / 2), 0, Math.cos(angle / 2)));
    }

    private static FrameTransform home(RobotModel model, String device, Part.Actuator actuator) {
        FrameTransform own = level(actuator.baseFromJoint(), model.height(device));
        String carrier = carrier(model, device);
        return model.sensors().get(carrier) instanceof Part.Actuator below
                ? level(below.baseFromJoint(), model.height(carrier)).inverse().compose(own)
                : own;
    }

    private String write(String name) {
        add("<?xml version=\"1.0\"?>\n<robot name=\"%s\">\n  <link name=\"%s\">\n", name, BASE);
        int number = 0;
        for (Prism piece : model.body().pieces()) {
            write(piece, number++);
        }
        add("  </link>\n");
        wheels(model).ifPresent(this::writeWheels);
        model.sensors().forEach(this::write);
        return xml.append("</robot>\n").toString();
    }

    /// Texts within are escaped.
    private void add(String format, Object... values) {
        var escaped = new Object[values.length];
        for (int i = 0; i < values.length; i++) {
            escaped[i] = values[i] instanceof String text ? escaped(text) : values[i];
        }
        xml.append(String.format(Locale.ROOT, format, escaped));
    }

    private static String escaped(String text) {
        return text.replace("&", "&amp;").replace("<", "&lt;").replace("\"", "&quot;");
    }

    private void write(Prism piece, int number) {
        Rgb color = piece.color().orElse(PLAIN);
        add("    <visual>\n");
        writeGeometry(piece);
        add(
                "      <material name=\"piece_%d\"><color rgba=\"%.3f %.3f %.3f 1\"/></material>\n    </visual>\n",
                number, color.red() / 255.0, color.green() / 255.0, color.blue() / 255.0);
        add("    <collision>\n");
        writeGeometry(piece);
        add("    </collision>\n");
    }

    private void writeGeometry(Prism piece) {
        double height = piece.top() - piece.bottom();
        double middle = (piece.top() + piece.bottom()) / 2;
        switch (piece.shape()) {
            case Shape.Disc(Point2d center, double radius) -> {
                writeOrigin(new Pose2d(center.x(), center.y(), 0), middle);
                add("      <geometry><cylinder radius=\"%.4f\" length=\"%.4f\"/></geometry>\n", radius, height);
            }
            case Shape.Polygon(List<Point2d> corners) -> {
                Box box = isRectangle(corners) ? rectangle(corners) : around(corners);
                writeOrigin(box.middle, middle);
                add("      <geometry><box size=\"%.4f %.4f %.4f\"/></geometry>\n", box.length, box.width, height);
            }
        }
    }

    private void writeOrigin(Pose2d pose, double z) {
        add("      <origin xyz=\"%.4f %.4f %.4f\" rpy=\"0 0 %.4f\"/>\n", pose.x(), pose.y(), z, pose.theta());
    }

    private record Box(Pose2d middle, double length, double width) {}

    private static boolean isRectangle(List<Point2d> corners) {
        if (corners.size() != 4) {
            return false;
        }
        for (int i = 0; i < 4; i++) {
            Point2d a = corners.get(i);
            Point2d b = corners.get((i + 1) % 4);
            Point2d c = corners.get((i + 2) % 4);
            double along = (b.x() - a.x()) * (c.x() - b.x()) + (b.y() - a.y()) * (c.y() - b.y());
            if (Math.abs(along) > SQUARE * a.distanceTo(b) * b.distanceTo(c)) {
                return false;
            }
        }
        return true;
    }

    private static Box rectangle(List<Point2d> corners) {
        Point2d a = corners.get(0);
        Point2d b = corners.get(1);
        Point2d c = corners.get(2);
        double heading = Math.atan2(b.y() - a.y(), b.x() - a.x());
        return new Box(new Pose2d((a.x() + c.x()) / 2, (a.y() + c.y()) / 2, heading), a.distanceTo(b), b.distanceTo(c));
    }

    private static Box around(List<Point2d> corners) {
        double left = corners.stream().mapToDouble(Point2d::x).min().orElseThrow();
        double right = corners.stream().mapToDouble(Point2d::x).max().orElseThrow();
        double bottom = corners.stream().mapToDouble(Point2d::y).min().orElseThrow();
        double top = corners.stream().mapToDouble(Point2d::y).max().orElseThrow();
        return new Box(new Pose2d((left + right) / 2, (bottom + top) / 2, 0), right - left, top - bottom);
    }

    private void write(String name, Part part) {
        switch (part) {
            case Part.Laser laser -> writeFixed(name, laser.baseFromLaser());
            case Part.Sonars sonars -> {
                for (int i = 0; i < sonars.baseFromSensors().size(); i++) {
                    writeFixed(
                            "%s_%d".formatted(name, i), sonars.baseFromSensors().get(i));
                }
            }
            case Part.Actuator actuator -> writeMoving(name, actuator);
            default -> {}
        }
    }

    private void writeFixed(String frame, Pose2d baseFromFrame) {
        FrameTransform there = mounting(model, frame, baseFromFrame);
        begin(frame, frame + "_joint", "fixed", BASE, there);
        add("  </joint>\n");
    }

    private void writeWheels(Wheels wheels) {
        for (String joint : List.of(LEFT_WHEEL, RIGHT_WHEEL)) {
            begin(link(joint), joint, "continuous", BASE, wheel(wheels, joint, 0));
            add("    <axis xyz=\"0 1 0\"/>\n  </joint>\n");
        }
    }

    private void begin(String frame, String joint, String type, String parent, FrameTransform there) {
        add("  <link name=\"%s\"/>\n  <joint name=\"%s\" type=\"%s\">\n", frame, joint, type);
        add("    <parent link=\"%s\"/><child link=\"%s\"/>\n", parent, frame);
        add(
                "    <origin xyz=\"%.4f %.4f %.4f\" rpy=\"0 0 %.4f\"/>\n",
                there.x(), there.y(), there.z(), there.planar().theta());
    }

    /// Its link is as the model has it while the joint is at home.
    private void writeMoving(String name, Part.Actuator actuator) {
        boolean isTurning = actuator.joint() == Joint.ROTATIONAL;
        begin(name, name, isTurning ? "revolute" : "prismatic", carrier(model, name), moved(model, name, actuator, 0));
        double slope = actuator.slope();
        add("    <axis xyz=\"%.4f 0 %.4f\"/>\n", isTurning ? 0 : Math.cos(slope), isTurning ? 1 : Math.sin(slope));
        add(
                "    <limit lower=\"%.4f\" upper=\"%.4f\" velocity=\"%.4f\" effort=\"0\"/>\n  </joint>\n",
                actuator.limits().least(), actuator.limits().most(), actuator.maxSpeed());
    }
}
