package rsal.settings;

import java.util.ArrayList;
import java.util.List;

/// Collects the mistakes of a document, so that its author hears of all of them at once.
public final class Problems {
    private final List<Problem> problems = new ArrayList<>();

    public void add(Location location, String message, String remedy) {
        problems.add(new Problem(location, message, remedy));
    }

    public void add(Problem problem) {
        problems.add(problem);
    }

    public boolean isEmpty() {
        return problems.isEmpty();
    }

    public List<Problem> all() {
        return List.copyOf(problems);
    }

    /// @throws InvalidSettings when there is any
    public void throwIfAny() {
        if (!problems.isEmpty()) {
            throw new InvalidSettings(problems);
        }
    }
}
