package rsal.metric;

import java.util.List;
import java.util.Locale;
import java.util.regex.Pattern;

/// A number that a run has at any instant, as conditions and metrics write it: `time`, `caught(prey)`,
/// `distance(prey, hunter)`.
///
/// @param word letters, digits, `_` and `-`, a letter first
/// @param unit as `m`; empty for a number without one
/// @param description for people, in a few words
/// @param names what stands in its parentheses; empty when it is of the whole run
/// @param namesAreOptional whether it may be written without parentheses, too
/// @param countsAll whether it counts robots of a role or things of a group, so that a condition can ask for
///         all of them: `allCaught(prey)`
public record QuantityType(
        String word,
        String unit,
        String description,
        List<NameKind> names,
        boolean namesAreOptional,
        boolean countsAll) {
    /// What a word is.
    public static final Pattern WORD = Pattern.compile("\\p{Alpha}[\\w-]*");

    public QuantityType {
        names = List.copyOf(names);
        checkWord(word);
        if (countsAll && names.size() != 1) {
            throw new IllegalArgumentException(
                    "Quantity '%s' counts all of one name, not of %s.".formatted(word, names));
        }
    }

    static void checkWord(String word) {
        if (!WORD.matcher(word).matches()) {
            throw new IllegalArgumentException(
                    "'%s' can't be the word for a quantity: it must be letters, digits, '_' and '-'.".formatted(word));
        }
    }

    public static QuantityType of(String word, String unit, String description, NameKind... names) {
        return new QuantityType(word, unit, description, List.of(names), false, false);
    }

    /// The same, written without parentheses, too.
    public QuantityType orWithoutNames() {
        return new QuantityType(word, unit, description, names, true, countsAll);
    }

    /// The same with a condition that asks for all: [#wordForAll].
    public QuantityType countingAll() {
        return new QuantityType(word, unit, description, names, namesAreOptional, true);
    }

    /// `allCaught` of `caught`.
    public String wordForAll() {
        return "all" + word.substring(0, 1).toUpperCase(Locale.ROOT) + word.substring(1);
    }
}
