package rsal.map;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;
import rsal.settings.FileSource;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;
import rsal.settings.Problem;
import rsal.settings.Problems;
import rsal.settings.Section;
import rsal.settings.Suggestion;
import rsal.settings.Value;
import rsal.yaml.Yaml;

/// Reads maps in the format of ROS's `map_server`: a YAML file that names an image and says how to read it.
///
/// A pixel's darkness is 0 (white) to 1 (black), the other way round with `negate`. Darker than
/// `occupied_thresh` is [OccupancyGrid#OCCUPIED], lighter than `free_thresh` is [OccupancyGrid#FREE], what lies
/// between is [OccupancyGrid#UNKNOWN]; in the mode `scale`, so is what is transparent. Colors count by their
/// mean. Maps that are turned (`origin` with a third value other than 0) are refused.
///
/// The mode `mapfile` reads images as Player's driver of that name does: its thresholds are 0.95 and 0.1,
/// opacity counts as one more color, and the image's middle lies at the origin unless the file says where it
/// lies.
///
/// Instead of an image there can be a [LetterMap]. Settings that are not known here are those of other
/// programs: they have no effect, which [Found#warnings] says.
public final class Maps {
    /// Of an image.
    public static final int MAX_IMAGE_BYTES = 1 << 28;

    private static final double LEAST_UNKNOWN = 0.001; // share of an image that is worth a warning

    private static final Pattern IMAGE = Pattern.compile("(?i).+\\.(pgm|png)(\\.gz)?");
    private static final FileSource BUILT_IN = FileSource.resources(Maps.class, "/rsal/maps/");

    private final FileSource files;
    private final KnownMaps known;

    /// @param files where a person's own maps are
    public Maps(FileSource files) {
        this(files, new KnownMaps());
    }

    /// @param files where a person's own maps are
    /// @param known maps of which those that are read again have the same cells
    public Maps(FileSource files, KnownMaps known) {
        this.files = files;
        this.known = known;
    }

    /// Names of the maps that come with the program.
    public static List<String> builtIn() {
        return BUILT_IN.text("index.txt", 1 << 16, Location.of("rsal/maps"))
                .lines()
                .filter(line -> !line.isBlank())
                .toList();
    }

    /// Reads a map that comes with the program (`office`) or a person's own (`maps/lab.yaml`).
    ///
    /// @param askedAt where the name was written, for messages
    /// @throws InvalidSettings when there is no such map or its files are wrong
    public OccupancyGrid read(String name, Location askedAt) {
        return find(name, askedAt).grid();
    }

    /// A map that was read.
    ///
    /// @param warnings of what in its files has no effect, or may not mean what their author thinks
    public record Found(OccupancyGrid grid, List<Problem> warnings) {}

    /// As [#read], with what the map's author should know.
    public Found find(String name, Location askedAt) {
        List<String> builtIn = builtIn();
        if (builtIn.contains(name)) {
            return read(BUILT_IN, name + ".yaml", askedAt);
        }
        if (name.endsWith(".yaml") || name.endsWith(".yml")) {
            return read(files, name, askedAt);
        }
        if (IMAGE.matcher(name).matches()) {
            throw new InvalidSettings(
                    askedAt,
                    "'%s' is an image, which alone does not say how large its cells are.".formatted(name),
                    "A map goes by the name of a YAML file as ROS's map_server writes it, with 'image', 'resolution' and 'origin'.");
        }
        throw new InvalidSettings(
                askedAt,
                "There is no map '%s'.".formatted(name),
                Suggestion.among(name, builtIn) + " Name your own map by its YAML file.");
    }

    private Found read(FileSource source, String path, Location askedAt) {
        Value.Mapping file = Yaml.read(source, path, askedAt);
        var problems = new Problems();
        var section = new Section("", file, problems);
        double resolution = section.number("resolution");
        if (problems.isEmpty() && !(resolution >= 0.001 && resolution <= 100)) {
            section.problem(
                    "resolution",
                    "'resolution' must be a number from 0.001 to 100 [m], not '%s'.".formatted(resolution),
                    "");
        }
        boolean drawn = section.has("drawing");
        if (drawn && section.has("image")) {
            section.problem("image", "A map has either an 'image' or a 'drawing', not both.", "Take one of them out.");
        }
        String from = section.text(drawn ? "drawing" : "image");
        Location fromAt = section.locationOf(drawn ? "drawing" : "image");
        var mode = drawn ? Mode.TRINARY : mode(section);
        Optional<double[]> origin = origin(section, drawn || mode == Mode.MAPFILE);
        Optional<Shading> shading = drawn ? Optional.empty() : Optional.of(shading(section, mode));
        section.doneWithOthers();
        problems.throwIfAny();
        MapImage cells = shading.map(how -> image(source, path, from, fromAt, how))
                .orElseGet(() -> LetterMap.read(from, fromAt));
        double[] corner = origin.orElseGet(() -> drawn
                ? new double[2]
                : new double[] {-resolution * cells.width() / 2, -resolution * cells.height() / 2});
        var grid = new OccupancyGrid(cells.width(), cells.height(), resolution, corner[0], corner[1], cells.cells());
        shading.flatMap(how -> lostUnknown(cells, how, section)).ifPresent(problems::warn);
        return new Found(grid, problems.warnings());
    }

    /// A warning where what ROS's map_saver writes for unknown space, gray 205, is read as something else.
    private static Optional<Problem> lostUnknown(MapImage image, Shading shading, Section section) {
        byte read = shading.cell(MapImage.UNKNOWN_GRAY);
        double share = (double) image.unknownGray() / image.cells().length;
        if (read == OccupancyGrid.UNKNOWN || share < LEAST_UNKNOWN) {
            return Optional.empty();
        }
        String key = shading.negate() ? "negate" : read == OccupancyGrid.FREE ? "free_thresh" : "occupied_thresh";
        return Optional.of(new Problem(
                section.locationOf(key),
                String.format(
                        Locale.ROOT,
                        "%.1f %% of the image is gray 205, which map_saver writes for unknown space; '%s' makes it %s.",
                        100 * share,
                        key,
                        read == OccupancyGrid.FREE ? "free" : "occupied"),
                switch (key) {
                    case "negate" -> "Write negate: 0, unless white is occupied in this image.";
                    case "free_thresh" -> "Write free_thresh: 0.196 to keep it unknown.";
                    default -> "Write occupied_thresh: 0.65 to keep it unknown.";
                }));
    }

    /// Reads an image as Player's driver `mapfile` does.
    ///
    /// @param name the file's, for messages
    /// @param resolution side of a pixel [m]
    /// @param negate whether white is occupied
    /// @param corner where the lower left one is; empty when the image's middle is at the origin
    /// @throws InvalidSettings when it is not an image, broken, or too large
    public static OccupancyGrid ofMapfile(
            String name, byte[] image, double resolution, boolean negate, Optional<Point2d> corner) {
        MapImage cells = MapImage.read(name, image, new Shading(negate, 0.95, 0.1, Shading.Opacity.COLOR));
        Point2d lowerLeft =
                corner.orElseGet(() -> new Point2d(-resolution * cells.width() / 2, -resolution * cells.height() / 2));
        return new OccupancyGrid(
                cells.width(), cells.height(), resolution, lowerLeft.x(), lowerLeft.y(), cells.cells());
    }

    private MapImage image(FileSource source, String path, String image, Location askedAt, Shading shading) {
        int slash = path.lastIndexOf('/');
        byte[] bytes = source.read(path.substring(0, slash + 1) + image, MAX_IMAGE_BYTES, askedAt);
        return known.of(bytes, shading, () -> MapImage.read(image, bytes, shading));
    }

    /// How an image is read.
    private enum Mode {
        TRINARY,
        SCALE,
        MAPFILE;

        private static List<String> names() {
            return Stream.of(values())
                    .map(mode -> mode.name().toLowerCase(Locale.ROOT))
                    .toList();
        }
    }

    private static Mode mode(Section section) {
        String mode = section.text("mode", "trinary");
        int found = Mode.names().indexOf(mode);
        if (found < 0) {
            section.problem(
                    "mode", "There is no mode '%s' here.".formatted(mode), Suggestion.among(mode, Mode.names()));
        }
        return Mode.values()[Math.max(0, found)];
    }

    private static Optional<double[]> origin(Section section, boolean mayBeMissing) {
        if (!section.has("origin")) {
            if (!mayBeMissing) {
                section.problem(section.location(), "'origin' is missing: [x, y, 0] of the lower left corner.", "");
            }
            return Optional.empty();
        }
        Optional<double[]> origin = section.numbers("origin", 3);
        origin.ifPresent(corner -> {
            if (Math.abs(corner[0]) > 1e6 || Math.abs(corner[1]) > 1e6) {
                section.problem("origin", "'origin' must be within 1000000 m.", "");
            }
            if (corner[2] != 0) {
                section.problem(
                        "origin",
                        "'origin' turns the map by '%s'; only maps that are not turned can be read."
                                .formatted(corner[2]),
                        "Turn the image instead and set the third value to 0.");
            }
        });
        return origin;
    }

    private static Shading shading(Section section, Mode mode) {
        double occupied = share(section, "occupied_thresh", mode == Mode.MAPFILE ? 0.95 : 0.65);
        double free = share(section, "free_thresh", mode == Mode.MAPFILE ? 0.1 : 0.196);
        if (free > occupied) {
            section.problem(
                    "free_thresh",
                    "'free_thresh' is '%s', above 'occupied_thresh' '%s'.".formatted(free, occupied),
                    "Maybe the two were mixed up.");
        }
        var opacity = switch (mode) {
            case TRINARY -> Shading.Opacity.IGNORED;
            case SCALE -> Shading.Opacity.NEEDED;
            case MAPFILE -> Shading.Opacity.COLOR;
        };
        return new Shading(negate(section), occupied, free, opacity);
    }

    private static double share(Section section, String key, double fallback) {
        double share = section.number(key, fallback);
        if (!(share >= 0 && share <= 1)) {
            section.problem(key, "'%s' must be a number from 0 to 1, not '%s'.".formatted(key, share), "");
        }
        return share;
    }

    private static boolean negate(Section section) {
        return section.find("negate")
                .map(value -> {
                    Object read = value instanceof Value.Scalar scalar ? scalar.value() : value.describe();
                    if (read.equals(1L) || read.equals(true)) {
                        return true;
                    }
                    if (!read.equals(0L) && !read.equals(false)) {
                        section.expected("negate", "0 or 1", value);
                    }
                    return false;
                })
                .orElse(false);
    }
}
