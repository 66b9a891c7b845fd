package rsal.settings;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Pattern;
import rsal.data.Pose2d;

/// Reads one group of settings strictly: what is asked for is known, what is left over is an error. A value that
/// is wrong or missing is noted in the problems and replaced by a harmless one, so that reading goes on and the
/// rest is checked, too.
public final class Section {
    private final String name;
    private final Value.Mapping mapping;
    private final Problems problems;
    private final PluginFiles plugins;
    private final boolean given;
    private boolean absent; // the whole group is left out
    private final Set<String> asked = new LinkedHashSet<>();
    private final Map<String, Problem> missing = new LinkedHashMap<>(); // what was noted to be, by key
    private final Map<String, List<Section>> leftOut = new HashMap<>(); // groups that are not given, by key

    /// @param name how messages call the group, `robots.prey`; empty at the top of a file
    public Section(String name, Value.Mapping mapping, Problems problems) {
        this(name, mapping, problems, PluginFiles.NONE);
    }

    /// @param plugins where plugins come from that this and groups in it name by a file
    public Section(String name, Value.Mapping mapping, Problems problems, PluginFiles plugins) {
        this(name, mapping, problems, plugins, true);
    }

    /// @param given false in place of a value that is no group, of which no more is to be told
    private Section(String name, Value.Mapping mapping, Problems problems, PluginFiles plugins, boolean given) {
        this.name = name;
        this.mapping = mapping;
        this.problems = problems;
        this.plugins = plugins;
        this.given = given;
    }

    public Location location() {
        return mapping.location();
    }

    public Value.Mapping mapping() {
        return mapping;
    }

    public Problems problems() {
        return problems;
    }

    /// Names of all settings given, known or not.
    public Set<String> names() {
        return mapping.entries().keySet();
    }

    public boolean has(String key) {
        asked.add(key);
        return mapping.entries().containsKey(key);
    }

    public Optional<Value> find(String key) {
        asked.add(key);
        return mapping.find(key);
    }

    /// Where a setting's value is, or the group when it isn't given.
    public Location locationOf(String key) {
        return mapping.find(key).map(Value::location).orElse(mapping.location());
    }

    public String text(String key) {
        return required(key, "a text").flatMap(v -> asText(key, v)).orElse("");
    }

    public String text(String key, String fallback) {
        return find(key).flatMap(v -> asText(key, v)).orElse(fallback);
    }

    public double number(String key) {
        return required(key, "a number").flatMap(v -> asNumber(key, v)).orElse(0.0);
    }

    public double number(String key, double fallback) {
        return find(key).flatMap(v -> asNumber(key, v)).orElse(fallback);
    }

    /// A value for a parameter: as it is, checked; the parameter's fallback when it isn't given.
    public Optional<Object> value(Parameter<?> parameter) {
        if (parameter.kind() == Parameter.Kind.PLUGIN
                && mapping.find(parameter.name()).isPresent()) {
            return plugin(parameter).map(Object.class::cast).or(parameter::fallback);
        }
        if (parameter.kind() == Parameter.Kind.PLUGINS
                && mapping.find(parameter.name()).isPresent()) {
            return Optional.of(plugins(parameter));
        }
        return find(parameter.name())
                .map(value -> {
                    try {
                        return Optional.of(parameter.accept(plain(value)));
                    } catch (IllegalArgumentException e) {
                        problem(
                                value.location(),
                                path(String.valueOf(e.getMessage()), parameter.name()),
                                parameter.advice());
                        return parameter.fallback();
                    }
                })
                .orElseGet(() -> {
                    if (parameter.fallback().isEmpty()) {
                        noteMissing(parameter.name(), parameter.expected(), parameter.description());
                    }
                    return parameter.fallback();
                });
    }

    /// A plugin as it is written: its name or file, or a group with that as its `type`.
    private Optional<PluginChoice> plugin(Parameter<?> parameter) {
        PluginKind kind = parameter.plugins().orElseThrow();
        String key = parameter.name();
        return isMapping(key) ? plugin(kind, section(key)) : plugin(kind, key, text(key), locationOf(key));
    }

    /// Several, or one. Those that can't be read are left out; the problems tell of them.
    private List<PluginChoice> plugins(Parameter<?> parameter) {
        PluginKind kind = parameter.plugins().orElseThrow();
        String key = parameter.name();
        if (!(find(key).orElseThrow() instanceof Value.Sequence sequence)) {
            return plugin(parameter).stream().toList();
        }
        var chosen = new ArrayList<PluginChoice>();
        for (Value item : sequence.items()) {
            Optional<PluginChoice> plugin = item instanceof Value.Mapping group
                    ? plugin(kind, new Section(path(key), group, problems, plugins))
                    : asText(key, item).flatMap(name -> plugin(kind, key, name, item.location()));
            plugin.ifPresent(chosen::add);
        }
        return chosen;
    }

    private Optional<PluginChoice> plugin(PluginKind kind, String key, String name, Location at) {
        return chosen(kind, name, at)
                .flatMap(plugin -> set(plugin, new Section(path(key), Value.Mapping.empty(at), problems)));
    }

    private Optional<PluginChoice> plugin(PluginKind kind, Section group) {
        Optional<Plugin> chosen = chosen(kind, group.text("type"), group.locationOf("type"));
        return chosen.flatMap(plugin -> set(plugin, group));
    }

    private Optional<Plugin> chosen(PluginKind kind, String name, Location at) {
        if (name.isEmpty()) {
            return Optional.empty(); // told
        }
        try {
            Optional<Plugin> found = kind.find(name).or(() -> plugins.read(kind, name, at));
            if (found.isEmpty()) {
                problem(at, "There is no %s '%s'.".formatted(kind.word(), name), Suggestion.among(name, kind.keys()));
            }
            return found;
        } catch (InvalidSettings e) {
            problems.addAll(e);
            return Optional.empty();
        }
    }

    private Optional<PluginChoice> set(Plugin plugin, Section group) {
        if (plugins.isStandIn(plugin)) {
            return Optional.of(new PluginChoice(plugin, Arguments.defaults(List.of())));
        }
        return group.arguments(plugin.parameters()).flatMap(arguments -> {
            Optional<String> refusal = plugin.refusal(arguments);
            refusal.ifPresent(why ->
                    problem(group.location(), "'%s' can't work with these values.".formatted(plugin.key()), why));
            return refusal.isPresent() ? Optional.empty() : Optional.of(new PluginChoice(plugin, arguments));
        });
    }

    /// All that is set in this group, when it is right; nothing else may stand in it.
    public Optional<Arguments> arguments(List<Parameter<?>> parameters) {
        int before = problems.all().size();
        Map<String, Object> values = values(parameters);
        done();
        return problems.all().size() == before ? Optional.of(Arguments.of(parameters, values)) : Optional.empty();
    }

    /// All values for a list of parameters. Only to be used when [Problems#isEmpty] at the end.
    public Map<String, Object> values(List<Parameter<?>> parameters) {
        var values = new LinkedHashMap<String, Object>();
        for (Parameter<?> parameter : parameters) {
            value(parameter).ifPresent(value -> values.put(parameter.name(), value));
        }
        return values;
    }

    public Optional<List<Value>> list(String key) {
        return find(key).flatMap(value -> {
            if (value instanceof Value.Sequence sequence) {
                return Optional.of(sequence.items());
            }
            expected(key, "a list", value);
            return Optional.empty();
        });
    }

    /// Numbers in brackets, `[x, y, deg]`.
    public Optional<double[]> numbers(String key, int count) {
        return find(key).flatMap(value -> numbers(key, value, count));
    }

    public Optional<double[]> numbers(String key, Value value, int count) {
        if (value instanceof Value.Sequence sequence
                && sequence.items().size() == count
                && sequence.items().stream().allMatch(i -> i instanceof Value.Scalar s && isFinite(s.value()))) {
            return Optional.of(sequence.items().stream()
                    .mapToDouble(i -> ((Number) ((Value.Scalar) i).value()).doubleValue())
                    .toArray());
        }
        if (value instanceof Value.Sequence sequence && sequence.items().size() == count) {
            sequence.items().stream()
                    .filter(item -> !(item instanceof Value.Scalar s && isFinite(s.value())))
                    .findFirst()
                    .ifPresent(item -> problem(
                            value.location(),
                            "'%s' must be a list of %d numbers; %s is not finite."
                                    .formatted(path(key), count, item.describe()),
                            ""));
        } else {
            expected(key, "a list of %d numbers".formatted(count), value);
        }
        return Optional.empty();
    }

    /// `[x, y, deg]` in m, m, degrees.
    public Optional<Pose2d> pose(String key) {
        return numbers(key, 3).map(n -> Pose2d.ofDegrees(n[0], n[1], n[2]));
    }

    /// A group within this one; an empty one when it isn't given.
    public Section section(String key) {
        Optional<Value> value = find(key);
        Optional<Value.Mapping> group = value.flatMap(v -> asMapping(key, v));
        var section = new Section(
                path(key),
                group.orElse(Value.Mapping.empty(location())),
                problems,
                plugins,
                given && (value.isEmpty() || group.isPresent()));
        if (value.isEmpty()) {
            section.absent = true;
            leftOut.computeIfAbsent(key, _ -> new ArrayList<>()).add(section);
        }
        return section;
    }

    public boolean isMapping(String key) {
        return mapping.find(key).filter(Value.Mapping.class::isInstance).isPresent();
    }

    /// Notes a problem about the value of a setting.
    public void problem(String key, String message, String remedy) {
        problems.add(locationOf(key), message, remedy);
    }

    public void problem(Location location, String message, String remedy) {
        problems.add(location, message, remedy);
    }

    /// Notes that a value is of the wrong kind.
    public void expected(String key, String what, Value read) {
        problem(read.location(), "'%s' must be %s, not %s.".formatted(path(key), what, read.describe()), "");
    }

    /// Everything known has been asked for: what is left over is an error.
    public void done() {
        mergeMissing();
        for (String key : mapping.entries().keySet()) {
            if (!asked.contains(key)) {
                Suggestion.closest(key, asked).ifPresent(this::forgive);
                Location place = mapping.keys().getOrDefault(key, mapping.location());
                problem(
                        place,
                        "'%s' is not known%s.".formatted(key, name.isEmpty() ? " here" : " in '" + name + "'"),
                        Suggestion.among(key, asked));
            }
        }
    }

    /// As [#done], for files that other programs read, too: what nobody asked for is theirs, which is only warned of.
    /// It
    /// is an error still where something must be given that is called almost the same.
    public void doneWithOthers() {
        mergeMissing();
        for (String key : mapping.entries().keySet()) {
            if (!asked.contains(key)) {
                Optional<String> close = Suggestion.closest(key, asked);
                Location place = mapping.keys().getOrDefault(key, mapping.location());
                if (close.filter(missing::containsKey).isPresent()) {
                    close.ifPresent(this::forgive);
                    problem(
                            place,
                            "'%s' is not known here.".formatted(key),
                            "Maybe '%s' was meant?".formatted(close.get()));
                } else {
                    problems.warn(new Problem(
                            place,
                            "'%s' is not known here and has no effect.".formatted(key),
                            close.map("Maybe '%s' was meant?"::formatted).orElse("")));
                }
            }
        }
    }

    /// `robots.prey.pose`: how messages call a setting.
    public String path(String key) {
        return name.isEmpty() ? key : name + "." + key;
    }

    private String path(String message, String parameter) {
        return message.replaceFirst("'" + Pattern.quote(parameter) + "'", "'" + path(parameter) + "'");
    }

    private Optional<Value> required(String key, String what) {
        Optional<Value> value = find(key);
        if (value.isEmpty()) {
            noteMissing(key, what, "");
        }
        return value;
    }

    /// Of a group that is left out whole, what it lacks is one error, groups that it would have included.
    private void mergeMissing() {
        if (!absent) {
            return;
        }
        var names = new ArrayList<>(missing.keySet());
        var reported = new ArrayList<>(missing.values());
        leftOut.forEach((key, groups) -> groups.forEach(group -> {
            if (!group.missing.isEmpty()) {
                names.add(key);
                reported.addAll(group.missing.values());
            }
        }));
        if (names.size() > 1) {
            reported.forEach(problems::withdraw);
            leftOut.clear();
            missing.clear();
            var whole = new Problem(
                    location(), "'%s' is missing: a group with '%s'.".formatted(name, String.join("', '", names)), "");
            missing.put("", whole);
            problems.add(whole);
        }
    }

    private void noteMissing(String key, String what, String remedy) {
        if (given) {
            var problem = new Problem(location(), "'%s' is missing: %s.".formatted(path(key), what), remedy);
            missing.put(key, problem);
            problems.add(problem);
        }
    }

    /// What is missing was given by another name, which is told.
    private void forgive(String key) {
        Optional.ofNullable(missing.get(key)).ifPresent(problems::withdraw);
        leftOut.getOrDefault(key, List.of()).forEach(group -> {
            group.missing.values().forEach(problems::withdraw);
            List.copyOf(group.leftOut.keySet()).forEach(group::forgive);
        });
    }

    private Optional<String> asText(String key, Value value) {
        if (value instanceof Value.Scalar scalar && scalar.value() instanceof String text && !text.isEmpty()) {
            return Optional.of(text);
        }
        expected(key, "a text", value);
        return Optional.empty();
    }

    private Optional<Double> asNumber(String key, Value value) {
        if (value instanceof Value.Scalar scalar && isFinite(scalar.value())) {
            return Optional.of(((Number) scalar.value()).doubleValue());
        }
        expected(key, "a number", value);
        return Optional.empty();
    }

    private Optional<Value.Mapping> asMapping(String key, Value value) {
        if (value instanceof Value.Mapping found) {
            return Optional.of(found);
        }
        expected(key, "a group of settings", value);
        return Optional.empty();
    }

    private static boolean isFinite(Object value) {
        return value instanceof Number n && Double.isFinite(n.doubleValue());
    }

    private static Object plain(Value value) {
        return value instanceof Value.Scalar scalar ? scalar.value() : value.describe();
    }
}
