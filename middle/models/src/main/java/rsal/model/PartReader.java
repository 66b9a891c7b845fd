package rsal.model;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import rsal.data.ActuatorState.Joint;
import rsal.data.Interval;
import rsal.data.LightState.Signal;
import rsal.data.Pose2d;
import rsal.device.Canvas;
import rsal.device.Docking;
import rsal.device.Localizer;
import rsal.device.Mapper;
import rsal.device.Navigator;
import rsal.device.Planner;
import rsal.robot.DeviceKind;
import rsal.robot.DeviceKinds;
import rsal.robot.RobotModel.Part;
import rsal.robot.RobotModel.RangeNoise;
import rsal.settings.Arguments;
import rsal.settings.ColorNames;
import rsal.settings.Parameter;
import rsal.settings.Section;
import rsal.settings.Suggestion;
import rsal.settings.Value;

/// Reads part files. What is wrong is noted, and something harmless taken for it.
final class PartReader {
    private static final List<String> TYPES = List.of(
            "laser",
            "sonars",
            "blob-finder",
            "fiducial-finder",
            "gripper",
            "bumper",
            "actuator",
            "battery",
            "light",
            "localizer",
            "navigator",
            "planner",
            "map",
            "canvas");
    private static final int MAX_SAMPLES = 10_000;
    private static final int MAX_SENSORS = 1_000;
    private static final double MAX_ENERGY = 1e15; // [J], [W]; batteries of Stage's worlds are no larger

    /// All types that part files can have: those that are read here, and registered kinds of devices.
    static List<String> types() {
        return Stream.concat(TYPES.stream(), DeviceKinds.all().stream().map(DeviceKind::key))
                .toList();
    }

    private final String name;
    private final Pose2d mount;
    private final Section part;

    private PartReader(String name, Pose2d mount, Section part) {
        this.name = name;
        this.mount = mount;
        this.part = part;
    }

    static Part read(String name, Pose2d mount, Section section) {
        var reader = new PartReader(name, mount, section);
        String type = section.text("type");
        Optional<Part> part = switch (type) {
            case "laser" -> Optional.of(reader.laser());
            case "sonars" -> Optional.of(reader.sonars());
            case "blob-finder" -> Optional.of(reader.blobFinder());
            case "fiducial-finder" -> Optional.of(reader.fiducialFinder());
            case "gripper" -> Optional.of(reader.gripper());
            case "bumper" -> Optional.of(reader.bumper());
            case "actuator" -> Optional.of(reader.actuator());
            case "battery" -> Optional.of(reader.battery());
            case "light" -> Optional.of(reader.light());
            case "localizer" -> Optional.of(new Part.Own(name, Localizer.class));
            case "navigator" -> Optional.of(new Part.Own(name, Navigator.class));
            case "planner" -> Optional.of(new Part.Own(name, Planner.class));
            case "docking" -> Optional.of(new Part.Own(name, Docking.class));
            case "map" -> Optional.of(new Part.Own(name, Mapper.class));
            case "canvas" -> Optional.of(new Part.Own(name, Canvas.class));
            default -> DeviceKinds.find(type).map(reader::registered);
        };
        if (part.isEmpty()) {
            if (!type.isEmpty()) {
                section.problem(
                        "type", "There is no type of part '%s'.".formatted(type), Suggestion.among(type, types()));
            }
            return new Part.Bumper(name, List.of(), Duration.ofSeconds(1));
        }
        section.done();
        return part.get();
    }

    private Part registered(DeviceKind kind) {
        Duration period = period();
        Arguments arguments = part.arguments(kind.parameters())
                .filter(values -> isPossible(kind, values))
                .orElseGet(() -> Arguments.of(List.of(), Map.of())); // told; nobody makes a device of it
        return new Part.Registered(name, kind, mount, arguments, period);
    }

    private boolean isPossible(DeviceKind kind, Arguments values) {
        Optional<String> refusal = kind.refusal(values);
        refusal.ifPresent(why -> part.problem(part.location(), why, ""));
        return refusal.isEmpty();
    }

    private Part laser() {
        double fieldOfView = fieldOfView();
        Interval range = range();
        int samples = NumberReader.whole(part, "samples", 2, MAX_SAMPLES);
        return new Part.Laser(
                name,
                mount,
                -fieldOfView / 2,
                fieldOfView / (samples - 1),
                samples,
                range.least(),
                range.most(),
                new RangeNoise(
                        NumberReader.notNegative(part, "noise"),
                        relativeNoise(),
                        part.has("angularNoise")
                                ? Math.toRadians(NumberReader.checked(part, "angularNoise", 0, 180))
                                : 0),
                period());
    }

    private Part sonars() {
        Interval range = range();
        return new Part.Sonars(
                name,
                rows("sensors", "[x, y, heading]", 3, 1).stream()
                        .map(this::pose)
                        .toList(),
                fieldOfView(),
                range.least(),
                range.most(),
                new RangeNoise(NumberReader.notNegative(part, "noise"), relativeNoise(), 0),
                period());
    }

    private double relativeNoise() {
        return part.has("relativeNoise") ? NumberReader.checked(part, "relativeNoise", 0, 1) : 0;
    }

    private Part blobFinder() {
        double[] image = part.numbers("image", 2).orElse(new double[2]);
        for (double side : image) {
            if (!(side >= 1 && side <= MAX_SAMPLES && side == Math.rint(side))) {
                part.problem(
                        "image",
                        "'image' must be its columns and rows, such as [80, 60], each from 1 to %d."
                                .formatted(MAX_SAMPLES),
                        "");
                break;
            }
        }
        return new Part.BlobFinder(
                name,
                mount,
                (int) image[0],
                (int) image[1],
                fieldOfView(),
                NumberReader.positive(part, "range"),
                ColorNames.list(part, "colors"),
                period());
    }

    private Part fiducialFinder() {
        double range = NumberReader.positive(part, "range");
        return new Part.FiducialFinder(
                name,
                mount,
                fieldOfView(),
                range,
                NumberReader.checked(part, "idRange", 0, range),
                part.has("key") ? NumberReader.whole(part, "key", 0, Integer.MAX_VALUE) : 0,
                flag("allHeights"),
                period());
    }

    private Part gripper() {
        double length = NumberReader.positive(part, "length");
        double width = NumberReader.positive(part, "width");
        if (flag("raised") && !part.has("liftingTime")) {
            part.problem("raised", "'raised' is true, but it has no lift.", "Give it a 'liftingTime'.");
        }
        return new Part.Gripper(
                name,
                mount,
                length,
                width,
                NumberReader.positive(part, "height"),
                NumberReader.checked(part, "paddleLength", length / 100, length),
                NumberReader.checked(part, "paddleWidth", width / 100, width / 3),
                seconds("closingTime"),
                part.has("liftingTime") ? seconds("liftingTime") : Duration.ZERO,
                flag("closed"),
                flag("raised"),
                flag("snatches"),
                period());
    }

    private Part bumper() {
        var pads = new ArrayList<Part.Bumper.Pad>();
        for (double[] row : rows("bumpers", "[x, y, heading, length]", 4, 0)) {
            if (!(row[3] > 0 && row[3] <= NumberReader.MOST)) {
                part.problem("bumpers", "A bumper's length must be positive, not '%s'.".formatted(row[3]), "");
            }
            pads.add(new Part.Bumper.Pad(pose(row), row[3]));
        }
        return new Part.Bumper(name, pads, period());
    }

    private Part actuator() {
        String joint = part.text("joint");
        if (!joint.isEmpty() && !joint.equals("linear") && !joint.equals("rotational")) {
            part.problem(
                    "joint",
                    "'joint' must be linear or rotational, not '%s'.".formatted(joint),
                    Suggestion.among(joint, List.of("linear", "rotational")));
        }
        boolean turns = joint.equals("rotational");
        double unit = turns ? Math.toRadians(1) : 1;
        Interval limits = interval("limits", -NumberReader.MOST);
        double home = NumberReader.checked(part, "home", limits.least(), limits.most());
        return new Part.Actuator(
                name,
                mount,
                turns ? Joint.ROTATIONAL : Joint.LINEAR,
                part.has("slope") ? slope(turns) : 0,
                new Interval(limits.least() * unit, limits.most() * unit),
                NumberReader.positive(part, "maxSpeed") * unit,
                home * unit,
                period());
    }

    private double slope(boolean turns) {
        if (turns) {
            part.problem("slope", "'slope' is for linear joints; a rotational one turns around what points up.", "");
        }
        return Math.toRadians(NumberReader.checked(part, "slope", -90, 90));
    }

    private Part battery() {
        double capacity = NumberReader.checked(part, "capacity", NumberReader.LEAST, MAX_ENERGY);
        return new Part.Battery(
                name,
                capacity,
                part.has("charge") ? NumberReader.checked(part, "charge", 0, capacity) : capacity,
                energy("idlePower"),
                energy("energyPerMeter"),
                Math.toDegrees(energy("energyPerDegree")),
                energy("chargingPower"),
                part.has("givingPower") ? energy("givingPower") : 0,
                period());
    }

    private double energy(String key) {
        return NumberReader.checked(part, key, 0, MAX_ENERGY);
    }

    private Part light() {
        return new Part.Light(
                name,
                mount,
                BodyReader.color(part, "color"),
                new Signal(seconds("flashPeriod"), NumberReader.checked(part, "dutyCycle", 0, 1)),
                period());
    }

    /// False when it is not told.
    private boolean flag(String key) {
        return part.has(key)
                && part.value(Parameter.flag(key, false, ""))
                        .filter(Boolean.TRUE::equals)
                        .isPresent();
    }

    private double fieldOfView() {
        return Math.toRadians(NumberReader.checked(part, "fieldOfView", 1e-3, 360));
    }

    private Interval range() {
        return interval("range", 0);
    }

    private Interval interval(String key, double least) {
        double[] ends = part.numbers(key, 2).orElse(new double[] {0, 0});
        if (ends[0] >= least && ends[1] > ends[0] && ends[1] <= 1e6) {
            return new Interval(ends[0], ends[1]);
        }
        part.problem(key, "'%s' must be [least, most], not [%s, %s].".formatted(key, ends[0], ends[1]), "");
        return new Interval(0, 1);
    }

    private Duration period() {
        return seconds("period");
    }

    private Duration seconds(String key) {
        return Duration.ofNanos(Math.round(NumberReader.positive(part, key) * 1e9));
    }

    /// A list of lists of so many numbers.
    /// @param count of the numbers of each
    /// @param least how many there must be
    private List<double[]> rows(String key, String what, int count, int least) {
        Optional<List<Value>> listed = part.list(key);
        List<Value> items = listed.orElse(List.of());
        if (!part.has(key)) {
            part.problem(
                    key, "'%s' is missing: a list of %s.".formatted(key, what), least == 0 ? "[] is for none." : "");
        } else if (listed.isPresent() && (items.size() < least || items.size() > MAX_SENSORS)) {
            part.problem(
                    key,
                    "'%s' must list %d to %d of %s, not %d.".formatted(key, least, MAX_SENSORS, what, items.size()),
                    "");
        }
        return items.stream()
                .flatMap(item -> part.numbers(key, item, count).stream())
                .toList();
    }

    private Pose2d pose(double[] row) {
        return mount.compose(Pose2d.ofDegrees(row[0], row[1], row[2]));
    }
}
