package rsal.settings;

import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/// What a person wrote can't be used. The message lists every error, a line or two each, from top to bottom, and then
/// what is only warned of, ready to be shown.
public final class InvalidSettings extends RuntimeException {
    private static final long serialVersionUID = 1;

    private final transient List<Problem> problems;
    private final transient List<Problem> warnings;

    public InvalidSettings(List<Problem> problems) {
        this(problems, List.of());
    }

    /// @param warnings what was found besides, and would not be in the way
    public InvalidSettings(List<Problem> problems, List<Problem> warnings) {
        List<Problem> errors = Problem.inReadingOrder(problems);
        List<Problem> besides = Problem.inReadingOrder(warnings);
        super(Stream.concat(
                        errors.stream().map(Problem::toString), besides.stream().map(warning -> "Warning: " + warning))
                .collect(Collectors.joining("\n")));
        this.problems = errors;
        this.warnings = besides;
    }

    public InvalidSettings(Location location, String message, String remedy) {
        this(List.of(new Problem(location, message, remedy)));
    }

    /// The same errors in files beside another one, with paths as a person knows that one: `lab/Hunter.java`.
    ///
    /// @param named where the files are named, by their paths from the folder of that file
    public InvalidSettings beside(Location named) {
        String folder = named.file()
                .substring(
                        0, Math.max(named.file().lastIndexOf('/'), named.file().lastIndexOf('\\')) + 1);
        return folder.isEmpty()
                ? this
                : new InvalidSettings(
                        problems.stream()
                                .map(problem -> problem.in(folder, named))
                                .toList(),
                        warnings.stream()
                                .map(problem -> problem.in(folder, named))
                                .toList());
    }

    /// The errors, file by file, each from top to bottom.
    public List<Problem> problems() {
        return problems;
    }

    /// What was found besides the errors, and would not be in the way.
    public List<Problem> warnings() {
        return warnings;
    }
}
