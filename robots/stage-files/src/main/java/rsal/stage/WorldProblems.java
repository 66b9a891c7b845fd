package rsal.stage;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;
import rsal.settings.Problem;
import rsal.settings.Suggestion;

/// What is wrong with a world (errors), and what of it has no effect here (warnings). Each thing is told once for
/// each place, however often a macro repeats it, and neither list grows without bound.
public final class WorldProblems {
    private static final int MAX_ERRORS = 50;
    private static final int MAX_WARNINGS = 500;
    private static final int MAX_GUESSES = 1000;
    private static final int MAX_CANDIDATES = 5000; // of a guess
    private static final int MAX_WORD = 64; // letters of a candidate

    private final List<Problem> errors = new ArrayList<>();
    private final List<Problem> warnings = new ArrayList<>();
    private final Set<Object> reported = new HashSet<>();
    private final Set<Location> spoiled = new HashSet<>();
    private int omitted;
    private int guesses;

    /// @throws InvalidSettings with all errors so far when there are too many to go on
    public void error(Location location, String message, String remedy) {
        var problem = new Problem(location, message, remedy);
        if (!spoiled.contains(location) && reported.add(problem)) {
            errors.add(problem);
        }
        if (errors.size() >= MAX_ERRORS) {
            throwIfAny();
        }
    }

    /// What stands there was told to be wrong; whatever else would be said of it only follows from that.
    void spoil(Location location) {
        spoiled.add(location);
    }

    boolean isSpoiled(Location location) {
        return spoiled.contains(location);
    }

    /// Nothing more can be read.
    public InvalidSettings fatal(Location location, String message, String remedy) {
        errors.add(new Problem(location, message, remedy));
        return new InvalidSettings(errors, warnings(location.file()));
    }

    public void warn(Location location, String message, String remedy) {
        var problem = new Problem(location, message, remedy);
        if (reported.size() < 100 * MAX_WARNINGS && reported.add(problem)) {
            if (warnings.size() < MAX_WARNINGS) {
                warnings.add(problem);
            } else {
                omitted++;
            }
        }
    }

    /// The known word that a person may have meant; empty when none is close, or after so many guesses that
    /// another would only cost time.
    public Optional<String> guess(String read, Collection<String> known) {
        if (++guesses > MAX_GUESSES) {
            return Optional.empty();
        }
        List<String> candidates = known.stream()
                .filter(word -> word.length() <= MAX_WORD)
                .limit(MAX_CANDIDATES)
                .toList();
        return Suggestion.closest(read, candidates);
    }

    /// A guess as a sentence.
    public String maybe(String read, Collection<String> known, String otherwise) {
        return guess(read, known)
                .map(word -> "Maybe '%s' was meant?".formatted(word))
                .orElse(otherwise);
    }

    /// A text as messages quote it.
    public static String shortened(String text) {
        return text.length() <= 80 ? text : text.substring(0, 77) + "...";
    }

    /// @throws InvalidSettings with all errors, those of a file in the order of its lines, and all warnings so far
    public void throwIfAny() {
        if (!errors.isEmpty()) {
            List<String> files = errors.stream()
                    .map(error -> error.location().file())
                    .distinct()
                    .toList();
            throw new InvalidSettings(
                    errors.stream()
                            .sorted(Comparator.comparingInt((Problem error) ->
                                            files.indexOf(error.location().file()))
                                    .thenComparingInt(error -> error.location().line())
                                    .thenComparingInt(error -> error.location().column()))
                            .toList(),
                    warnings(files.getFirst()));
        }
    }

    /// @param file the world's, for what is said of all of it
    public List<Problem> warnings(String file) {
        var all = new ArrayList<>(warnings);
        if (omitted > 0) {
            all.add(new Problem(Location.of(file), "There are %d more warnings.".formatted(omitted), ""));
        }
        return List.copyOf(all);
    }
}
