package rsal.experiment;

import static java.util.Objects.requireNonNull;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import rsal.scenario.RunPlan.MetricDefinition;
import rsal.scenario.condition.MetricExpression.FirstTime;
import rsal.scenario.text.Folders;

/// What an experiment is and how it was made, beside its rows. Part of what users build on: names stay, more
/// may follow.
///
/// @param format of the folder: [#FORMAT]
/// @param subject which experiment it is
/// @param arguments of the scenario
/// @param sessions when it was begun, and gone on with
public record Manifest(
        int format,
        Subject subject,
        String title,
        List<Argument> arguments,
        List<MetricEntry> metrics,
        List<Session> sessions,
        String scenarioText) {
    static final int FORMAT = 1;

    /// Which experiment it is: one with another subject has other rows.
    ///
    /// @param scenario its name
    /// @param sha256 of its text, in hexadecimal
    /// @param settings arguments that are the same in all runs, as typed
    /// @param forSeconds simulated time after which runs end; empty when only the scenario says
    public record Subject(
            String scenario,
            String sha256,
            List<String> configurations,
            List<Factor> factors,
            Map<String, String> settings,
            List<Long> seeds,
            OptionalDouble forSeconds) {
        public Subject {
            requireNonNull(scenario);
            requireNonNull(sha256);
            requireNonNull(forSeconds);
            configurations = List.copyOf(configurations);
            factors = List.copyOf(factors);
            settings = Collections.unmodifiableMap(new LinkedHashMap<>(settings));
            seeds = List.copyOf(seeds);
        }

        static Subject of(Sweep sweep) {
            Design design = sweep.design();
            return new Subject(
                    sweep.scenario().name(),
                    sweep.hash(),
                    design.configurations(),
                    design.factors(),
                    design.settings(),
                    design.seeds(),
                    design.limit()
                            .map(limit -> OptionalDouble.of(limit.toNanos() / 1e9))
                            .orElseGet(OptionalDouble::empty));
        }

        public Design design() {
            Optional<Duration> limit = forSeconds.isPresent()
                    ? Optional.of(Duration.ofNanos(Math.round(forSeconds.getAsDouble() * 1e9)))
                    : Optional.empty();
            return new Design(configurations, factors, settings, seeds, limit);
        }

        /// In what it differs, by name; each with what is here and what is there.
        List<String> differences(Subject other) {
            var differences = new ArrayList<String>();
            difference("scenario", scenario, other.scenario, differences);
            difference("scenario's text", sha256.substring(0, 8), other.sha256.substring(0, 8), differences);
            difference("configurations", configurations, other.configurations, differences);
            difference("what is varied", words(factors), words(other.factors), differences);
            difference("what is set", settings, other.settings, differences);
            difference("seeds", words(seeds), words(other.seeds), differences);
            difference("--for", forSeconds, other.forSeconds, differences);
            return differences;
        }

        private static void difference(String what, Object here, Object there, List<String> differences) {
            if (!here.equals(there)) {
                differences.add("%s (there %s, here %s)".formatted(what, there, here));
            }
        }

        private static List<String> words(List<?> values) {
            return values.stream()
                    .map(value -> value instanceof Factor factor
                            ? factor.argument() + "=" + String.join(",", factor.levels())
                            : String.valueOf(value))
                    .toList();
        }
    }

    /// @param unit empty when it has none
    public record Argument(String name, String unit, String description) {}

    /// @param unit empty when it has none
    /// @param perRobot whether each robot has a value of its own, called `<name>.<robot>`
    /// @param better `less`, `more` or `neither`
    /// @param kind [#VALUE] or [#EVENT_TIME]; empty in a file that is older than these, where all are values
    public record MetricEntry(String name, String unit, boolean perRobot, String better, Optional<String> kind) {
        /// Something that there may be nothing of in a run.
        public static final String VALUE = "value";

        /// When something happened [s]; where it did not, it is known that it had not until the run ended.
        public static final String EVENT_TIME = "eventTime";

        public boolean isEventTime() {
            return kind.equals(Optional.of(EVENT_TIME));
        }

        static MetricEntry of(MetricDefinition measured) {
            return new MetricEntry(
                    measured.name(),
                    measured.unit(),
                    measured.perRobot(),
                    measured.better().word(),
                    Optional.of(measured.from() instanceof FirstTime ? EVENT_TIME : VALUE));
        }
    }

    /// What is told of folders of the machine is left out: a sweep is given to others.
    ///
    /// @param started by the clock of the machine, in ISO 8601 and UTC
    /// @param scenario its built-in name, or the file, as typed; of an absolute path the file's name
    /// @param command as typed, word by word; of absolute paths the files' names
    /// @param jobs how many runs at once
    public record Session(String started, String scenario, List<String> command, int jobs, Machine machine) {
        public Session {
            requireNonNull(started);
            scenario = Folders.without(scenario);
            command = command.stream().map(Folders::without).toList();
            requireNonNull(machine);
        }
    }

    /// What it ran on.
    public record Machine(String rsal, String java, String system, int cores) {
        /// @param rsal its version
        public static Machine here(String rsal) {
            return new Machine(
                    rsal,
                    Runtime.version().toString(),
                    "%s %s %s"
                            .formatted(
                                    System.getProperty("os.name"),
                                    System.getProperty("os.version"),
                                    System.getProperty("os.arch")),
                    Runtime.getRuntime().availableProcessors());
        }
    }

    public Manifest { // a file that lacks one of these is none
        requireNonNull(subject);
        requireNonNull(title);
        requireNonNull(scenarioText);
        arguments = List.copyOf(arguments);
        metrics = List.copyOf(metrics);
        sessions = List.copyOf(sessions);
    }

    static Manifest of(Sweep sweep, Session session) {
        return new Manifest(
                FORMAT,
                Subject.of(sweep),
                sweep.scenario().title(),
                sweep.scenario().arguments().stream()
                        .map(p -> new Argument(p.name(), p.unit(), p.description()))
                        .toList(),
                sweep.metrics().stream().map(MetricEntry::of).toList(),
                List.of(session),
                sweep.scenario().text());
    }

    Manifest with(Session session) {
        var more = new ArrayList<>(sessions);
        more.add(session);
        return new Manifest(format, subject, title, arguments, metrics, more, scenarioText);
    }
}
