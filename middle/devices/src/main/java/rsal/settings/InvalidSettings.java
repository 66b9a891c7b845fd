package rsal.settings;

import java.util.List;
import java.util.stream.Collectors;

/// What a person wrote can't be used. The message lists every mistake, a line or two each, ready to be shown.
public final class InvalidSettings extends RuntimeException {
    private static final long serialVersionUID = 1;

    private final transient List<Problem> problems;

    public InvalidSettings(List<Problem> problems) {
        super(problems.stream().map(Problem::toString).collect(Collectors.joining("\n")));
        this.problems = List.copyOf(problems);
    }

    public InvalidSettings(Location location, String message, String remedy) {
        this(List.of(new Problem(location, message, remedy)));
    }

    public List<Problem> problems() {
        return problems;
    }
}
