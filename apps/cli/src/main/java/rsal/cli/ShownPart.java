package rsal.cli;

import java.util.Optional;
import rsal.robot.RobotModels;
import rsal.settings.Location;

/// A built-in robot model or part, for `rsal show` and `rsal list`.
///
/// @param kind `model` or `part`
/// @param file as one of one's own would be written
record ShownPart(String name, String kind, String title, String file) {
    static Optional<ShownPart> of(String name) {
        return RobotModels.source(name).map(file -> {
            boolean model = RobotModels.builtIn().contains(name);
            return new ShownPart(name, model ? "model" : "part", model ? title(name) : firstSentence(file), file);
        });
    }

    private static String title(String model) {
        return new RobotModels(rsal.settings.FileSource.disk())
                .read(model, Location.of(model))
                .title();
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
        return "%s: a robot %s, %s%n%s%n%n%s"
                .formatted(
                        name,
                        kind,
                        title,
                        kind.equals("model")
                                ? "In a scenario: robots: {NAME: {model: %s}}. A model of your own is a file like this:"
                                        .formatted(name)
                                : "In a scenario: devices: {DEVICE: %s}, where a model has a mount. A part of your own is a file like this:"
                                        .formatted(name),
                        file);
    }
}
