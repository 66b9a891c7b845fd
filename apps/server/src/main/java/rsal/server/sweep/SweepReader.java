package rsal.server.sweep;

import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import rsal.experiment.Design;
import rsal.experiment.Factor;
import rsal.experiment.SeedRange;
import rsal.experiment.Sweep;
import rsal.scenario.Scenario;
import rsal.server.message.Messages.FieldError;
import rsal.server.message.Messages.SweepSize;
import rsal.server.message.Messages.SweepWish;
import rsal.server.message.Refusal;
import rsal.server.scenario.ScenarioCatalog;
import rsal.settings.InvalidSettings;
import rsal.settings.Problem;

/// Plans a sweep as somebody wishes. Goes on after an error, so that all are reported together, each with the
/// field that it was typed into.
public final class SweepReader {
    static final int MOST_RUNS = 10_000;
    static final int MOST_COMBINATIONS = 200; // each has a row in the page

    private static final double LONGEST = 1e9; // [s], 31 years
    private static final Pattern ARGUMENT = Pattern.compile("--(?:set|vary) ([^=]+)=.*", Pattern.DOTALL);

    private static final Pattern OPTION = Pattern.compile("--[a-z]");
    private static final Pattern BETWEEN_SENTENCES = Pattern.compile("(?<=\\.)\\s+");

    private final SweepWish wish;
    private final Scenario scenario;
    private final List<FieldError> errors = new ArrayList<>();

    /// @param catalog where scenarios are
    /// @throws Refusal when the scenario is not there, or can't be read
    SweepReader(ScenarioCatalog catalog, SweepWish wish) {
        this.wish = wish;
        try {
            scenario = catalog.load(wish.scenario());
        } catch (InvalidSettings e) {
            throw refusal(e);
        }
    }

    /// How large it would be; nothing is planned yet.
    ///
    /// @throws Refusal with every error that can be found without
    SweepSize size() {
        Design design = design();
        return new SweepSize(design.combinations().size(), design.seeds().size(), design.runs());
    }

    /// @throws Refusal with every error
    Sweep sweep() {
        Design design = design();
        try {
            return Sweep.of(scenario, design);
        } catch (InvalidSettings e) {
            throw refusal(e);
        }
    }

    private Design design() {
        var factors = new ArrayList<Factor>();
        var settings = new LinkedHashMap<String, String>();
        for (Map.Entry<String, String> typed : wish.arguments().entrySet()) {
            try {
                Factor factor = Factor.read(typed.getKey(), typed.getValue(), scenario.arguments());
                if (factor.levels().size() == 1) {
                    settings.put(factor.argument(), factor.levels().getFirst());
                } else {
                    factors.add(factor);
                }
            } catch (InvalidSettings e) {
                e.problems().forEach(problem -> errors.add(error(problem)));
            }
        }
        if (wish.configurations().isEmpty()) {
            errors.add(new FieldError("configurations", "A sweep needs a configuration.", ""));
        }
        var design = new Design(wish.configurations(), factors, settings, seeds(), limit());
        tooLarge(design).ifPresent(errors::add);
        if (!errors.isEmpty()) {
            throw refusal(errors);
        }
        return design;
    }

    /// What is wrong with a sweep that the page can't show. Asked before anything as long as that is made.
    static Optional<FieldError> tooLarge(Design design) {
        long combinations = design.runs() / Math.max(1, design.seeds().size());
        if (combinations > MOST_COMBINATIONS) {
            return Optional.of(new FieldError(
                    "",
                    "These are %s combinations; the page takes at most %d."
                            .formatted(
                                    combinations > Integer.MAX_VALUE ? "far too many" : combinations,
                                    MOST_COMBINATIONS),
                    "Vary less, or use 'rsal sweep' in a terminal."));
        }
        if (design.runs() > MOST_RUNS) {
            return Optional.of(new FieldError(
                    "",
                    "These are %d runs; the page takes at most %d.".formatted(design.runs(), MOST_RUNS),
                    "Take fewer seeds, or use 'rsal sweep' in a terminal."));
        }
        return Optional.empty();
    }

    /// One when it is wrong, for the other errors to be found.
    private List<Long> seeds() {
        String typed = wish.seeds().strip();
        try {
            return SeedRange.parse(typed).seeds();
        } catch (IllegalArgumentException _) {
            errors.add(new FieldError(
                    "seeds",
                    "'seeds' must be how many, at least 1, or a range that goes up, not '%s'."
                            .formatted(Refusal.shortened(typed)),
                    "Try 10, or 101-130."));
            return List.of(1L);
        }
    }

    private Optional<Duration> limit() {
        String typed = wish.limit().strip();
        if (typed.isEmpty()) {
            return Optional.empty();
        }
        double seconds;
        try {
            seconds = Double.parseDouble(typed);
        } catch (NumberFormatException _) {
            seconds = Double.NaN;
        }
        if (seconds > 0 && seconds <= LONGEST) {
            return Optional.of(Duration.ofNanos(Math.round(seconds * 1e9)));
        }
        errors.add(new FieldError(
                "limit",
                "'limit' must be a number of seconds above 0, not '%s'.".formatted(Refusal.shortened(typed)),
                "Try 60."));
        return Optional.empty();
    }

    private static Refusal refusal(InvalidSettings e) {
        return refusal(e.problems().stream().map(SweepReader::error).toList());
    }

    private static Refusal refusal(List<FieldError> errors) {
        return new Refusal(422, "This can't be swept as it is.", List.copyOf(errors));
    }

    /// Without the sentences that say which option of a command would help: the form has fields.
    public static String inForm(String remedy) {
        return BETWEEN_SENTENCES
                .splitAsStream(remedy)
                .filter(sentence -> !OPTION.matcher(sentence).find())
                .collect(Collectors.joining(" "));
    }

    private static FieldError error(Problem problem) {
        Matcher argument = ARGUMENT.matcher(problem.location().toString());
        String where = argument.matches()
                ? "arguments." + argument.group(1)
                : problem.location().toString();
        return new FieldError(where, problem.message(), inForm(problem.remedy()));
    }
}
