package rsal.world.yaml;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.SplittableRandom;
import java.util.random.RandomGenerator;
import org.jspecify.annotations.Nullable;
import rsal.data.Footprint;
import rsal.data.Interval;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Prism;
import rsal.data.Rgb;
import rsal.data.Shape;
import rsal.scene.Block;
import rsal.scene.Entity;
import rsal.scene.NamedSeed;
import rsal.scene.Surface;
import rsal.settings.ColorNames;
import rsal.settings.Location;
import rsal.settings.Problem;
import rsal.settings.Section;
import rsal.settings.Suggestion;
import rsal.settings.Value;

/// Reads fields of obstacles, which stand at random.
final class FieldReader {
    private static final int TRIES = 300; // to place an obstacle
    private static final double LEAST = 0.01; // size [m]
    private static final double MOST = 100; // size [m]
    private static final int ALL_TRIES = 1_000_000; // of all fields
    private static final List<String> SHAPES = List.of("disc", "box", "polygon");

    private final Names names;
    private final List<Field> fields = new ArrayList<>();
    private int tries;

    FieldReader(Names names) {
        this.names = names;
    }

    /// What is said of a field.
    ///
    /// @param area left, bottom, right, top [m]; null for all of the map
    /// @param density per m²; 0 when `count` counts
    /// @param gap from all that is there [m]
    /// @param robotGap from robots [m]
    private record Field(
            String name,
            double @Nullable [] area,
            int count,
            double density,
            List<String> shapes,
            Interval size,
            Interval height,
            List<Rgb> colors,
            Surface surface,
            double gap,
            double robotGap,
            OptionalLong seed,
            Location location) {}

    /// @param section named groups
    void read(Section section) {
        for (String name : section.names()) {
            field(name, section.section(name));
        }
        section.done();
    }

    /// The name of the field that an obstacle is from.
    static String fieldOf(Entity obstacle) {
        return obstacle.name().substring(0, obstacle.name().lastIndexOf('-'));
    }

    boolean isEmpty() {
        return fields.isEmpty();
    }

    private void field(String name, Section section) {
        boolean dense = section.has("density");
        if (dense == section.has("count")) {
            section.problem(
                    section.location(),
                    "'%s' must have a 'count', or a 'density' per m², not %s."
                            .formatted(section.path(""), dense ? "both" : "none"),
                    "{count: 20}");
        }
        Surface surface = SurfaceReader.reported(section).apply(Surface.PLAIN);
        var field = new Field(
                name,
                FloorPlace.area(section, "area").orElse(null),
                dense ? 0 : (int) Keys.whole(section, Keys.COUNT),
                dense ? Keys.number(section, Keys.DENSITY) : 0,
                shapes(section),
                interval(section, "size", new Interval(0.2, 0.6)),
                interval(section, "height", new Interval(0.5, 0.5)),
                colors(section),
                surface,
                Keys.number(section, Keys.GAP),
                Keys.number(section, Keys.ROBOT_GAP),
                section.has("seed") ? OptionalLong.of(Keys.whole(section, Keys.SEED)) : OptionalLong.empty(),
                section.location());
        section.done();
        fields.add(field);
    }

    private static List<String> shapes(Section section) {
        if (!section.has("shapes")) {
            return SHAPES;
        }
        var shapes = new ArrayList<String>();
        for (Value item : section.list("shapes").orElse(List.of())) {
            String word = item instanceof Value.Scalar scalar ? scalar.value().toString() : "";
            if (SHAPES.contains(word)) {
                shapes.add(word);
            } else {
                section.problem(
                        item.location(),
                        "'%s' must list shapes, not %s.".formatted(section.path("shapes"), item.describe()),
                        Suggestion.among(word, SHAPES));
            }
        }
        if (shapes.isEmpty()) {
            section.problem("shapes", "'%s' must list a shape.".formatted(section.path("shapes")), "[disc, box]");
        }
        return shapes;
    }

    private static List<Rgb> colors(Section section) {
        if (!section.has("colors")) {
            return section.has("color")
                    ? List.of(rsal.model.BodyReader.color(section, "color"))
                    : List.of(Surface.PLAIN.color());
        }
        List<Rgb> colors = ColorNames.list(section, "colors");
        return colors.isEmpty() ? List.of(Surface.PLAIN.color()) : colors;
    }

    /// A number, or `[least, most]`.
    private static Interval interval(Section section, String key, Interval fallback) {
        Optional<Value> value = section.find(key);
        if (value.isEmpty()) {
            return fallback;
        }
        double[] ends = new double[] {Double.NaN, Double.NaN};
        if (value.get() instanceof Value.Sequence) {
            ends = section.numbers(key, 2).orElse(ends);
        } else {
            double both = section.number(key, Double.NaN);
            ends = new double[] {both, both};
        }
        if (ends[0] >= LEAST && ends[1] >= ends[0] && ends[1] <= MOST) {
            return new Interval(ends[0], ends[1]);
        }
        section.problem(
                key,
                "'%s' must be [least, most], from %s to %.0f m.".formatted(section.path(key), LEAST, MOST),
                "[%s, %s]".formatted(fallback.least(), fallback.most()));
        return fallback;
    }

    /// Makes up the obstacles.
    ///
    /// @param map of what is there already
    /// @param room the same; the obstacles are added
    /// @param seed for fields that have none
    /// @param warnings about fields that found no room for all of it
    List<Entity> grow(OccupancyGrid map, Room room, long seed, List<Problem> warnings) {
        var grown = new ArrayList<Entity>();
        for (Field field : fields) {
            var random = new SplittableRandom(NamedSeed.of(field.seed.orElse(seed), field.name));
            double[] area = field.area != null
                    ? field.area
                    : new double[] {
                        map.originX(),
                        map.originY(),
                        map.originX() + map.width() * map.resolution(),
                        map.originY() + map.height() * map.resolution()
                    };
            int count = count(field, area, warnings);
            int before = grown.size();
            for (int i = 1; i <= count; i++) {
                Optional<Entity> obstacle = place(field, field.name + "-" + i, area, room, random);
                if (obstacle.isEmpty()) {
                    warnings.add(new Problem(
                            field.location,
                            "Only %d of %d obstacles '%s' found room."
                                    .formatted(grown.size() - before, count, field.name),
                            "Maybe take fewer or smaller ones, or a smaller 'gap'."));
                    break;
                }
                names.claim(obstacle.get().name(), 1, field.location);
                room.add(obstacle.get(), false);
                grown.add(obstacle.get());
            }
        }
        return grown;
    }

    private static int count(Field field, double[] area, List<Problem> warnings) {
        if (field.count > 0) {
            return field.count;
        }
        long wanted = Math.round(field.density * (area[2] - area[0]) * (area[3] - area[1]));
        if (wanted > Keys.MAX_SAME) {
            warnings.add(new Problem(
                    field.location,
                    "Only %d of %d obstacles '%s' are made.".formatted(Keys.MAX_SAME, wanted, field.name),
                    "Maybe take a smaller 'density' or 'area', or several fields."));
        }
        return (int) Math.min(Keys.MAX_SAME, wanted);
    }

    private Optional<Entity> place(Field field, String name, double[] area, Room room, RandomGenerator random) {
        Shape shape = shape(field, random);
        double height = between(field.height, random);
        Rgb color = field.colors.get(random.nextInt(field.colors.size()));
        var block = new Block(new Prism(shape, 0, height, Optional.empty()), field.surface.in(color));
        for (int i = 0; i < TRIES && tries < ALL_TRIES; i++) {
            tries++;
            var pose = new Pose2d(
                    random.nextDouble(area[0], area[2]),
                    random.nextDouble(area[1], area[3]),
                    random.nextDouble(-Math.PI, Math.PI));
            var obstacle = new Entity(name, List.of(block), pose, 0);
            if (room.isFree(pose.x(), pose.y(), Room.radius(obstacle), field.gap, field.robotGap)) {
                return Optional.of(obstacle);
            }
        }
        return Optional.empty();
    }

    private static Shape shape(Field field, RandomGenerator random) {
        double size = between(field.size, random);
        return switch (field.shapes.get(random.nextInt(field.shapes.size()))) {
            case "disc" -> new Shape.Disc(new Point2d(0, 0), size / 2);
            case "box" -> Shape.Polygon.of(Footprint.box(size, between(field.size, random), new Point2d(0, 0)));
            default -> polygon(size / 2, random);
        };
    }

    /// Corners on a circle, each in a sector of its own.
    private static Shape polygon(double radius, RandomGenerator random) {
        int corners = random.nextInt(4, 9);
        var outline = new ArrayList<Point2d>();
        for (int i = 0; i < corners; i++) {
            double angle = 2 * Math.PI * (i + random.nextDouble(0.1, 0.9)) / corners;
            outline.add(new Point2d(radius * Math.cos(angle), radius * Math.sin(angle)));
        }
        return new Shape.Polygon(outline);
    }

    private static double between(Interval interval, RandomGenerator random) {
        return interval.least() < interval.most()
                ? random.nextDouble(interval.least(), interval.most())
                : interval.least();
    }
}
