package rsal.settings;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;

/// Collects the errors of a document, so that its author hears of all of them at once.
public final class Problems {
    private final List<Problem> problems = new ArrayList<>();
    private final Set<Problem> warnings = new LinkedHashSet<>();
    private final Set<Location> settled = new HashSet<>();
    private final int most;

    public Problems() {
        this(Integer.MAX_VALUE);
    }

    /// @param most after which nothing more is looked for
    public Problems(int most) {
        this.most = most;
    }

    public void add(Location location, String message, String remedy) {
        add(new Problem(location, message, remedy));
    }

    /// @throws InvalidSettings with all of them when they are as many as can be
    public void add(Problem problem) {
        if (!settled.contains(problem.location())) {
            problems.add(problem);
        }
        if (problems.size() >= most) {
            throwIfAny();
        }
    }

    /// Adds those of something that was read on the way, with what is only warned of there.
    public void addAll(InvalidSettings errors) {
        warnings.addAll(errors.warnings());
        errors.problems().forEach(this::add);
    }

    /// Notes what is no error, to be told together with those that are.
    public void warn(Problem warning) {
        warnings.add(warning);
    }

    /// What was noted turned out to follow from something else that is told.
    void withdraw(Problem problem) {
        problems.remove(problem);
    }

    /// Enough has been said about what stands at a place: what else is wrong with it follows from that.
    public void settle(Location location) {
        settled.add(location);
    }

    public boolean isEmpty() {
        return problems.isEmpty();
    }

    public List<Problem> all() {
        return List.copyOf(problems);
    }

    /// What is only warned of.
    public List<Problem> warnings() {
        return List.copyOf(warnings);
    }

    /// @throws InvalidSettings when there is any
    public void throwIfAny() {
        if (!problems.isEmpty()) {
            List<Problem> errors = problems.stream().distinct().toList(); // many may have read the same place
            throw new InvalidSettings(errors, List.copyOf(warnings));
        }
    }
}
