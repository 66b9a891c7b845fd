package rsal.stage;

import java.time.Duration;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;
import rsal.settings.Location;
import rsal.settings.Suggestion;
import rsal.settings.Value;
import rsal.stage.WorldfileEntity.Setting;

/// Reads one entity's properties in SI and radians. What is wrong is told and replaced by a harmless value, so
/// that reading goes on; what nobody asked for has no effect and is told at the end.
final class EntityFields {
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

    private static final Set<String> OF_SENSORS = Set.of("range", "noise");

    private final WorldfileEntity entity;
    private final String what;
    private final Units units;
    private final WorldProblems findings;
    private final Set<String> asked = new LinkedHashSet<>();

    /// @param what how messages call the entity
    EntityFields(WorldfileEntity entity, String what, Units units, WorldProblems findings) {
        this.entity = entity;
        this.what = what;
        this.units = units;
        this.findings = findings;
    }

    WorldfileEntity entity() {
        return entity;
    }

    WorldProblems findings() {
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
        return within(Form.ANY, name, Units.Kind.NUMBER, fallback);
    }

    double scaled(String name, Units.Kind kind, double fallback) {
        return within(Form.ANY, name, kind, fallback);
    }

    double length(String name, double fallback) {
        return within(Form.ANY, name, Units.Kind.LENGTH, fallback);
    }

    double angle(String name, double fallback) {
        return within(Form.ANY, name, Units.Kind.ANGLE, fallback);
    }

    /// An angle of view, 0 to 2π.
    double turn(String name, double fallback) {
        double full = (2 * Math.PI + 1e-6) / units.angle();
        return within(new ValueRange(0, full), name, Units.Kind.ANGLE, fallback);
    }

    /// A number that must not be negative.
    double notNegative(String name, Units.Kind kind, double fallback) {
        return within(new ValueRange(0, Form.ANY.max()), name, kind, fallback);
    }

    /// A number that must be above 0.
    double positive(String name, Units.Kind kind, double fallback) {
        return within(new ValueRange(Form.ABOVE_0, Form.ANY.max()), name, kind, fallback);
    }

    /// A number, checked.
    ///
    /// @param bounds of lengths in m, of angles in the world's unit
    double within(ValueRange bounds, String name, Units.Kind kind, double fallback) {
        asked.add(name);
        Setting setting = entity.settings().get(name);
        if (setting == null) {
            return fallback;
        }
        double number = Units.number(setting.value());
        Optional<Wrong> wrong = wrong(number, kind, bounds, setting.value());
        wrong.ifPresent(it -> problem(name, "'%s' %s".formatted(name, it.message), it.remedy));
        return wrong.isPresent() ? fallback : number * units.scale(kind);
    }

    /// What is said of a number behind its name, and what to try.
    private record Wrong(String message, String remedy) {}

    /// @param number as it is read
    /// @param bounds of lengths in m, of angles in the world's unit
    private Optional<Wrong> wrong(double number, Units.Kind kind, ValueRange bounds, Value read) {
        if (Double.isNaN(number)) {
            return Optional.of(new Wrong("must be a number, not %s.".formatted(read.describe()), meant(read)));
        }
        double scaled = kind == Units.Kind.LENGTH ? number * units.length() : number;
        if (scaled >= bounds.min() && scaled <= bounds.max()) {
            return Optional.empty();
        }
        String remedy = "";
        if (scaled < 0 && bounds.min() >= 0 && Double.isFinite(number)) {
            remedy = "Maybe %s, without the minus?".formatted(Units.plain(-number));
        } else if (kind != Units.Kind.NUMBER && scaled != 0) {
            remedy = kind == Units.Kind.LENGTH
                    ? "Lengths are in %s here; maybe 'unit_length' is wrong.".formatted(units.name(kind))
                    : "Angles are in %s here; maybe 'unit_angle' is wrong.".formatted(units.name(kind));
        }
        return Optional.of(new Wrong(
                "must be %s, not %s.".formatted(range(bounds, kind, scaled < bounds.min()), read.describe()), remedy));
    }

    /// @param below whether a number was too small, which is all that is told where they may be as large as can be
    private String range(ValueRange bounds, Units.Kind kind, boolean below) {
        boolean positive = bounds.min() == Form.ABOVE_0;
        if (below && bounds.max() == Form.ANY.max() && bounds.min() >= 0) {
            return positive ? "positive" : "at least 0";
        }
        String unit = kind == Units.Kind.LENGTH ? " m" : kind == Units.Kind.ANGLE ? " " + units.name(kind) : "";
        return positive
                ? "positive and at most %s%s".formatted(Units.plain(bounds.max()), unit)
                : "from %s to %s%s".formatted(Units.plain(bounds.min()), Units.plain(bounds.max()), unit);
    }

    /// What may have been meant by a text where a number should be.
    private static String meant(Value read) {
        return Units.flag(Units.text(read))
                .orElse("Numbers are written like 0.4; unit_length and unit_angle say in which units.");
    }

    /// Read as a whole number, what is behind the point cut off.
    int integer(String name, int fallback, int least, int most) {
        return whole(name, least, most).orElse(fallback);
    }

    /// The same; empty when it is missing or wrong.
    OptionalInt whole(String name, int least, int most) {
        asked.add(name);
        Setting setting = entity.settings().get(name);
        if (setting == null) {
            return OptionalInt.empty();
        }
        double number = Units.number(setting.value());
        double whole = number < 0 ? Math.ceil(number) : Math.floor(number);
        if (whole >= least && whole <= most) {
            return OptionalInt.of((int) whole);
        }
        problem(
                name,
                "'%s' must be a whole number from %d to %d, not %s.".formatted(name, least, most, describe(name)),
                "");
        return OptionalInt.empty();
    }

    /// 0 is no, any other number yes.
    boolean flag(String name, boolean fallback) {
        return (long) number(name, fallback ? 1 : 0) != 0;
    }

    /// A number of milliseconds.
    Duration milliseconds(String name, double fallback) {
        return Duration.ofNanos(Math.round(positive(name, Units.Kind.NUMBER, fallback) * 1e6));
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
                    "There is no %s '%s'.".formatted(name, WorldProblems.shortened(word)),
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
    Optional<double[]> tuple(String name, Form form) {
        asked.add(name);
        Setting setting = entity.settings().get(name);
        if (setting == null) {
            return Optional.empty();
        }
        List<Value> items =
                setting.value() instanceof Value.Sequence sequence ? sequence.items() : List.of(setting.value());
        List<Form.Part> parts = form.parts();
        if (items.size() < parts.size()) {
            problem(
                    name,
                    "'%s' needs %d numbers, %s, but %s."
                            .formatted(
                                    name,
                                    parts.size(),
                                    form.shape(),
                                    setting.value() instanceof Value.Sequence
                                            ? "has " + items.size()
                                            : "is " + setting.value().describe()),
                    form.completion(items, units));
            return Optional.empty();
        }
        var numbers = new double[parts.size()];
        for (int i = 0; i < numbers.length; i++) {
            Units.Kind kind = parts.get(i).kind();
            double number = Units.number(items.get(i));
            Optional<Wrong> wrong =
                    wrong(number, kind, kind == Units.Kind.ANGLE ? Form.ANY : form.bounds(), items.get(i));
            if (wrong.isPresent()) {
                findings.error(
                        items.get(i).location(),
                        "Value %d of '%s' %s".formatted(i + 1, name, wrong.get().message),
                        wrong.get().remedy);
                return Optional.empty();
            }
            numbers[i] = number * units.scale(kind);
        }
        return Optional.of(numbers);
    }

    private String describe(String name) {
        return entity.find(name).map(setting -> setting.value().describe()).orElse("nothing");
    }

    /// Where a model is: x, y, z [m] and heading [rad].
    Optional<Placement> pose(String name) {
        return tuple(name, Form.POSE).map(p -> Placement.of(p[0], p[1], p[2], p[3]));
    }

    Size size(Size fallback) {
        return tuple("size", Form.SIZE).map(s -> new Size(s[0], s[1], s[2])).orElse(fallback);
    }

    /// A range from the least to the greatest, `[min max]`.
    ValueRange interval(String name, ValueRange fallback) {
        return tuple(name, Form.RANGE)
                .flatMap(r -> interval(name, r[0], r[1], Units.Kind.LENGTH))
                .orElse(fallback);
    }

    /// @param kind of both
    Optional<ValueRange> interval(String name, double min, double max, Units.Kind kind) {
        if (min <= max) {
            return Optional.of(new ValueRange(min, max));
        }
        problem(
                name,
                "'%s' has its least value '%s' above its greatest '%s'."
                        .formatted(name, Units.plain(min / units.scale(kind)), Units.plain(max / units.scale(kind))),
                min == 0 && max < 0
                        ? "Maybe %s, without the minus?".formatted(Units.plain(-max / units.scale(kind)))
                        : "Maybe the two were mixed up.");
        return Optional.empty();
    }

    void problem(String name, String message, String remedy) {
        findings.error(locationOf(name), message, remedy);
    }

    /// Properties that mean something to Stage, though nothing here.
    void ignore(Set<String> names) {
        asked.addAll(names);
    }

    /// A property that means something to Stage, and that is decided elsewhere here: a warning, unless it has its
    /// usual value.
    void withoutEffect(String name, double usual, String remedy) {
        asked.add(name);
        entity.find(name)
                .filter(setting -> Units.number(setting.value()) != usual)
                .ifPresent(setting ->
                        findings.warn(setting.location(), "'%s' has no effect here.".formatted(name), remedy));
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
                        : entity.type().equals("ranger") && OF_SENSORS.contains(family)
                                ? "Put it into a sensor ( ... ) of this ranger."
                                : findings.maybe(family, known(), "");
                findings.warn(
                        setting.location(),
                        "'%s' is not known in %s and has no effect."
                                .formatted(WorldProblems.shortened(setting.name()), what),
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
}
