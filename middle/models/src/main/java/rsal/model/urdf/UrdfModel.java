package rsal.model.urdf;

import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import rsal.data.Footprint;
import rsal.data.Point2d;
import rsal.model.xml.Transform;
import rsal.model.xml.XmlElement;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;
import rsal.settings.Problem;

/// A robot model as text, made of a URDF file: its body from the collision shapes of its links, its drive from
/// its wheels, and places for devices from its laser and camera links. The base's origin is the middle between
/// the wheels, on the floor, x ahead, as robot models have it.
///
/// @param model YAML of the model
/// @param parts YAML of parts for its lasers, by file name
/// @param notes what of the URDF is not in it, or had to be guessed
public record UrdfModel(String model, Map<String, String> parts, List<Problem> notes) {
    /// Of which files the text can be read; larger ones are refused.
    public static final int MOST_CHARACTERS = 10 << 20;

    private static final double USUAL_SPEED = 0.5; // m/s
    private static final double USUAL_TURN_RATE = 90; // deg/s
    private static final double STANDS = 0.3; // |cosine| of a wheel's axis and upwards; more is no wheel to drive on
    private static final int CORNERS = 16; // of a circle
    private static final double THIN = 1e-3; // m
    private static final Pattern CASTER = Pattern.compile("(?i).*(caster|castor|swivel).*");
    private static final Pattern LASER = Pattern.compile("(?i).*(laser|lidar|scan|hokuyo|rplidar|sick|lds).*");
    private static final Pattern CAMERA = Pattern.compile("(?i).*camera.*");

    public UrdfModel {
        parts = Collections.unmodifiableMap(new LinkedHashMap<>(parts));
        notes = List.copyOf(notes);
    }

    /// @param name of the model's file, without its ending; files of parts begin with it
    /// @throws InvalidSettings when the file is no URDF, or has nothing of which a body can be made
    public static UrdfModel read(String text, String file, String name) {
        return new Import(RobotDescription.read(text, file), file, name).model();
    }

    /// A wheel that the robot drives on.
    ///
    /// @param radius [m]; 0 when it is not known
    /// @param speed how fast it turns at most [rad/s]; empty when it is not known
    private record Wheel(Transform.Point rootFromCenter, double radius, OptionalDouble speed) {}

    /// A piece of the body as seen from above.
    private record Piece(Footprint outline, double bottom, double top) {}

    private static final class Import {
        private final RobotDescription robot;
        private final String file;
        private final String name;
        private final List<Problem> notes = new ArrayList<>();
        private final Map<String, String> parts = new LinkedHashMap<>();
        private final List<Wheel> wheels;
        private final Transform.Point origin; // of the base, in the root's frame

        Import(RobotDescription robot, String file, String name) {
            this.robot = robot;
            this.file = file;
            this.name = name;
            this.wheels = wheels();
            this.origin = origin();
        }

        UrdfModel model() {
            List<Piece> pieces = pieces();
            var text = new StringBuilder("# Made of %s. Lengths in m, angles in degrees. The base's origin is %s.%n"
                    .formatted(
                            Location.of(file).file().replaceFirst(".*/", ""),
                            wheels.isEmpty() ? "that of its first link" : "the middle between its wheels"));
            text.append("title: %s%n".formatted(quoted(robot.name().isEmpty() ? name : robot.name())));
            text.append("body:\n  pieces:\n");
            pieces.forEach(piece -> text.append("    - {outline: [%s], bottom: %s, height: %s}%n"
                    .formatted(
                            piece.outline.corners().stream()
                                    .map(corner -> "[%s, %s]".formatted(rounded(corner.x()), rounded(corner.y())))
                                    .collect(Collectors.joining(", ")),
                            rounded(piece.bottom),
                            rounded(Math.max(THIN, piece.top - piece.bottom)))));
            text.append(drive());
            text.append(mounts());
            return new UrdfModel(text.toString(), parts, notes);
        }

        private void note(XmlElement at, String message, String remedy) {
            notes.add(new Problem(at.location(), message, remedy));
        }

        // Wheels

        private List<Wheel> wheels() {
            var wheels = new ArrayList<Wheel>();
            robot.joints().forEach((link, joint) -> {
                String type = joint.attribute("type");
                Transform rootFromLink = robot.rootFromLink(link);
                double[] axis = joint.first("axis")
                        .map(reported -> reported.numbers("xyz", 1, 0, 0))
                        .orElse(new double[] {1, 0, 0});
                boolean turns = type.equals("continuous") && Math.abs(rootFromLink.upwards(axis)) < STANDS;
                if (turns && !CASTER.matcher(link + joint.attribute("name")).matches()) {
                    wheels.add(new Wheel(
                            rootFromLink.apply(0, 0, 0),
                            radius(link),
                            joint.first("limit")
                                    .filter(limit -> limit.attributes().containsKey("velocity"))
                                    .map(limit -> OptionalDouble.of(limit.numbers("velocity", 0)[0]))
                                    .orElse(OptionalDouble.empty())));
                }
            });
            return wheels;
        }

        private double radius(String link) {
            return shapes(link)
                    .flatMap(shape -> Stream.concat(
                            shape.first("geometry", "cylinder").stream(), shape.first("geometry", "sphere").stream()))
                    .mapToDouble(round -> round.numbers("radius", 0)[0])
                    .max()
                    .orElse(0);
        }

        private Transform.Point origin() {
            if (wheels.isEmpty()) {
                note(
                        robot.robot(),
                        "No joint is a wheel ('continuous', with a level axis): the base's origin is that of the first link.",
                        "Move 'body' and 'mounts' if the robot turns around another point.");
                return new Transform.Point(0, 0, 0);
            }
            return new Transform.Point(
                    wheels.stream()
                            .mapToDouble(wheel -> wheel.rootFromCenter.x())
                            .average()
                            .orElseThrow(),
                    wheels.stream()
                            .mapToDouble(wheel -> wheel.rootFromCenter.y())
                            .average()
                            .orElseThrow(),
                    wheels.stream()
                            .mapToDouble(wheel -> wheel.rootFromCenter.z() - wheel.radius)
                            .min()
                            .orElseThrow());
        }

        // Body

        /// Collision shapes of a link.
        private Stream<XmlElement> shapes(String link) {
            return robot.links().containsKey(link)
                    ? java.util.Objects.requireNonNull(robot.links().get(link)).all("collision")
                    : Stream.empty();
        }

        private List<Piece> pieces() {
            var pieces = new ArrayList<Piece>();
            robot.links()
                    .forEach((link, element) -> shapes(link)
                            .forEach(shape -> piece(
                                            shape, robot.rootFromLink(link).compose(Transform.of(shape)))
                                    .ifPresent(pieces::add)));
            if (pieces.isEmpty()) {
                throw new InvalidSettings(
                        robot.robot().location(),
                        "No link has a collision shape that is a box, a cylinder or a sphere.",
                        "Add one that is as large as the robot. Meshes can't be read.");
            }
            double floor =
                    Math.min(0, pieces.stream().mapToDouble(Piece::bottom).min().orElseThrow());
            return pieces.stream()
                    .map(piece -> new Piece(piece.outline, Math.max(0, piece.bottom - floor), piece.top - floor))
                    .toList();
        }

        private Optional<Piece> piece(XmlElement shape, Transform rootFromShape) {
            List<Transform.Point> corners = corners(shape);
            if (corners.isEmpty()) {
                return Optional.empty();
            }
            var flat = new ArrayList<Point2d>();
            double bottom = Double.POSITIVE_INFINITY;
            double top = Double.NEGATIVE_INFINITY;
            for (Transform.Point corner : corners) {
                Transform.Point placed = rootFromShape.apply(corner.x(), corner.y(), corner.z());
                flat.add(new Point2d(round(placed.x() - origin.x()), round(placed.y() - origin.y())));
                bottom = Math.min(bottom, placed.z() - origin.z());
                top = Math.max(top, placed.z() - origin.z());
            }
            try {
                return Optional.of(new Piece(Footprint.around(flat), bottom, top));
            } catch (IllegalArgumentException _) {
                note(shape, "This collision shape has no area, seen from above, and is skipped.", "");
                return Optional.empty();
            }
        }

        /// Points around which the shape lies; none of one that is left out.
        private List<Transform.Point> corners(XmlElement shape) {
            Optional<XmlElement> box = shape.first("geometry", "box");
            if (box.isPresent()) {
                double[] size = box.get().numbers("size", 0, 0, 0);
                var corners = new ArrayList<Transform.Point>();
                for (int i = 0; i < 8; i++) {
                    corners.add(new Transform.Point(
                            ((i & 1) - 0.5) * size[0], ((i >> 1 & 1) - 0.5) * size[1], ((i >> 2) - 0.5) * size[2]));
                }
                return corners;
            }
            Optional<XmlElement> cylinder = shape.first("geometry", "cylinder");
            if (cylinder.isPresent()) {
                double half = cylinder.get().numbers("length", 0)[0] / 2;
                return Stream.of(-half, half)
                        .flatMap(z -> circle(cylinder.get().numbers("radius", 0)[0], z))
                        .toList();
            }
            Optional<XmlElement> sphere = shape.first("geometry", "sphere");
            if (sphere.isPresent()) {
                double radius = sphere.get().numbers("radius", 0)[0];
                return Stream.concat(
                                circle(radius, 0),
                                Stream.of(new Transform.Point(0, 0, -radius), new Transform.Point(0, 0, radius)))
                        .toList();
            }
            note(shape, "This collision shape is not a box, cylinder or sphere, and is skipped.", "");
            return List.of();
        }

        private static Stream<Transform.Point> circle(double radius, double z) {
            return Stream.iterate(0, i -> i < CORNERS, i -> i + 1)
                    .map(i -> 2 * Math.PI * i / CORNERS)
                    .map(angle -> new Transform.Point(radius * Math.cos(angle), radius * Math.sin(angle), z));
        }

        // Drive

        private String drive() {
            double radius = wheels.stream().mapToDouble(Wheel::radius).max().orElse(0);
            double left = wheels.stream()
                    .mapToDouble(wheel -> wheel.rootFromCenter.y())
                    .max()
                    .orElse(0);
            double right = wheels.stream()
                    .mapToDouble(wheel -> wheel.rootFromCenter.y())
                    .min()
                    .orElse(0);
            OptionalDouble turning = wheels.stream()
                    .flatMapToDouble(wheel -> wheel.speed.stream())
                    .filter(speed -> speed > 0)
                    .min();
            double speed = USUAL_SPEED;
            double turnRate = USUAL_TURN_RATE;
            if (turning.isPresent() && radius > 0 && left > right) {
                speed = turning.getAsDouble() * radius;
                turnRate = Math.toDegrees(2 * speed / (left - right));
            } else {
                note(
                        robot.robot(),
                        "It does not say how fast the robot is: %s m/s and %s deg/s are written."
                                .formatted(rounded(USUAL_SPEED), rounded(USUAL_TURN_RATE)),
                        "Set 'drive.maxSpeed' and 'drive.maxTurnRate'.");
            }
            boolean sideways = robot.robot()
                    .all("gazebo")
                    .flatMap(gazebo -> gazebo.all("plugin"))
                    .map(plugin -> plugin.attribute("filename").toLowerCase(Locale.ROOT))
                    .anyMatch(plugin -> plugin.contains("planar_move") || plugin.contains("mecanum"));
            return """
                    drive: # accelerations and odometry's errors are guessed
                    %s  maxSpeed: %s
                      maxTurnRate: %s
                      maxAcceleration: %s
                    %s  maxTurnAcceleration: %s
                      odometryNoise: {distancePerMeter: 0.02, headingPerMeter: 1.0, headingPerDegree: 0.2}
                    """.formatted(
                            sideways ? "  type: omnidirectional\n  maxSideSpeed: %s\n".formatted(rounded(speed)) : "",
                            rounded(speed),
                            rounded(Math.min(turnRate, 1000)),
                            rounded(speed),
                            sideways ? "  maxSideAcceleration: %s\n".formatted(rounded(speed)) : "",
                            rounded(Math.min(2 * turnRate, 1000)));
        }

        // Devices

        private String mounts() {
            var mounts = new LinkedHashMap<String, String>();
            var sensors = new LinkedHashMap<String, String>();
            robot.robot()
                    .all("gazebo")
                    .forEach(gazebo -> gazebo.all("sensor").forEach(sensor -> {
                        String type = sensor.attribute("type").toLowerCase(Locale.ROOT);
                        if (type.contains("ray") || type.contains("lidar")) {
                            laser(gazebo.attribute("reference"), sensor, mounts, sensors);
                        }
                    }));
            for (String link : robot.links().keySet()) {
                if (LASER.matcher(link).matches() && !mounts.containsKey("laser")) {
                    mounts.put("laser", place(link, 0));
                    note(
                            java.util.Objects.requireNonNull(robot.links().get(link)),
                            "Link '%s' is taken for a laser, whose data sheet is not given.".formatted(link),
                            "Choose a part for it: 'sensors: {laser: urg04lx}'.");
                }
                if (CAMERA.matcher(link).matches() && !mounts.containsKey("camera")) {
                    mounts.put("camera", place(link, 0));
                    mounts.put("fiducials", place(link, 0));
                }
            }
            for (String device : List.of("battery", "light")) {
                mounts.putIfAbsent(device, "[0, 0, 0]");
            }
            return "mounts:\n"
                    + mounts.entrySet().stream()
                            .map(mount -> "  %s: %s%n".formatted(mount.getKey(), mount.getValue()))
                            .collect(Collectors.joining())
                    + (sensors.isEmpty()
                            ? ""
                            : sensors.entrySet().stream()
                                    .map(sensor -> sensor.getKey() + ": " + sensor.getValue())
                                    .collect(Collectors.joining(", ", "sensors: {", "}\n")));
        }

        private void laser(String link, XmlElement sensor, Map<String, String> mounts, Map<String, String> sensors) {
            Optional<XmlElement> ray = sensor.first("ray").or(() -> sensor.first("lidar"));
            Optional<XmlElement> level = ray.flatMap(reported -> reported.first("scan", "horizontal"));
            Optional<XmlElement> range = ray.flatMap(reported -> reported.first("range"));
            if (level.isEmpty() || range.isEmpty() || !robot.links().containsKey(link)) {
                note(sensor, "This laser has no 'scan', no 'range', or no link; it is skipped.", "");
                return;
            }
            String device = mounts.containsKey("laser") ? "laser-" + (sensors.size() + 1) : "laser";
            double least = number(level.get(), "min_angle", -Math.PI);
            double most = number(level.get(), "max_angle", Math.PI);
            double field = Math.min(360, Math.toDegrees(Math.abs(most - least)));
            double noise = ray.flatMap(reported -> reported.first("noise", "stddev"))
                    .map(XmlElement::number)
                    .orElse(0.01);
            double rate = sensor.first("update_rate").map(XmlElement::number).orElse(10.0);
            String part = "%s-%s.yaml".formatted(name, device);
            parts.put(part, """
                    # The laser of %s at link '%s'. Lengths in m, angles in degrees, times in s.
                    type: laser
                    fieldOfView: %s
                    samples: %d
                    range: [%s, %s]
                    noise: %s
                    period: %s
                    """.formatted(
                            name,
                            link,
                            rounded(field),
                            Math.max(1, Math.round(number(level.get(), "samples", 360))),
                            rounded(Math.max(THIN, number(range.get(), "min", 0.1))),
                            rounded(number(range.get(), "max", 10)),
                            rounded(Math.max(0, noise)),
                            rounded(rate > 0 ? 1 / rate : 0.1)));
            mounts.put(device, place(link, (least + most) / 2));
            sensors.put(device, part);
        }

        private static double number(XmlElement of, String child, double fallback) {
            return of.first(child).map(XmlElement::number).orElse(fallback);
        }

        /// `[x, y, heading, height]` in the base's frame.
        ///
        /// @param turned from the link's x axis [rad]
        private String place(String link, double turned) {
            Transform rootFromLink = robot.rootFromLink(link);
            return "[%s, %s, %s, %s]"
                    .formatted(
                            rounded(rootFromLink.x() - origin.x()),
                            rounded(rootFromLink.y() - origin.y()),
                            rounded(Math.toDegrees(rootFromLink.heading() + turned)),
                            rounded(Math.max(0, rootFromLink.z() - origin.z())));
        }
    }

    private static String quoted(String text) {
        return "\"" + text.replace("\\", "\\\\").replace("\"", "\\\"").replaceAll("\\p{Cntrl}", " ") + "\"";
    }

    private static double round(double value) {
        return new BigDecimal(value).setScale(4, RoundingMode.HALF_EVEN).doubleValue();
    }

    /// In tenths of a millimeter or of a thousandth of a degree, as YAML writes numbers.
    private static String rounded(double value) {
        String plain = new BigDecimal(value)
                .setScale(4, RoundingMode.HALF_EVEN)
                .stripTrailingZeros()
                .toPlainString();
        return plain.equals("-0") ? "0" : plain;
    }
}
