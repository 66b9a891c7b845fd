package rsal.experiment;

import java.math.BigDecimal;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.HexFormat;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import rsal.scenario.RunOptions;
import rsal.scenario.RunPlan;
import rsal.scenario.RunPlan.Clock;
import rsal.scenario.RunPlan.MetricDefinition;
import rsal.scenario.Scenario;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;
import rsal.settings.Problem;

/// An experiment with everything decided and nothing started: the same scenario again and again, with all
/// that its design combines. Immutable.
public final class Sweep {
    private static final int MOST_RUNS = 1_000_000;

    private final Scenario scenario;
    private final Design design;
    private final List<Trial> trials;
    private final List<Problem> notes;
    private final Map<Integer, Map<String, Object>> arguments = new LinkedHashMap<>(); // by combination
    private final Map<String, MetricDefinition> metrics = new LinkedHashMap<>(); // by name
    private final Set<String> values = new LinkedHashSet<>(); // what those of metrics are called

    private Sweep(Scenario scenario, Design design) {
        this.scenario = scenario;
        this.design = design;
        var errors = new LinkedHashSet<Problem>();
        var found = new LinkedHashSet<Problem>();
        for (Combination combination : design.combinations()) {
            try {
                RunPlan plan = plan(combination, design.seeds().getFirst(), Double.POSITIVE_INFINITY);
                check(plan, errors);
                found.addAll(plan.scene().warnings());
                found.addAll(plan.notes());
                arguments.put(combination.number(), plan.arguments());
                plan.metrics().forEach(measured -> {
                    metrics.putIfAbsent(measured.name(), measured);
                    values.addAll(measured.names(plan.robots()));
                });
            } catch (InvalidSettings e) {
                errors.addAll(e.problems());
            }
        }
        if (!errors.isEmpty()) {
            throw new InvalidSettings(List.copyOf(errors));
        }
        this.trials = design.trials();
        this.notes = List.copyOf(found);
    }

    /// Plans a run of every combination, with the first seed. Files that the scenario names are read for that, and
    /// never again: all runs are of what they were then.
    ///
    /// @throws InvalidSettings with every error of the scenario and the design
    public static Sweep of(Scenario scenario, Design design) {
        checkSize(scenario, design);
        return new Sweep(scenario.kept(), design);
    }

    private static void checkSize(Scenario scenario, Design design) {
        if (design.runs() > MOST_RUNS) {
            throw new InvalidSettings(
                    scenario.location(),
                    "That would be more than %d runs.".formatted(MOST_RUNS),
                    "Vary less, or in several sweeps.");
        }
        checkOnce("--configuration", design.configurations());
        checkOnce("--vary", design.factors().stream().map(Factor::argument).toList());
        for (Factor factor : design.factors()) {
            if (design.settings().containsKey(factor.argument())) {
                throw new InvalidSettings(
                        Location.of("--set %s=%s"
                                .formatted(factor.argument(), design.settings().get(factor.argument()))),
                        "Argument '%s' is varied, too.".formatted(factor.argument()),
                        "Use either --set or --vary for it.");
            }
        }
    }

    private static void checkOnce(String option, List<String> names) {
        var seen = new HashSet<String>();
        for (String name : names) {
            if (!seen.add(name)) {
                throw new InvalidSettings(Location.of(option), "'%s' is there twice.".formatted(name), "");
            }
        }
    }

    private void check(RunPlan plan, Set<Problem> errors) {
        String name = "Configuration '%s'".formatted(plan.configuration());
        if (plan.clock() == Clock.WALL) {
            errors.add(new Problem(
                    scenario.location(),
                    name + " runs in real time.",
                    "Only runs in simulated time can be compared: they don't disturb each other, and the same seed"
                            + " gives the same run. Name others by --configuration."));
        } else if (plan.stops().isEmpty() && design.limit().isEmpty()) {
            errors.add(new Problem(
                    scenario.location(), name + " has no end of its own.", "Set a limit by --for SECONDS."));
        }
    }

    public Scenario scenario() {
        return scenario;
    }

    public Design design() {
        return design;
    }

    /// The command that does the same, word by word. Its seeds go up one by one.
    ///
    /// @param named the scenario: its built-in name, or its file
    /// @param jobs how many runs at once
    /// @param out where the rows are to be kept
    public List<String> command(String named, int jobs, Path out) {
        var words = new ArrayList<>(
                List.of("rsal", "sweep", named, "--configuration", String.join(",", design.configurations())));
        design.factors()
                .forEach(factor ->
                        words.addAll(List.of("--vary", factor.argument() + "=" + String.join(",", factor.levels()))));
        design.settings().forEach((name, value) -> words.addAll(List.of("--set", name + "=" + value)));
        words.add("--seeds=%d-%d"
                .formatted(design.seeds().getFirst(), design.seeds().getLast())); // in one word, as it may be below 0
        design.limit().ifPresent(limit -> words.addAll(List.of("--for", seconds(limit))));
        words.addAll(List.of("--jobs", Integer.toString(jobs), "--out", out.toString()));
        return List.copyOf(words);
    }

    private static String seconds(Duration limit) {
        return BigDecimal.valueOf(limit.toNanos(), 9).stripTrailingZeros().toPlainString();
    }

    /// In the order in which they begin.
    public List<Trial> trials() {
        return trials;
    }

    /// What is right, but may not be what people think, each only once.
    public List<Problem> notes() {
        return notes;
    }

    /// What is measured in any of its runs, in the scenario's order.
    public List<MetricDefinition> metrics() {
        return List.copyOf(metrics.values());
    }

    /// What the values of metrics are called in any of its runs.
    List<String> valueNames() {
        return List.copyOf(values);
    }

    /// All of the scenario's, as they are in the runs of a combination: Double, Long, String or Boolean.
    Map<String, Object> arguments(Combination combination) {
        return arguments.getOrDefault(combination.number(), Map.of());
    }

    /// Decides all of a run, which goes as fast as it can.
    ///
    /// @throws InvalidSettings when it can't be with its seed: perhaps no place was found for a robot
    RunPlan plan(Trial trial) {
        return plan(trial, Double.POSITIVE_INFINITY);
    }

    /// The same; it comes out the same at any speed.
    ///
    /// @param speed times real time
    /// @throws InvalidSettings the same
    public RunPlan plan(Trial trial, double speed) {
        return plan(trial.combination(), trial.seed(), speed);
    }

    private RunPlan plan(Combination combination, long seed, double speed) {
        var typed = new LinkedHashMap<>(design.settings());
        typed.putAll(combination.levels());
        RunOptions options = RunOptions.NONE
                .withConfiguration(combination.configuration())
                .withArguments(typed)
                .withSeed(seed)
                .withSpeed(speed);
        return scenario.plan(design.limit().map(options::withLimit).orElse(options));
    }

    /// SHA-256 of the scenario's text, in hexadecimal.
    String hash() {
        try {
            byte[] text = scenario.text().getBytes(StandardCharsets.UTF_8);
            return HexFormat.of().formatHex(MessageDigest.getInstance("SHA-256").digest(text));
        } catch (NoSuchAlgorithmException e) {
            throw new AssertionError("Every Java has SHA-256.", e);
        }
    }
}
