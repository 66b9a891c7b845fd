package rsal.stage;

import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import rsal.data.Point2d;
import rsal.image.Bitmap;
import rsal.image.BitmapReader;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;
import rsal.stage.BodyBuilder.Block;
import rsal.stage.Traits.Controller;
import rsal.stage.Traits.Energy;
import rsal.stage.Traits.Returns;

/// Reads what models of one make have in common, with Stage's defaults.
final class TraitsReader implements KindReader.Paint {
    static final int MAX_IMAGE_BYTES = 1 << 28;
    static final int MAX_POINTS = 4_000_000; // of all blocks, in bodies

    private static final int MOST_CORNERS = 10_000; // of a block
    private static final long MAX_PIXELS = 1L << 28; // of all images

    /// Without effect on what moves and senses: how Stage draws, what it tells, and what it only stores.
    private static final Set<String> FOR_VIEWERS = Set.of(
            "gui_nose",
            "gui_grid",
            "gui_outline",
            "gui_move",
            "say",
            "trail_length",
            "trail_interval",
            "event_queue",
            "debug",
            "map_resolution",
            "friction");

    private static final Map<String, Size> SIZES = Map.of(
            "ranger", new Size(0.15, 0.15, 0.2),
            "gripper", new Size(0.2, 0.3, 0.2),
            "fiducial", Size.NONE,
            "camera", new Size(0.1, 0.07, 0.05),
            "blinkenlight", new Size(0.02, 0.02, 0.02));
    private static final Size USUAL = new Size(0.4, 0.4, 1);
    private static final Set<String> BODILESS = Set.of("ranger", "blobfinder", "fiducial", "bumper");

    private static final Map<String, StageColor> COLORS =
            Map.of("gripper", new StageColor(190, 190, 190, 255), "blinkenlight", StageColor.GREEN);

    private final String world;
    private final WorldFiles files;
    private final Units units;
    private final WorldProblems findings;
    private final KindReader kinds;
    private final Map<String, Optional<Bitmap>> bitmaps = new HashMap<>(); // by path
    private long pixels;
    private int points;

    TraitsReader(String world, WorldFiles files, Units units, WorldProblems findings) {
        this.world = world;
        this.files = files;
        this.units = units;
        this.findings = findings;
        this.kinds = new KindReader(this, units, findings);
    }

    /// @param entity of one of [Types#MODELS]
    Traits read(WorldfileEntity entity) {
        String type = entity.type();
        var fields = new EntityFields(entity, article(type) + type, units, findings);
        fields.ignore(FOR_VIEWERS);
        fields.text("name");
        fields.pose("pose");
        Size size = fields.size(SIZES.getOrDefault(type, USUAL));
        Placement origin = fields.pose("origin").orElse(Placement.ORIGIN);
        ModelKind kind = kinds.read(fields, size);
        var traits = new Traits(
                kind,
                size,
                origin,
                body(fields, kind, size, origin),
                color(fields, COLORS.getOrDefault(type, StageColor.RED)),
                returns(fields),
                energy(fields, kind),
                fields.notNegative("mass", Units.Kind.NUMBER, 0),
                fields.flag("stack_children", true),
                fields.flag("alwayson", false),
                interval(fields),
                controllers(fields, kind));
        boolean device = !(type.equals("model") || type.equals("position"));
        if (!device && traits.body().isEmpty() && fields.has("size")) {
            warnOfNothing(fields.locationOf("size"), size);
        }
        fields.done();
        return traits;
    }

    private void warnOfNothing(Location at, Size size) {
        if (size.x() == 0 || size.y() == 0) {
            findings.warn(
                    at,
                    "What has this 'size' has no body: nothing runs into it or sees it.",
                    "Give it a length and a width, as [%s %s %s]."
                            .formatted(
                                    units.written(Units.Kind.LENGTH, 0.4),
                                    units.written(Units.Kind.LENGTH, 0.4),
                                    units.written(Units.Kind.LENGTH, 1)));
        }
    }

    private static String article(String type) {
        return "aeiou".indexOf(type.charAt(0)) >= 0 ? "an " : "a ";
    }

    private static Duration interval(EntityFields fields) {
        return fields.milliseconds("update_interval", 100);
    }

    private static Returns returns(EntityFields fields) {
        return new Returns(
                fields.flag("obstacle_return", true),
                fields.number("ranger_return", 1),
                fields.flag("blob_return", true),
                fields.integer("fiducial_return", 0, Integer.MIN_VALUE, Integer.MAX_VALUE),
                fields.integer("fiducial_key", 0, Integer.MIN_VALUE, Integer.MAX_VALUE),
                fields.flag("gripper_return", false));
    }

    private static Energy energy(EntityFields fields, ModelKind kind) {
        double usual = switch (kind) {
            case ModelKind.Ranger ranger -> 0.2 * ranger.transducers().size();
            case ModelKind.Blobfinder _ -> 2;
            default -> 0;
        };
        OptionalDouble stored = joules(fields, "joules", "kjoules");
        OptionalDouble capacity = joules(fields, "joules_capacity", "kjoules_capacity");
        if (stored.isEmpty() && capacity.isPresent()) {
            stored = OptionalDouble.of(0);
        }
        if (stored.isPresent() && stored.getAsDouble() < 0) {
            stored = OptionalDouble.of(Double.POSITIVE_INFINITY);
        }
        if (capacity.isEmpty() || (stored.isPresent() && Double.isInfinite(stored.getAsDouble()))) {
            capacity = stored;
        }
        return new Energy(
                stored,
                capacity,
                fields.notNegative("watts", Units.Kind.NUMBER, usual),
                fields.notNegative("give_watts", Units.Kind.NUMBER, 0),
                fields.notNegative("take_watts", Units.Kind.NUMBER, 0));
    }

    private static OptionalDouble joules(EntityFields fields, String plain, String thousands) {
        if (fields.has(thousands)) {
            fields.has(plain);
            return OptionalDouble.of(1000 * fields.number(thousands, 0));
        }
        return fields.has(plain) ? OptionalDouble.of(fields.number(plain, 0)) : OptionalDouble.empty();
    }

    private List<Controller> controllers(EntityFields fields, ModelKind kind) {
        var controllers = new ArrayList<Controller>();
        for (String text : fields.texts("ctrl")) {
            String[] parts = text.strip().split("\\s+", 2);
            if (!parts[0].isEmpty()) {
                controllers.add(new Controller(parts[0], parts.length > 1 ? parts[1] : ""));
                if (kind instanceof ModelKind.Position && parts[0].equals("wander") && hasRanger(fields.entity())) {
                    continue; // there is a behavior that does the same
                }
                findings.warn(
                        fields.locationOf("ctrl"),
                        parts[0].equals("wander")
                                ? "Controller 'wander' is for robots that have a ranger."
                                : "Controller '%s' is a program for Stage and can't be loaded here."
                                        .formatted(WorldProblems.shortened(parts[0])),
                        kind instanceof ModelKind.Position ? instead(fields.entity()) : "");
            }
        }
        return controllers;
    }

    private static String instead(WorldfileEntity robot) {
        return hasRanger(robot)
                ? "The robot wanders instead. Give it a behavior or an agent in a scenario."
                : "The robot stands still: it has no ranger to wander by. Give it one, or an agent in a scenario.";
    }

    private static boolean hasRanger(WorldfileEntity entity) {
        return entity.type().equals("ranger") || entity.children().stream().anyMatch(TraitsReader::hasRanger);
    }

    private SolidBody body(EntityFields fields, ModelKind kind, Size size, Placement origin) {
        var builder = new BodyBuilder(size, origin);
        List<Block> blocks = blocks(fields.entity());
        boolean boundary = fields.flag("boundary", false);
        boolean none = fields.flag("noblocks", false);
        Optional<String> file = fields.text("bitmap").filter(name -> !name.isEmpty());
        if (fields.has("bitmap") && file.isEmpty()) {
            findings.warn(
                    fields.locationOf("bitmap"),
                    "'bitmap' names no file and has no effect.",
                    "Name an image, or remove it.");
        }
        file.flatMap(name -> bitmap(name, fields.locationOf("bitmap"))).ifPresent(builder::bitmap);
        if (!blocks.isEmpty()) {
            builder.blocks(blocks);
        }
        if (boundary) {
            builder.boundary();
        }
        boolean usual = file.isEmpty() && blocks.isEmpty() && !boundary && !none;
        if (usual && kind instanceof ModelKind.Gripper gripper) {
            double x = size.x() / 2;
            builder.box(-x, x - gripper.paddle().x(), -size.y() / 2, size.y() / 2, size.z());
        } else if (usual && !BODILESS.contains(fields.entity().type())) {
            builder.box();
        }
        return builder.build();
    }

    private List<Block> blocks(WorldfileEntity entity) {
        var blocks = new ArrayList<Block>();
        for (WorldfileEntity child : entity.children()) {
            if (child.type().equals(Types.BLOCK)) {
                block(new EntityFields(child, "a block", units, findings)).ifPresent(blocks::add);
            }
        }
        return blocks;
    }

    private Optional<Block> block(EntityFields fields) {
        int count = fields.whole("points", 2, MOST_CORNERS).orElse(0);
        if (!fields.has("points")) {
            fields.problem("points", "A block must say how many 'points' it has.", howMany(fields));
        }
        points += count;
        if (points > MAX_POINTS) {
            throw findings.fatal(
                    fields.entity().location(),
                    "The world's blocks have more than %d points.".formatted(MAX_POINTS),
                    "Use fewer or simpler blocks.");
        }
        var corners = new ArrayList<Point2d>();
        for (int i = 0; i < count; i++) {
            String name = "point[%d]".formatted(i);
            if (!fields.has(name)) {
                fields.problem(
                        "points",
                        "The block has no '%s', though 'points' is %d.".formatted(name, count),
                        fields.has("point[%d]".formatted(i + 1))
                                ? "Write '%s [X Y]'; they are counted from 0 on, without a gap.".formatted(name)
                                : howMany(fields));
                break;
            }
            fields.tuple(name, Form.POINT).ifPresent(p -> corners.add(new Point2d(p[0], p[1])));
        }
        ValueRange heights = fields.interval("z", new ValueRange(0, 1));
        Optional<StageColor> color =
                fields.has("color") || fields.has("color_rgba") ? color(fields, StageColor.RED) : Optional.empty();
        fields.done();
        return corners.size() < 2 ? Optional.empty() : Optional.of(new Block(corners, heights, color));
    }

    /// What `points` of a block may have been meant to be.
    private static String howMany(EntityFields block) {
        int given = 0;
        while (given < MOST_CORNERS && block.has("point[%d]".formatted(given))) {
            given++;
        }
        return given < 2
                ? "Write points N, then point[0] [X Y] and so on to the last, N - 1."
                : "Maybe 'points %d', as there are point[0] to point[%d]?".formatted(given, given - 1);
    }

    private Optional<Bitmap> bitmap(String name, Location at) {
        WorldFiles.Found found;
        try {
            found = files.find(name, world, MAX_IMAGE_BYTES, at);
        } catch (InvalidSettings e) {
            findings.error(
                    at,
                    e.problems().getFirst().message(),
                    e.problems().getFirst().remedy());
            return Optional.empty();
        }
        return bitmaps.computeIfAbsent(found.path(), path -> decode(path, found.bytes(), at));
    }

    private Optional<Bitmap> decode(String path, byte[] bytes, Location at) {
        try {
            Bitmap bitmap = BitmapReader.read(bytes);
            pixels += (long) bitmap.width() * bitmap.height();
            if (pixels > MAX_PIXELS) {
                throw findings.fatal(
                        at, "The world's images have more than %d pixels.".formatted(MAX_PIXELS), "Use smaller ones.");
            }
            if (bitmap.solid().isEmpty()) {
                findings.warn(at, "Image '%s' has no dark pixel, so nothing of it is solid.".formatted(path), "");
            }
            return Optional.of(bitmap);
        } catch (BitmapReader.Unreadable e) {
            findings.error(at, "Image '%s' can't be read: %s.".formatted(path, e.why()), e.remedy());
            return Optional.empty();
        }
    }

    @Override
    public Optional<StageColor> color(EntityFields fields, StageColor fallback) {
        Optional<double[]> parts = fields.tuple("color_rgba", Form.COLOR);
        Optional<String> name = fields.text("color");
        if (name.isPresent()) {
            return name.get().equals("random")
                    ? Optional.empty()
                    : named(name.get(), fields.locationOf("color")).or(() -> Optional.of(StageColor.RED));
        }
        return Optional.of(parts.map(StageColor::of).orElse(fallback));
    }

    @Override
    public Optional<StageColor> named(String name, Location at) {
        Optional<StageColor> color = StageColor.named(name);
        if (color.isEmpty()) {
            findings.warn(
                    at,
                    "There is no color '%s'.".formatted(WorldProblems.shortened(name)),
                    findings.maybe(name, StageColor.names(), "Stage would take red."));
        }
        return color;
    }
}
