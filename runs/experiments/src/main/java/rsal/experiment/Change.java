package rsal.experiment;

import java.util.ArrayList;
import java.util.List;

/// Another level of something that is varied, with all else equal.
public record Change(Factor factor, String from, String to) {
    private static final int MOST_IN_PAIRS = 4; // levels; with more the pairs would be too many to read

    /// Those that a report compares: each two levels where there are few, else the first with each other one.
    static List<Change> of(Factor factor) {
        List<String> levels = factor.levels();
        var changes = new ArrayList<Change>();
        for (int i = 0; i < (levels.size() <= MOST_IN_PAIRS ? levels.size() : 1); i++) {
            for (String to : levels.subList(i + 1, levels.size())) {
                changes.add(new Change(factor, levels.get(i), to));
            }
        }
        return changes;
    }

    /// Those from the first level.
    static List<Change> fromFirst(Factor factor) {
        return of(factor).stream()
                .filter(change -> change.from().equals(factor.levels().getFirst()))
                .toList();
    }

    /// `hunters 2 → 3`
    @Override
    public String toString() {
        return "%s %s → %s".formatted(factor.argument(), from, to);
    }
}
