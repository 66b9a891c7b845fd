package rsal.sim.stage;

import java.time.Duration;
import java.util.Arrays;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;
import rsal.settings.Location;
import rsal.settings.Suggestion;
import rsal.settings.Value;
import rsal.sim.stage.Entity.Setting;

/// Reads one entity's properties in SI and radians. What is wrong is told and replaced by a harmless value, so
/// that reading goes on; what nobody asked for has no effect and is told at the end.
final class Fields {
    /// Coordinates beyond are mistakes [m].
    private static final double FARTHEST = 1e6;

    private static final Pattern INDEX = Pattern.compile("\\[\\d+]");

    private static final Map<String, String> OBSOLETE = Map.ofEntries(
            Map.entry("laser_return", "Rangers look at ranger_return."),
            Map.entry("sonar_return", "Rangers look at ranger_return."),
            Map.entry("range_min", "Put it into a sensor: sensor ( range [MIN MAX] )."),
            Map.entry("range_max", "Put it into a sensor: sensor ( range [MIN MAX] )."),
            Map.entry("samples", "Put it into a sensor: sensor ( samples N )."),
            Map.entry("fov", "Put it into a sensor: sensor ( fov ANGLE )."),
            Map.entry("view", "Write range [MIN MAX] and fov ANGLE in a sensor."),
            Map.entry("sview", "Write range [MIN MAX] and fov ANGLE in a sensor."),
            Map.entry("scount", "Write one sensor ( pose [X Y Z A] ) for each transducer."),
            Map.entry("spose", "Write one sensor ( pose [X Y Z A] ) for each transducer."),
            Map.entry("ssize", "Write size [X Y Z] in a sensor."),
            Map.entry("channel_count", "Write colors_count."),
            Map.entry("channels", "Write colors."),
            Map.entry("blocks", "Write one block ( points N point[0] [X Y] ... z [MIN MAX] ) for each."),
            Map.entry("shape", "Write a block."),
            Map.entry("interval_real", "A run's pace is chosen when it is started."),
            Map.entry("size", "A world is as large as what is in it."));

    private final Entity entity;
    private final String what;
    private final Units units;
    private final Findings findings;
    private final Set<String> asked = new LinkedHashSet<>();

    /// @param what how messages call the entity
    Fields(Entity entity, String what, Units units, Findings findings) {
        this.entity = entity;
        this.what = what;
        this.units = units;
        this.findings = findings;
    }

    Entity entity() {
        return entity;
    }

    Findings findings() {
        return findings;
    }

    boolean has(String name) {
        asked.add(name);
        return entity.settings().containsKey(name);
    }

    Location locationOf(String name) {
        return entity.find(name).map(Setting::location).orElse(entity.location());
    }

    double number(String name, double fallback) {
        return scalar(name, Units.Kind.NUMBER, fallback);
    }

    double scaled(String name, Units.Kind kind, double fallback) {
        return scalar(name, kind, fallback);
    }

    double length(String name, double fallback) {
        return scalar(name, Units.Kind.LENGTH, fallback);
    }

    double angle(String name, double fallback) {
        return scalar(name, Units.Kind.ANGLE, fallback);
    }

    /// A number that must not be below a bound.
    double atLeast(double least, String name, Units.Kind kind, double fallback) {
        double value = scalar(name, kind, fallback);
        if (value < least) {
            problem(name, "(%s) must be at least %s, not %s.".formatted(name, plain(least), describe(name)), "");
            return fallback;
        }
        return value;
    }

    /// Read as a whole number, what is behind the point cut off.
    int integer(String name, int fallback, int least, int most) {
        double value = scalar(name, Units.Kind.NUMBER, fallback);
        if (!((int) value >= least && (int) value <= most)) {
            problem(
                    name,
                    "(%s) must be a whole number from %d to %d, not %s.".formatted(name, least, most, describe(name)),
                    "");
            return fallback;
        }
        return (int) value;
    }

    /// 0 is no, any other number yes.
    boolean flag(String name, boolean fallback) {
        return (long) scalar(name, Units.Kind.NUMBER, fallback ? 1 : 0) != 0;
    }

    /// A number of milliseconds.
    Duration milliseconds(String name, double fallback) {
        double value = scalar(name, Units.Kind.NUMBER, fallback);
        if (!(value > 0 && value <= 1e9)) {
            problem(
                    name,
                    "(%s) must be a positive number of milliseconds, not %s.".formatted(name, describe(name)),
                    "");
            value = fallback;
        }
        return Duration.ofNanos(Math.round(value * 1e6));
    }

    Optional<String> text(String name) {
        asked.add(name);
        return entity.find(name).map(setting -> Units.text(setting.value()));
    }

    /// One of several words.
    String choice(String name, String fallback, List<String> options) {
        String word = text(name).orElse(fallback);
        if (!options.contains(word)) {
            problem(
                    name,
                    "There is no %s (%s).".formatted(name, Findings.shortened(word)),
                    Suggestion.among(word, options));
            return fallback;
        }
        return word;
    }

    /// All values of a tuple, or the one value that it is, as texts.
    List<String> texts(String name) {
        asked.add(name);
        return entity.find(name)
                .map(setting -> setting.value() instanceof Value.Sequence tuple
                        ? tuple.items().stream().map(Units::text).toList()
                        : List.of(Units.text(setting.value())))
                .orElse(List.of());
    }

    /// A tuple of numbers; what it has in excess is left out.
    ///
    /// @param shape how it is written, `[x y z a]`; what begins with `a` is an angle, all else a length
    Optional<double[]> tuple(String name, String shape) {
        Units.Kind[] kinds = Arrays.stream(
                        shape.substring(1, shape.length() - 1).split(" "))
                .map(part -> part.startsWith("a") ? Units.Kind.ANGLE : Units.Kind.LENGTH)
                .toArray(Units.Kind[]::new);
        return tuple(name, shape, kinds);
    }

    /// Likewise, of numbers that are neither lengths nor angles.
    Optional<double[]> numbers(String name, String shape) {
        var kinds = new Units.Kind[shape.split(" ").length];
        Arrays.fill(kinds, Units.Kind.NUMBER);
        return tuple(name, shape, kinds);
    }

    /// Likewise, of numbers of the given kinds.
    Optional<double[]> tuple(String name, String shape, Units.Kind... kinds) {
        asked.add(name);
        Setting setting = entity.settings().get(name);
        if (setting == null) {
            return Optional.empty();
        }
        List<Value> items =
                setting.value() instanceof Value.Sequence sequence ? sequence.items() : List.of(setting.value());
        if (items.size() < kinds.length) {
            problem(
                    name,
                    "(%s) needs %d numbers, %s, but has %d.".formatted(name, kinds.length, shape, items.size()),
                    completion(name, items));
            return Optional.empty();
        }
        var numbers = new double[kinds.length];
        for (int i = 0; i < numbers.length; i++) {
            double number = Units.number(items.get(i)) * units.scale(kinds[i]);
            if (!isSane(number)) {
                findings.error(
                        items.get(i).location(),
                        "Value %d of (%s) must be a number, not %s."
                                .formatted(i + 1, name, items.get(i).describe()),
                        "");
                return Optional.empty();
            }
            numbers[i] = number;
        }
        return Optional.of(numbers);
    }

    /// Tuples of old worlds, which had no z.
    private static String completion(String name, List<Value> items) {
        List<String> given = items.stream().map(Units::text).toList();
        if (List.of("pose", "origin", "localization_origin").contains(name) && given.size() == 3) {
            return "Maybe [%s %s 0 %s], with 0 for z?".formatted(given.get(0), given.get(1), given.get(2));
        }
        if (name.equals("size") && given.size() == 2) {
            return "Maybe [%s %s 1], with 1 for the height?".formatted(given.get(0), given.get(1));
        }
        return "";
    }

    private double scalar(String name, Units.Kind kind, double fallback) {
        asked.add(name);
        Setting setting = entity.settings().get(name);
        if (setting == null) {
            return fallback;
        }
        double number = Units.number(setting.value()) * units.scale(kind);
        if (!isSane(number)) {
            problem(name, "(%s) must be a number, not %s.".formatted(name, describe(name)), "");
            return fallback;
        }
        return number;
    }

    private static boolean isSane(double number) {
        return Math.abs(number) <= FARTHEST * 1000;
    }

    private String describe(String name) {
        return entity.find(name).map(setting -> setting.value().describe()).orElse("nothing");
    }

    /// Where a model is: x, y, z [m] and heading [rad].
    Optional<Placement> pose(String name) {
        return tuple(name, "[x y z a]").flatMap(p -> {
            if (!(Math.abs(p[0]) <= FARTHEST && Math.abs(p[1]) <= FARTHEST && Math.abs(p[2]) <= FARTHEST)) {
                problem(name, "(%s) must be within %s m.".formatted(name, plain(FARTHEST)), "");
                return Optional.empty();
            }
            return Optional.of(Placement.of(p[0], p[1], p[2], p[3]));
        });
    }

    Size size(Size fallback) {
        return tuple("size", "[x y z]")
                .flatMap(s -> {
                    if (Arrays.stream(s).allMatch(side -> side >= 0 && side <= FARTHEST)) {
                        return Optional.of(new Size(s[0], s[1], s[2]));
                    }
                    problem("size", "(size) must be from 0 to %s m.".formatted(plain(FARTHEST)), "");
                    return Optional.empty();
                })
                .orElse(fallback);
    }

    /// A range from the least to the greatest, `[min max]`.
    Interval interval(String name, Interval fallback) {
        return tuple(name, "[min max]").flatMap(r -> interval(name, r[0], r[1])).orElse(fallback);
    }

    Optional<Interval> interval(String name, double min, double max) {
        if (min <= max) {
            return Optional.of(new Interval(min, max));
        }
        problem(
                name,
                "(%s) has its least value (%s) above its greatest (%s).".formatted(name, plain(min), plain(max)),
                "Maybe the two were mixed up.");
        return Optional.empty();
    }

    void problem(String name, String message, String remedy) {
        findings.error(locationOf(name), message, remedy);
    }

    /// Properties that mean something to Stage, though nothing here.
    void ignore(Set<String> names) {
        asked.addAll(names);
    }

    /// Tells of what was never asked for, once for each family (`spose[0]`, `spose[1]`, ...).
    void done() {
        var families = new LinkedHashSet<String>();
        for (Setting setting : entity.settings().values()) {
            if (asked.contains(setting.name())) {
                continue;
            }
            String family = family(setting.name());
            if (families.add(family)) {
                String remedy = OBSOLETE.containsKey(family)
                        ? "Older versions of Stage knew it. " + OBSOLETE.get(family)
                        : findings.maybe(family, known(), "");
                findings.warn(
                        setting.location(),
                        "(%s) is not known in %s and has no effect."
                                .formatted(Findings.shortened(setting.name()), what),
                        remedy);
            }
        }
    }

    /// `block[3].point[2]` belongs to `block`, `bpose[1]` to `bpose`.
    private static String family(String name) {
        int index = name.indexOf('[');
        return index > 0 && INDEX.matcher(name).find() ? name.substring(0, index) : name;
    }

    private Set<String> known() {
        var known = new TreeSet<String>();
        for (String name : asked) {
            known.add(family(name));
        }
        known.removeAll(entity.settings().keySet());
        return known;
    }

    private static String plain(double value) {
        return value == Math.rint(value) && Math.abs(value) < 1e15
                ? Long.toString((long) value)
                : Double.toString(value);
    }
}
