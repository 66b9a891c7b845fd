package rsal.cli.show;

import java.nio.charset.StandardCharsets;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import rsal.model.RobotModels;
import rsal.robot.RobotModel;
import rsal.robot.RobotModel.Part;
import rsal.settings.FileSource;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;
import rsal.settings.Problem;

/// A robot model or part, one that comes with the program or a person's own, for `rsal show` and `rsal list`.
///
/// @param kind `model` or `part`
/// @param file its text
/// @param own whether it is a person's own file
public record ShownPart(String name, String kind, String title, String file, boolean own) {
    private static final int MOST_BYTES = 1_000_000;

    /// @return empty when the name is that of neither
    /// @throws InvalidSettings with what is wrong in a person's own file
    public static Optional<ShownPart> of(String name) {
        Optional<String> source = RobotModels.source(name);
        if (source.isPresent()) {
            boolean model = RobotModels.builtIn().contains(name);
            String title = model ? models(name).read(name, Location.of(name)).title() : firstSentence(source.get());
            return Optional.of(new ShownPart(name, model ? "model" : "part", title, source.get(), false));
        }
        return FileKind.of(name).flatMap(kind -> switch (kind) {
            case MODEL -> Optional.of(own(name, "model", model(name).title()));
            case PART -> Optional.of(own(name, "part", "a " + part(name).makes().getSimpleName()));
            default -> Optional.empty();
        });
    }

    private static ShownPart own(String name, String kind, String title) {
        byte[] text = FileSource.disk().read(name, MOST_BYTES, Location.of(name));
        return new ShownPart(name, kind, title, new String(text, StandardCharsets.UTF_8), true);
    }

    /// A person's own model, with parts that are files beside it.
    static RobotModel model(String file) {
        return located(file, () -> models(file).read(lastName(file), Location.of(file)));
    }

    /// A person's own part.
    static Part part(String file) {
        return located(file, () -> models(file).readPart(lastName(file), Location.of(file)));
    }

    private static RobotModels models(String file) {
        try {
            return new RobotModels(FileSource.folder(
                    Path.of(file).toAbsolutePath().resolveSibling(".").normalize()));
        } catch (InvalidPathException e) {
            throw new InvalidSettings(Location.of(file), "This can't be a file: %s.".formatted(e.getReason()), "");
        }
    }

    private static String lastName(String path) {
        return path.substring(path.lastIndexOf('/') + 1);
    }

    /// What is wrong in files of a folder is where the person knows them to be.
    private static <T> T located(String file, java.util.function.Supplier<T> read) {
        String folder = file.substring(0, file.lastIndexOf('/') + 1);
        try {
            return read.get();
        } catch (InvalidSettings e) {
            throw new InvalidSettings(in(folder, e.problems()), in(folder, e.warnings()));
        }
    }

    private static List<Problem> in(String folder, List<Problem> problems) {
        return problems.stream()
                .map(problem -> {
                    Location at = problem.location();
                    String path = at.file().startsWith(folder) ? at.file() : folder + at.file();
                    return new Problem(new Location(path, at.line(), at.column()), problem.message(), problem.remedy());
                })
                .toList();
    }

    /// Of the comment that each part's file begins with.
    private static String firstSentence(String file) {
        String comment = file.lines()
                .takeWhile(line -> line.startsWith("#"))
                .map(line -> line.substring(1).strip())
                .reduce((one, next) -> one + " " + next)
                .orElse("");
        int end = comment.indexOf(". ");
        return end < 0 ? comment.replaceAll("\\.$", "") : comment.substring(0, end);
    }

    /// For people.
    String text() {
        return "%s: a robot %s, %s%n%s%s%n%n%s".formatted(name, kind, title, use(), own ? "" : " " + likeThis(), file);
    }

    private String use() {
        return kind.equals("model")
                ? "In a scenario: robots: {NAME: {model: %s}}.".formatted(name)
                : "In a scenario: devices: {DEVICE: %s}, where a model has a mount.".formatted(name);
    }

    private String likeThis() {
        return "A %s of your own is a file like this:".formatted(kind);
    }
}
