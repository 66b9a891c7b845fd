package rsal.cli.show;

import java.util.Collection;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import rsal.agent.AgentHostProvider;
import rsal.agent.AgentType;
import rsal.cli.terminal.TextTable;
import rsal.device.Device;
import rsal.metric.MetricType;
import rsal.metric.QuantityType;
import rsal.robot.DeviceDriver;
import rsal.robot.DeviceKind;
import rsal.scenario.installed.Providers;
import rsal.settings.Parameter;
import rsal.settings.Plugin;
import rsal.system.RobotSystemProvider;

/// Something installed that scenarios name by its key and that has settings of its own.
///
/// @param kind `agent`, `driver`, `metric`, `mas`, `mrs`, or a kind of plugins as `controller`
/// @param makes type of the device that a driver makes; key of the driver that a plugin is for
/// @param needs types of devices that a robot must have for it
/// @param quantities what conditions and metrics can ask of a metric
public record InstalledKind(
        String kind,
        String name,
        String description,
        Optional<String> makes,
        List<String> needs,
        List<Offer> quantities,
        List<Setting> settings) {
    /// @param written as in a condition or metric: `caught(ROLE)`
    public record Offer(String written, String unit, String description) {
        static Stream<Offer> of(MetricType type) {
            return Stream.concat(
                    type.quantities().stream().map(Offer::of),
                    type.signals().stream()
                            .map(signal -> new Offer(
                                    "mean(%s)".formatted(signal.word()), signal.unit(), signal.description())));
        }

        private static Offer of(QuantityType type) {
            String names = type.names().stream()
                    .map(name -> name.name().startsWith("THINGS") ? "THINGS" : name.name())
                    .collect(Collectors.joining(", "));
            String written = names.isEmpty() ? type.word() : "%s(%s)".formatted(type.word(), names);
            return new Offer(
                    type.countsAll() ? "%s, %s(%s)".formatted(written, type.wordForAll(), names) : written,
                    type.unit(),
                    type.description());
        }
    }

    /// @param value when none is given; empty when one must be
    /// @param expected its type, range and unit
    public record Setting(
            String name,
            String type,
            Optional<Object> value,
            Optional<Double> min,
            Optional<Double> max,
            List<String> options,
            String unit,
            String expected,
            String description) {
        /// Whether its description names one of these, and it is not the setting that chooses among them.
        private boolean isAbout(Set<String> choices) {
            return options.stream().noneMatch(choices::contains)
                    && Stream.of(description.split("\\W+")).anyMatch(choices::contains);
        }

        static Setting of(Parameter<?> p) {
            return new Setting(
                    p.name(),
                    p.kind().name().toLowerCase(Locale.ROOT),
                    p.fallback().map(Parameter::shown),
                    Optional.of(p.min()).filter(Double::isFinite),
                    Optional.of(p.max()).filter(Double::isFinite),
                    p.options(),
                    p.unit(),
                    p.expected(),
                    p.description());
        }
    }

    public static Stream<InstalledKind> agents() {
        return found(AgentType.class, AgentType::key).map(InstalledKind::of);
    }

    static InstalledKind of(AgentType type) {
        return new InstalledKind(
                "agent",
                type.key(),
                type.description(),
                Optional.empty(),
                names(type.needs()),
                List.of(),
                settings(type.parameters()));
    }

    public static Stream<InstalledKind> metrics() {
        return found(MetricType.class, MetricType::key).map(InstalledKind::of);
    }

    static InstalledKind of(MetricType type) {
        return new InstalledKind(
                "metric",
                type.key(),
                type.description(),
                Optional.empty(),
                List.of(),
                Offer.of(type).toList(),
                settings(type.parameters()));
    }

    public static Stream<InstalledKind> drivers() {
        return found(DeviceDriver.class, DeviceDriver::key)
                .map(d -> new InstalledKind(
                        "driver",
                        d.key(),
                        d.description(),
                        Optional.of(d.makes().getSimpleName()),
                        names(d.needs()),
                        List.of(),
                        settings(d.parameters())));
    }

    /// What device drivers can be told to use.
    public static Stream<InstalledKind> plugins() {
        return found(DeviceDriver.class, DeviceDriver::key)
                .flatMap(driver -> driver.parameters().stream()
                        .flatMap(parameter -> parameter.plugins().stream())
                        .flatMap(kind -> kind.all().stream().map(plugin -> of(plugin, kind.word(), driver.key()))))
                .distinct(); // a driver may use some for several things
    }

    /// Kinds of devices that parts of robots can be.
    public static Stream<InstalledKind> devices() {
        return found(DeviceKind.class, DeviceKind::key)
                .map(d -> of(d, "device", d.makes().getSimpleName()));
    }

    /// @param made the driver that uses it; of a kind of devices, what they are
    static InstalledKind of(Plugin plugin, String word, String made) {
        return new InstalledKind(
                word,
                plugin.key(),
                plugin.description(),
                Optional.of(made),
                List.of(),
                List.of(),
                settings(plugin.parameters()));
    }

    /// @param word `controller`
    public static Stream<InstalledKind> plugins(String word) {
        return plugins().filter(plugin -> plugin.kind.equals(word));
    }

    public static Stream<InstalledKind> hosts() {
        return found(AgentHostProvider.class, AgentHostProvider::key)
                .map(h -> settable("mas", h.key(), h.description(), h.parameters()));
    }

    public static Stream<InstalledKind> systems() {
        return found(RobotSystemProvider.class, RobotSystemProvider::key)
                .map(s -> settable("mrs", s.key(), s.description(), s.parameters()));
    }

    private static InstalledKind settable(String kind, String key, String description, List<Parameter<?>> parameters) {
        return new InstalledKind(kind, key, description, Optional.empty(), List.of(), List.of(), settings(parameters));
    }

    static List<InstalledKind> all() {
        return Stream.of(agents(), drivers(), plugins(), devices(), metrics(), hosts(), systems())
                .flatMap(kinds -> kinds)
                .toList();
    }

    /// Whether it is called like that: `patrol`, or, where a scenario has that name, `agent:patrol`.
    boolean is(String typed) {
        return typed.equals(name) || typed.equals(kind + ":" + name);
    }

    /// Whether it is a driver that can be told to use something, as `vfh`.
    boolean offers(String choice) {
        return kind.equals("driver") && settings.stream().anyMatch(setting -> setting.options.contains(choice));
    }

    /// The same with only those settings that matter where it is told to use something. Descriptions name what they
    /// are about.
    InstalledKind about(String choice) {
        Set<String> others = settings.stream()
                .filter(setting -> setting.options.contains(choice))
                .flatMap(setting -> setting.options.stream())
                .filter(option -> !option.equals(choice))
                .collect(Collectors.toSet());
        return new InstalledKind(
                kind,
                name,
                description,
                makes,
                needs,
                quantities,
                settings.stream().filter(setting -> !setting.isAbout(others)).toList());
    }

    /// The same by the name of its file.
    InstalledKind named(String file) {
        return new InstalledKind(kind, file, description, makes, needs, quantities, settings);
    }

    /// For people.
    String text() {
        var text = new StringBuilder("%s: %s%n".formatted(name, title()));
        if (!description.isEmpty()) {
            text.append(description).append('\n');
        }
        if (!needs.isEmpty()) {
            text.append("Needs a robot with ").append(String.join(", ", needs)).append(".\n");
        }
        if (!quantities.isEmpty()) {
            var offered = new TextTable("  ");
            quantities.forEach(offer ->
                    offered.row(offer.written, offer.unit.isEmpty() ? "" : "[" + offer.unit + "]", offer.description));
            text.append("\nConditions and metrics can ask for:\n").append(offered);
        }
        text.append('\n').append(settings.isEmpty() ? "Nothing can be set.\n" : howToSet() + "\n");
        var table = new TextTable("  ");
        settings.forEach(s -> table.row(
                s.name, s.value.map(InstalledKind::written).orElse("must be given"), s.expected, s.description));
        return text.append(table).toString();
    }

    /// How to show it where what it shares its name with is shown.
    String alsoText() {
        return "%n'%s' is also %s: rsal show %s:%s%n".formatted(name, title(), kind, name);
    }

    /// `a controller for 'navigator'`.
    String title() {
        return switch (kind) {
            case "agent" -> "a type of agents";
            case "driver" -> "a device driver, makes a " + makes.orElseThrow();
            case "device" -> "a kind of devices, a " + makes.orElseThrow();
            case "metric" -> "a metric";
            case "mas" -> "a multi-agent system";
            case "mrs" -> "a robot system";
            default -> "a %s for '%s'".formatted(kind, makes.orElseThrow());
        };
    }

    private String howToSet() {
        return switch (kind) {
            case "agent" -> "Parameters (agents: {NAME: {type: %s, parameters: {…}}})".formatted(name);
            case "metric" -> "Parameters (metricTypes: [{type: %s, parameters: {…}}])".formatted(name);
            case "device" ->
                "Parameters of a part (a file with 'type: %s', 'period: SECONDS' and these)".formatted(name);
            case "driver" -> "Parameters (devices: {NAME: {type: %s, …}})".formatted(name);
            case "mas", "mrs" -> "Parameters (%s: {use: %s, …})".formatted(kind, name);
            default ->
                "Parameters (devices: {NAME: {type: %s, %s: {type: %s, …}}})"
                        .formatted(makes.orElseThrow(), kind, name);
        };
    }

    private static String written(Object value) {
        return value.equals("") ? "\"\"" : value.toString();
    }

    private static <P> Stream<P> found(Class<P> kind, Function<P, String> key) {
        return Providers.byKey(kind, key).values().stream();
    }

    private static List<Setting> settings(List<Parameter<?>> parameters) {
        return parameters.stream().map(Setting::of).toList();
    }

    private static List<String> names(Collection<Class<? extends Device>> types) {
        return types.stream().map(Class::getSimpleName).toList();
    }
}
