package rsal.world.yaml;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import rsal.data.Interval;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Prism;
import rsal.data.Shape;
import rsal.image.Bitmap;
import rsal.image.BitmapReader;
import rsal.map.Maps;
import rsal.scene.Block;
import rsal.scene.Entity;
import rsal.scene.SolidRaster;
import rsal.scene.Surface;
import rsal.settings.FileSource;
import rsal.settings.InvalidSettings;
import rsal.settings.Section;
import rsal.settings.Suggestion;
import rsal.settings.Value;
import rsal.world.Upright;

/// Reads what is solid for good: lines, shapes, images and maps. Images at right angles and maps become cells, all
/// else bodies.
final class WallReader {
    private static final int MAX_IMAGE_BYTES = 1 << 28;
    private static final long MAX_PIXELS = 1L << 28; // of all images together
    private static final int MAX_RASTERS = 1000; // each of which every ray asks
    private static final int MAX_RECTANGLES = 50_000; // of an image that is turned
    private static final double NEAREST = 1e-6; // points of a line [m]
    private static final List<String> KINDS = List.of("line", "outline", "radius", "length", "image", "map");

    private final FileSource files;
    private final Names names;
    private final List<SolidRaster> rasters = new ArrayList<>();
    private final List<Entity> bodies = new ArrayList<>();
    private int number;
    private long pixels;

    /// @param files beside the world
    WallReader(FileSource files, Names names) {
        this.files = files;
        this.names = names;
    }

    List<SolidRaster> rasters() {
        return rasters;
    }

    List<Entity> bodies() {
        return bodies;
    }

    /// How many groups there were.
    int number() {
        return number;
    }

    /// @param root whose `walls` are a list of groups
    void read(Section root) {
        for (Value item : root.list("walls").orElse(List.of())) {
            number++;
            if (item instanceof Value.Mapping mapping) {
                wall(new Section("walls", mapping, root.problems()));
            } else {
                root.expected("walls", "a list of groups such as {line: [[0, 0], [5, 0]]}", item);
            }
        }
    }

    private void wall(Section wall) {
        String kind = KINDS.stream().filter(wall::has).findFirst().orElse("");
        switch (kind) {
            case "image" -> image(wall);
            case "map" -> map(wall);
            case "" -> {
                String read = wall.names().stream().findFirst().orElse("");
                wall.problem(
                        wall.location(),
                        "A wall must have one of %s.".formatted(String.join(", ", KINDS)),
                        read.isEmpty() ? "" : Suggestion.among(read, KINDS));
            }
            default -> solid(wall, kind);
        }
        if (!kind.isEmpty()) {
            wall.done();
        }
    }

    private void solid(Section wall, String kind) {
        List<Shape> shapes = kind.equals("line") ? line(wall) : shape(wall);
        Surface surface = SurfaceReader.read(wall, Surface.PLAIN);
        Pose2d pose = FloorPlace.one(wall, "pose").pose();
        Interval heights = heights(wall).orElse(new Interval(0, Keys.WALL_HEIGHT));
        add(wall, shapes, surface, pose, heights);
    }

    private void add(Section wall, List<Shape> shapes, Surface surface, Pose2d pose, Interval heights) {
        if (shapes.isEmpty()) {
            return;
        }
        String name = "wall-" + number;
        names.claim(name, shapes.size(), wall.location());
        List<Block> blocks = shapes.stream()
                .map(shape -> new Block(new Prism(shape, heights.least(), heights.most(), Optional.empty()), surface))
                .toList();
        bodies.add(new Entity(name, blocks, pose, 0));
    }

    private List<Shape> line(Section wall) {
        List<Point2d> points = Keys.WALLS.points(wall, "line");
        boolean closed = Keys.flag(wall, Keys.CLOSED);
        double thickness = Keys.number(wall, Keys.THICKNESS);
        if (points.size() == 1) {
            wall.problem("line", "'%s' must have two points or more.".formatted(wall.path("line")), "");
        }
        return points.size() < 2 ? List.of() : along(wall, "line", points, closed, thickness);
    }

    private static List<Shape> along(Section wall, String key, List<Point2d> points, boolean closed, double thickness) {
        var distinct = new ArrayList<>(points);
        if (closed && distinct.size() > 2 && distinct.getFirst().equals(distinct.getLast())) {
            distinct.removeLast();
        }
        for (int i = 0; i + (closed ? 0 : 1) < distinct.size(); i++) {
            Point2d point = distinct.get(i);
            if (!(point.distanceTo(distinct.get((i + 1) % distinct.size())) >= NEAREST)) {
                wall.problem(
                        key,
                        "Point (%s, %s) of '%s' is followed by itself.".formatted(point.x(), point.y(), wall.path(key)),
                        "Name it once.");
                return List.of();
            }
        }
        try {
            return Line.shapes(distinct, closed, thickness);
        } catch (IllegalArgumentException e) { // what is far away and thin can't be told in numbers
            wall.problem(key, "'%s': %s".formatted(wall.path(key), e.getMessage()), "");
            return List.of();
        }
    }

    private static List<Shape> shape(Section wall) {
        Shape shape = Keys.WALLS.shape(wall);
        return wall.has("thickness")
                ? along(wall, "thickness", Line.border(shape), true, Keys.number(wall, Keys.THICKNESS))
                : List.of(shape);
    }

    /// Underside and top; empty when none are told.
    private static Optional<Interval> heights(Section wall) {
        boolean reported = wall.has("bottom") || wall.has("height");
        double bottom = within(wall, "bottom", 0, -Keys.FARTHEST);
        double height = within(wall, "height", Keys.WALL_HEIGHT, 0);
        return reported
                ? Optional.of(new Interval(bottom, Math.max(bottom + height, Math.nextUp(bottom))))
                : Optional.empty();
    }

    private static double within(Section wall, String key, double fallback, double least) {
        double value = wall.number(key, fallback);
        if (value >= least && value <= Keys.FARTHEST) {
            return value;
        }
        wall.problem(
                key,
                "'%s' must be a number from %.0f to %.0f, not '%s'."
                        .formatted(wall.path(key), least, Keys.FARTHEST, value),
                "");
        return fallback;
    }

    private void map(Section wall) {
        String name = wall.text("map");
        if (name.isEmpty()) {
            return;
        }
        try {
            Maps.Found found = new Maps(files).find(name, wall.locationOf("map"));
            found.warnings().forEach(wall.problems()::warn);
            OccupancyGrid map = found.grid();
            count(wall, map.width(), map.height());
            rasters.add(SolidRaster.of(map));
        } catch (InvalidSettings e) {
            wall.problems().addAll(e);
        }
    }

    private void image(Section wall) {
        double threshold = Keys.number(wall, Keys.THRESHOLD);
        boolean fenced = Keys.flag(wall, Keys.FENCED);
        Surface surface = SurfaceReader.read(wall, Surface.PLAIN);
        Pose2d origin = FloorPlace.one(wall, "origin").pose();
        Optional<Interval> heights = heights(wall);
        Optional<Bitmap> bitmap = bitmap(wall, threshold);
        Optional<double[]> cell = cell(wall, bitmap);
        if (bitmap.isEmpty() || cell.isEmpty()) {
            return;
        }
        double x = cell.get()[0];
        double y = cell.get()[1];
        Optional<SolidRaster> raster = Upright.of(
                bitmap.get(),
                origin,
                x,
                y,
                heights.orElse(new Interval(Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY)),
                surface,
                fenced);
        raster.ifPresentOrElse(
                rasters::add,
                () -> turned(
                        wall, bitmap.get(), x, y, surface, origin, heights.orElse(new Interval(0, Keys.WALL_HEIGHT))));
    }

    private void turned(
            Section wall, Bitmap bitmap, double x, double y, Surface surface, Pose2d origin, Interval heights) {
        List<int[]> rectangles = bitmap.rectangles(MAX_RECTANGLES);
        if (rectangles.size() > MAX_RECTANGLES) {
            wall.problem(
                    "origin",
                    "The image has more than %d pieces, too many to be turned like this.".formatted(MAX_RECTANGLES),
                    "Turn the image itself, and set the third value of 'origin' to 0.");
            return;
        }
        List<Shape> shapes = rectangles.stream()
                .<Shape>map(r -> new Shape.Polygon(List.of(
                        new Point2d(r[0] * x, r[2] * y),
                        new Point2d(r[1] * x, r[2] * y),
                        new Point2d(r[1] * x, r[3] * y),
                        new Point2d(r[0] * x, r[3] * y))))
                .toList();
        add(wall, shapes, surface, origin, heights);
    }

    private Optional<Bitmap> bitmap(Section wall, double threshold) {
        String name = wall.text("image");
        if (name.isEmpty()) {
            return Optional.empty();
        }
        try {
            Bitmap bitmap = BitmapReader.read(files.read(name, MAX_IMAGE_BYTES, wall.locationOf("image")), threshold);
            count(wall, bitmap.width(), bitmap.height());
            return Optional.of(bitmap);
        } catch (InvalidSettings e) {
            wall.problems().addAll(e);
        } catch (BitmapReader.Unreadable e) {
            wall.problem("image", "Image '%s' can't be read: %s.".formatted(name, e.why()), e.remedy());
        }
        return Optional.empty();
    }

    private void count(Section wall, int width, int height) {
        if (rasters.size() >= MAX_RASTERS) {
            throw new InvalidSettings(
                    wall.location(),
                    "The world has more than %d images and maps.".formatted(MAX_RASTERS),
                    "Make one image of several.");
        }
        pixels += (long) width * height;
        if (pixels > MAX_PIXELS) {
            throw new InvalidSettings(
                    wall.location(),
                    "The world's images have more than %d pixels.".formatted(MAX_PIXELS),
                    "Use smaller ones.");
        }
    }

    /// How long and wide a pixel is [m].
    private static Optional<double[]> cell(Section wall, Optional<Bitmap> bitmap) {
        boolean size = wall.has("size");
        if (size == wall.has("resolution")) {
            wall.problem(
                    wall.location(),
                    "An image must have a 'resolution', or a 'size', not %s.".formatted(size ? "both" : "none"),
                    "{resolution: 0.05}");
            return Optional.empty();
        }
        String key = size ? "size" : "resolution";
        Optional<double[]> read =
                size || wall.find(key).filter(Value.Sequence.class::isInstance).isPresent()
                        ? wall.numbers(key, 2)
                        : Optional.of(wall.number(key, 0)).map(r -> new double[] {r, r});
        if (read.isEmpty() || bitmap.isEmpty()) {
            return Optional.empty();
        }
        double x = size ? read.get()[0] / bitmap.get().width() : read.get()[0];
        double y = size ? read.get()[1] / bitmap.get().height() : read.get()[1];
        if (x >= NEAREST && x <= 1000 && y >= NEAREST && y <= 1000) {
            return Optional.of(new double[] {x, y});
        }
        wall.problem(
                key, "Pixels of %s × %s m are not read here.".formatted(x, y), "Maybe '%s' is wrong.".formatted(key));
        return Optional.empty();
    }
}
