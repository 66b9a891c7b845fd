package rsal.map;

import java.util.List;
import rsal.data.OccupancyGrid;
import rsal.settings.FileSource;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;
import rsal.settings.Problems;
import rsal.settings.Section;
import rsal.settings.Suggestion;
import rsal.settings.Value;

/// Reads maps in the format of ROS's `map_server`: a YAML file that names an image and says how to read it.
///
/// A pixel's darkness is 0 (white) to 1 (black), the other way round with `negate`. Darker than `occupied_thresh`
/// is [OccupancyGrid#OCCUPIED], lighter than `free_thresh` is [OccupancyGrid#FREE], what lies between is
/// [OccupancyGrid#UNKNOWN]; in the mode `scale`, so is what is transparent. Colors count by their mean. Maps that
/// are turned (`origin` with a third value other than 0) are refused.
public final class Maps {
    private static final int MAX_IMAGE_BYTES = 1 << 28;
    private static final FileSource BUILT_IN = FileSource.resources(Maps.class, "/rsal/maps/");

    private final FileSource files;

    /// @param files where a person's own maps are
    public Maps(FileSource files) {
        this.files = files;
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
        List<String> known = builtIn();
        if (known.contains(name)) {
            return read(BUILT_IN, name + ".yaml", askedAt);
        }
        if (name.endsWith(".yaml") || name.endsWith(".yml")) {
            return read(files, name, askedAt);
        }
        throw new InvalidSettings(
                askedAt,
                "There is no map (%s).".formatted(name),
                Suggestion.among(name, known) + " A map of your own goes by its YAML file's name.");
    }

    private static OccupancyGrid read(FileSource source, String path, Location askedAt) {
        Value.Mapping file = source.yaml(path, askedAt);
        var problems = new Problems();
        var section = new Section("", file, problems);
        String image = section.text("image");
        double resolution = section.number("resolution");
        if (!(resolution >= 0.001 && resolution <= 100)) {
            section.problem(
                    "resolution",
                    "(resolution) must be a number from 0.001 to 100 [m], not (%s).".formatted(resolution),
                    "");
        }
        if (!section.has("origin")) {
            section.problem(section.location(), "(origin) is missing: [x, y, 0] of the lower left corner.", "");
        }
        double[] origin = section.numbers("origin", 3).orElse(new double[3]);
        if (Math.abs(origin[0]) > 1e6 || Math.abs(origin[1]) > 1e6) {
            section.problem("origin", "(origin) must be within 1000000 m.", "");
        }
        if (origin[2] != 0) {
            section.problem(
                    "origin",
                    "(origin) turns the map by (%s); only maps that are not turned can be read.".formatted(origin[2]),
                    "Turn the image instead and set the third value to 0.");
        }
        var shading = shading(section);
        section.done();
        problems.throwIfAny();
        Location imageAt = section.locationOf("image");
        int slash = path.lastIndexOf('/');
        byte[] bytes = source.read(path.substring(0, slash + 1) + image, MAX_IMAGE_BYTES, imageAt);
        MapImage pixels = MapImage.read(image, bytes, shading);
        return new OccupancyGrid(pixels.width(), pixels.height(), resolution, origin[0], origin[1], pixels.cells());
    }

    private static Shading shading(Section section) {
        double occupied = share(section, "occupied_thresh", 0.65);
        double free = share(section, "free_thresh", 0.196);
        if (free > occupied) {
            section.problem(
                    "free_thresh",
                    "(free_thresh) is (%s), above (occupied_thresh) (%s).".formatted(free, occupied),
                    "Maybe the two were mixed up.");
        }
        String mode = section.text("mode", "trinary");
        if (!List.of("trinary", "scale").contains(mode)) {
            section.problem(
                    "mode",
                    "There is no mode (%s) here.".formatted(mode),
                    Suggestion.among(mode, List.of("trinary", "scale")));
        }
        return new Shading(negate(section), occupied, free, mode.equals("scale"));
    }

    private static double share(Section section, String key, double fallback) {
        double share = section.number(key, fallback);
        if (!(share >= 0 && share <= 1)) {
            section.problem(key, "(%s) must be a number from 0 to 1, not (%s).".formatted(key, share), "");
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
