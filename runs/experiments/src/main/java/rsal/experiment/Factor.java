package rsal.experiment;

import static java.util.Objects.requireNonNull;

import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;
import rsal.settings.Parameter;
import rsal.settings.Suggestion;

/// An argument of a scenario that an experiment varies, with its levels.
///
/// @param argument by name
/// @param levels as typed, each once; effects are told beside the first
public record Factor(String argument, List<String> levels) {
    private static final int MOST_LEVELS = 10_000;
    private static final String NUMBER =
            "([-+]?[0-9.]{1,30}(?:[eE][-+]?[0-9]{1,2})?)"; // no more digits when written out
    private static final Pattern RANGE = Pattern.compile(NUMBER + ":" + NUMBER + "(?::" + NUMBER + ")?");

    public Factor {
        requireNonNull(argument);
        levels = List.copyOf(levels);
    }

    /// Reads levels as typed: `1,2,4`, or, of numbers, ranges with both ends: `1:10:3` is 1, 4, 7, 10, and
    /// `1:4` goes by 1.
    ///
    /// @param known arguments of the scenario
    /// @throws InvalidSettings when there is no such argument, or with all levels that it can't have
    public static Factor read(String argument, String typed, List<Parameter<?>> known) {
        Location at = Location.of("--vary %s=%s".formatted(argument, typed));
        Parameter<?> parameter = known.stream()
                .filter(p -> p.name().equals(argument))
                .findFirst()
                .orElseThrow(() -> new InvalidSettings(
                        at,
                        "The scenario has no argument '%s'.".formatted(argument),
                        Suggestion.among(
                                argument, known.stream().map(Parameter::name).toList())));
        var levels = new ArrayList<String>();
        for (String part : Arrays.asList(typed.split(",", -1))) {
            levels.addAll(isNumber(parameter) ? range(part.strip(), at) : List.of(part.strip()));
        }
        var seen = new HashSet<Object>();
        for (String level : levels) {
            try {
                if (!seen.add(parameter.parse(level))) {
                    throw new InvalidSettings(at, "Level '%s' is there twice.".formatted(level), "");
                }
            } catch (IllegalArgumentException e) {
                throw new InvalidSettings(at, String.valueOf(e.getMessage()), "");
            }
        }
        return new Factor(argument, levels);
    }

    private static boolean isNumber(Parameter<?> parameter) {
        return parameter.kind() == Parameter.Kind.NUMBER || parameter.kind() == Parameter.Kind.INTEGER;
    }

    /// In decimals, so that 0.1:0.3:0.1 ends where people expect.
    private static List<String> range(String typed, Location at) {
        Matcher range = RANGE.matcher(typed);
        if (!range.matches()) {
            return List.of(typed);
        }
        BigDecimal from;
        BigDecimal to;
        BigDecimal step;
        try {
            from = new BigDecimal(range.group(1));
            to = new BigDecimal(range.group(2));
            step = range.group(3) == null ? BigDecimal.ONE : new BigDecimal(range.group(3));
        } catch (NumberFormatException _) {
            throw new InvalidSettings(at, "'%s' is not a range of numbers, like 1:10:3.".formatted(typed), "");
        }
        if (step.signum() == 0 || to.compareTo(from) * step.signum() < 0) {
            throw new InvalidSettings(
                    at,
                    "Range '%s' never gets from %s to %s by steps of %s.".formatted(typed, from, to, step),
                    "It is FROM:TO:STEP, like 1:10:3.");
        }
        var levels = new ArrayList<String>();
        for (BigDecimal level = from; level.compareTo(to) * step.signum() <= 0; level = level.add(step)) {
            if (levels.size() == MOST_LEVELS) {
                throw new InvalidSettings(at, "Range '%s' has more than %d levels.".formatted(typed, MOST_LEVELS), "");
            }
            levels.add(level.signum() == 0 ? "0" : level.stripTrailingZeros().toPlainString());
        }
        return levels;
    }
}
