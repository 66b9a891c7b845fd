package rsal.stage;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import rsal.data.Twist2d;
import rsal.settings.Location;
import rsal.stage.ModelKind.Drive;
import rsal.stage.ModelKind.Limits;
import rsal.stage.ModelKind.Localization;
import rsal.stage.ModelKind.OdometryError;
import rsal.stage.ModelKind.RangeNoise;
import rsal.stage.ModelKind.Strip;
import rsal.stage.ModelKind.Transducer;

/// Reads the properties that only one type of model has, with Stage's defaults.
final class KindReader {
    private static final int MOST_SAMPLES = 100_000;
    private static final int MOST_PIXELS = 10_000; // of a side
    private static final int MOST_STRIPS = 1000;
    private static final ValueRange SPEED = new ValueRange(-1, 1); // [m/s]
    private static final ValueRange TURN = new ValueRange(-Math.PI / 2, Math.PI / 2); // [rad/s]
    private static final Size TRANSDUCER = new Size(0.02, 0.02, 0.02);

    private final Paint paint;
    private final Units units;
    private final WorldProblems findings;

    KindReader(Paint paint, Units units, WorldProblems findings) {
        this.paint = paint;
        this.units = units;
        this.findings = findings;
    }

    /// @param fields of an entity of one of [Types#MODELS]
    ModelKind read(EntityFields fields, Size size) {
        return switch (fields.entity().type()) {
            case "position" -> position(fields);
            case "ranger" -> ranger(fields);
            case "blobfinder" -> blobfinder(fields);
            case "fiducial" -> fiducial(fields);
            case "gripper" -> gripper(fields, size);
            case "bumper" -> bumper(fields);
            case "actuator" -> actuator(fields);
            case "camera" -> camera(fields);
            case "blinkenlight" -> blinkenlight(fields);
            case "lightindicator" -> new ModelKind.LightIndicator();
            default -> new ModelKind.Thing();
        };
    }

    private static ModelKind position(EntityFields fields) {
        Drive drive = switch (fields.choice("drive", "diff", List.of("diff", "omni", "car"))) {
            case "omni" -> Drive.OMNIDIRECTIONAL;
            case "car" -> Drive.CAR;
            default -> Drive.DIFFERENTIAL;
        };
        boolean odometry =
                fields.choice("localization", "gps", List.of("gps", "odom")).equals("odom");
        double wheelbase = fields.positive("wheelbase", Units.Kind.LENGTH, 1);
        Twist2d velocity = fields.tuple("velocity", Form.VELOCITY)
                .map(v -> new Twist2d(v[0], v[1], v[3]))
                .orElse(Twist2d.STOP);
        return new ModelKind.Position(
                drive,
                wheelbase,
                velocity,
                limits(fields, "velocity_bounds", Form.SPEEDS),
                limits(fields, "acceleration_bounds", Form.ACCELERATIONS),
                odometry ? Localization.ODOMETRY : Localization.GPS,
                fields.pose("localization_origin"),
                fields.tuple("odom_error", Form.ODOMETRY_ERROR).map(e -> new OdometryError(e[0], e[1], e[2], e[3])));
    }

    private static Limits limits(EntityFields fields, String name, Form form) {
        double[] b = fields.tuple(name, form).orElse(null);
        return b == null
                ? new Limits(SPEED, SPEED, SPEED, TURN)
                : new Limits(
                        fields.interval(name, b[0], b[1], Units.Kind.LENGTH).orElse(SPEED),
                        fields.interval(name, b[2], b[3], Units.Kind.LENGTH).orElse(SPEED),
                        fields.interval(name, b[4], b[5], Units.Kind.LENGTH).orElse(SPEED),
                        fields.interval(name, b[6], b[7], Units.Kind.ANGLE).orElse(TURN));
    }

    private ModelKind ranger(EntityFields fields) {
        var transducers = new ArrayList<Transducer>();
        for (WorldfileEntity child : fields.entity().children()) {
            if (child.type().equals(Types.SENSOR)) {
                transducers.add(transducer(new EntityFields(child, "a sensor", units, findings)));
            }
        }
        return new ModelKind.Ranger(transducers);
    }

    private Transducer transducer(EntityFields fields) {
        ValueRange range = fields.interval("range", new ValueRange(0, 5));
        if (range.min() < 0) {
            fields.problem(
                    "range",
                    "'range' must not begin below 0, not at '%s'."
                            .formatted(units.written(Units.Kind.LENGTH, range.min())),
                    "Maybe [0 %s]?".formatted(units.written(Units.Kind.LENGTH, Math.abs(range.max()))));
        }
        RangeNoise noise = noise(fields);
        var transducer = new Transducer(
                fields.pose("pose").orElse(Placement.ORIGIN),
                fields.size(TRANSDUCER),
                range,
                fields.turn("fov", 0.1),
                fields.integer("samples", 1, 1, MOST_SAMPLES),
                noise);
        paint.color(fields, StageColor.BLUE); // drawing only; a wrong name is told all the same
        fields.done();
        return transducer;
    }

    private RangeNoise noise(EntityFields fields) {
        double[] noise = fields.tuple("noise", Form.NOISE).orElseGet(() -> new double[3]);
        if (noise[0] < 0) {
            fields.problem(
                    "noise",
                    "The first value of 'noise' is a variance and must not be negative, not '%s'."
                            .formatted(units.written(Units.Kind.LENGTH, noise[0])),
                    "Maybe it was meant to be '%s'?".formatted(units.written(Units.Kind.LENGTH, -noise[0])));
        }
        return new RangeNoise(noise[0], noise[1], noise[2]);
    }

    private ModelKind blobfinder(EntityFields fields) {
        List<String> names = fields.texts("colors");
        int count = fields.integer("colors_count", names.size(), 0, 1_000_000);
        if (count > names.size()) {
            fields.problem(
                    "colors_count",
                    "'colors_count' is %d, but 'colors' names %d.".formatted(count, names.size()),
                    "Maybe 'colors_count %d'?".formatted(names.size()));
            count = names.size();
        }
        var colors = new ArrayList<StageColor>();
        for (String name : names.subList(0, count)) {
            paint.named(name, fields.locationOf("colors")).ifPresent(colors::add);
        }
        int[] image = image(fields, "image", 80, 60);
        return new ModelKind.Blobfinder(
                colors,
                image[0],
                image[1],
                fields.notNegative("range", Units.Kind.NUMBER, 12),
                fields.turn("fov", Math.toRadians(60)),
                fields.angle("pan", 0));
    }

    private static int[] image(EntityFields fields, String name, int columns, int rows) {
        return fields.tuple(name, Form.image(MOST_PIXELS, columns, rows))
                .map(image -> new int[] {(int) image[0], (int) image[1]})
                .orElseGet(() -> new int[] {columns, rows});
    }

    private static ModelKind fiducial(EntityFields fields) {
        double min = fields.notNegative("range_min", Units.Kind.LENGTH, 0);
        double max = fields.notNegative("range_max", Units.Kind.LENGTH, 8);
        return new ModelKind.Fiducial(
                fields.interval("range_min", min, max, Units.Kind.LENGTH).orElse(new ValueRange(0, max)),
                fields.notNegative("range_max_id", Units.Kind.LENGTH, 5),
                fields.turn("fov", Math.PI),
                fields.integer("fiducial_key", 0, Integer.MIN_VALUE, Integer.MAX_VALUE),
                fields.flag("ignore_zloc", false));
    }

    private static ModelKind gripper(EntityFields fields, Size size) {
        double[] part = fields.tuple("paddle_size", Form.PADDLES).orElseGet(() -> new double[] {0.66, 0.1, 0.4});
        List<String> state = fields.texts("paddle_state");
        boolean closed = word(fields, state, 0, "open", "closed");
        boolean up = word(fields, state, 1, "down", "up");
        var paddle = new Size(part[0] * size.x(), part[1] * size.y(), part[2] * size.z());
        return new ModelKind.Gripper(paddle, closed, up, fields.flag("autosnatch", false));
    }

    /// Whether a word of the paddles' state is the second of two.
    private static boolean word(EntityFields fields, List<String> state, int index, String no, String yes) {
        String word = index < state.size() ? state.get(index) : no;
        if (!word.equals(no) && !word.equals(yes)) {
            fields.problem(
                    "paddle_state",
                    "'paddle_state' has '%s' where '%s' or '%s' was expected."
                            .formatted(WorldProblems.shortened(word), no, yes),
                    "Write [\"open\" \"down\"] or the like.");
        }
        return word.equals(yes);
    }

    private static ModelKind bumper(EntityFields fields) {
        int count = fields.integer("bcount", 0, 0, MOST_STRIPS);
        if (count == 0 && fields.entity().find("bcount").isEmpty()) {
            fields.findings()
                    .warn(
                            fields.entity().location(),
                            "This bumper feels nothing: it has no 'bcount'.",
                            "Write bcount N, then bpose[0] [X Y Z A], blength[0] LENGTH and so on to the last, N - 1.");
        }
        double length = fields.notNegative("blength", Units.Kind.LENGTH, 0.1);
        var strips = new ArrayList<Strip>();
        for (int i = 0; i < count; i++) {
            Placement pose = fields.pose("bpose[%d]".formatted(i)).orElse(Placement.ORIGIN);
            strips.add(new Strip(pose, fields.notNegative("blength[%d]".formatted(i), Units.Kind.LENGTH, length)));
        }
        return new ModelKind.Bumper(strips);
    }

    private static ModelKind actuator(EntityFields fields) {
        boolean turning =
                fields.choice("type", "linear", List.of("linear", "rotational")).equals("rotational");
        Units.Kind kind = turning ? Units.Kind.ANGLE : Units.Kind.LENGTH;
        double[] axis = fields.tuple("axis", Form.AXIS).orElseGet(() -> new double[] {1, 0, 0});
        double norm = Math.sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]);
        if (!(norm > 0)) {
            fields.problem("axis", "'axis' must not be [0 0 0].", "Write [1 0 0] for forward, [0 0 1] for up.");
            norm = 1;
        }
        double min = fields.scaled("min_position", kind, 0);
        double max = fields.scaled("max_position", kind, 1);
        return new ModelKind.Actuator(
                turning,
                axis[0] / norm,
                axis[1] / norm,
                axis[2] / norm,
                fields.interval("min_position", min, max, kind).orElse(new ValueRange(0, 1)),
                fields.notNegative("max_speed", kind, 1),
                fields.scaled("start_position", kind, 0));
    }

    private static ModelKind camera(EntityFields fields) {
        fields.findings()
                .warn(
                        fields.entity().location(),
                        "A camera gives no images here.",
                        "A blobfinder sees colors, a fiducial markers.");
        int[] image = image(fields, "resolution", 32, 32);
        ValueRange range = fields.interval("range", new ValueRange(0.2, 8));
        double[] fov =
                fields.tuple("fov", Form.VIEW).orElseGet(() -> new double[] {Math.toRadians(70), Math.toRadians(40)});
        double[] pantilt = fields.tuple("pantilt", Form.PAN_AND_TILT).orElseGet(() -> new double[2]);
        return new ModelKind.Camera(image[0], image[1], range, fov[0], fov[1], pantilt[0], pantilt[1]);
    }

    private static ModelKind blinkenlight(EntityFields fields) {
        double duty = fields.within(new ValueRange(0, 1), "dutycycle", Units.Kind.NUMBER, 1);
        return new ModelKind.Blinkenlight(fields.milliseconds("period", 1000), duty, fields.flag("enabled", true));
    }

    /// Colors as worlds write them.
    interface Paint {
        /// The color of an entity; empty when it is drawn at random.
        Optional<StageColor> color(EntityFields fields, StageColor fallback);

        Optional<StageColor> named(String name, Location at);
    }
}
