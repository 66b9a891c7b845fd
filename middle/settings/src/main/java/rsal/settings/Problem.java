package rsal.settings;

import java.util.Comparator;
import java.util.List;
import java.util.regex.Pattern;

/// One error in a file: where, what was read and expected, and what to try.
///
/// @param message a sentence naming the thing and its value
/// @param remedy what to try; empty when nobody can tell
public record Problem(Location location, String message, String remedy) {
    private static final Pattern CONTROL = Pattern.compile("[\\p{Cc}&&[^\n]]");

    /// As a person reads: file by file, in the order in which they are met, and each from top to bottom.
    static List<Problem> inReadingOrder(List<Problem> problems) {
        List<String> files = problems.stream()
                .map(problem -> problem.location.file())
                .distinct()
                .toList();
        return problems.stream()
                .sorted(Comparator.comparingInt((Problem problem) -> files.indexOf(problem.location.file()))
                        .thenComparingInt(problem -> problem.location.line())
                        .thenComparingInt(problem -> problem.location.column()))
                .toList();
    }

    /// In a file of a folder, unless it is in the one that names it, or its path is whole.
    Problem in(String folder, Location named) {
        String file = location.file();
        return file.equals(named.file()) || file.startsWith("/") || file.startsWith(folder)
                ? this
                : new Problem(new Location(folder + file, location.line(), location.column()), message, remedy);
    }

    /// For people: what a file has of control characters is written out, as terminals would obey it.
    @Override
    public String toString() {
        String text = location + ": " + message + (remedy.isEmpty() ? "" : "\n    " + remedy);
        return CONTROL.matcher(text)
                .replaceAll(match -> "\\\\u%04x".formatted((int) match.group().charAt(0)));
    }
}
