package rsal.settings;

import java.util.Collection;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;

/// Guesses what a person meant.
public final class Suggestion {
    private static final int MOST = 40; // words to name
    private static final int MOST_SIMILAR = 3; // of which any may be meant
    private static final int LEAST = 3; // letters of a word for short

    private Suggestion() {}

    /// "Maybe 'catchDistance' was meant?" when a known word is close to what was read, or several that are equally
    /// close; the new name of a former one; else the list of the known words, the first of them if there are many.
    public static String among(String read, Collection<String> known) {
        return FormerNames.replacement(read, known)
                .map(word -> "'%s' is now called '%s'.".formatted(read, word))
                .or(() -> Optional.of(similar(read, known))
                        .filter(words -> !words.isEmpty())
                        .map(words -> words.stream()
                                .limit(MOST_SIMILAR)
                                .collect(Collectors.joining("' or '", "Maybe '", "' was meant?"))))
                .orElseGet(() -> known.isEmpty() ? "Nothing is known here." : "Known are: " + listed(known) + ".");
    }

    private static String listed(Collection<String> known) {
        String first = known.stream().limit(MOST).collect(Collectors.joining(", "));
        return known.size() > MOST ? "%s, and %d more".formatted(first, known.size() - MOST) : first;
    }

    /// The known word that replaces a former name; or that takes the fewest changes, if that is at most a third of its
    /// letters; else the only one that begins so, which somebody may call it for short.
    public static Optional<String> closest(String read, Collection<String> known) {
        return FormerNames.replacement(read, known)
                .or(() -> similar(read, known).stream().findFirst());
    }

    /// Those that are equally near, in their order.
    private static List<String> similar(String read, Collection<String> known) {
        String lower = read.toLowerCase(Locale.ROOT);
        if (lower.length() > 100) {
            return List.of();
        }
        List<Candidate> near = known.stream()
                .map(word -> new Candidate(word, distance(lower, word.toLowerCase(Locale.ROOT))))
                .filter(c -> c.distance <= Math.max(1, c.word.length() / 3))
                .toList();
        int least = near.stream().mapToInt(Candidate::distance).min().orElse(0);
        return near.isEmpty()
                ? whole(lower, known)
                : near.stream()
                        .filter(c -> c.distance == least)
                        .map(Candidate::word)
                        .distinct()
                        .toList();
    }

    private static List<String> whole(String beginning, Collection<String> known) {
        List<String> words = known.stream()
                .filter(word -> word.toLowerCase(Locale.ROOT).startsWith(beginning))
                .limit(2)
                .toList();
        return beginning.length() >= LEAST && words.size() == 1 ? words : List.of();
    }

    private record Candidate(String word, int distance) {}

    /// Optimal string alignment: insertions, deletions, replacements, and swaps of neighbours count 1 each.
    private static int distance(String a, String b) {
        int[][] d = new int[a.length() + 1][b.length() + 1];
        for (int i = 0; i <= a.length(); i++) {
            for (int j = 0; j <= b.length(); j++) {
                if (i == 0 || j == 0) {
                    d[i][j] = i + j;
                    continue;
                }
                int change = a.charAt(i - 1) == b.charAt(j - 1) ? 0 : 1;
                d[i][j] = Math.min(Math.min(d[i - 1][j] + 1, d[i][j - 1] + 1), d[i - 1][j - 1] + change);
                if (i > 1 && j > 1 && a.charAt(i - 1) == b.charAt(j - 2) && a.charAt(i - 2) == b.charAt(j - 1)) {
                    d[i][j] = Math.min(d[i][j], d[i - 2][j - 2] + 1);
                }
            }
        }
        return d[a.length()][b.length()];
    }
}
