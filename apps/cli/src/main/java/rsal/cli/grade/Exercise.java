package rsal.cli.grade;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import rsal.cli.show.ShownAgent;
import rsal.cli.terminal.Destination;
import rsal.settings.FileSource;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;
import rsal.settings.Suggestion;
import rsal.settings.Value;
import rsal.yaml.Yaml;

/// What students were asked for: an agent for a scenario that the teacher has.
///
/// @param folder with the teacher's files
/// @param scenario the name of its file there
/// @param agent the name of the file that each student hands in
record Exercise(Path folder, String scenario, String agent) {
    private static final int MOST_BYTES = 64 << 20;
    private static final int DEEPEST = 4; // folders in which a student's file may lie, one in another

    /// A student handed in no such file.
    static final class Missing extends Exception {
        private static final long serialVersionUID = 1;

        Missing(String message) {
            super(message);
        }
    }

    /// @param agent null for the one that the scenario names
    static Exercise of(String scenario, @Nullable String agent) {
        Path given = Destination.path(scenario);
        if (!Files.isRegularFile(given)) {
            throw new InvalidSettings(
                    Location.of(scenario), "There is no such file.", "Name the scenario's file, FILE.yaml.");
        }
        Path file = given.toAbsolutePath().normalize();
        String wanted = agent != null ? agent : onlyAgentIn(scenario, file);
        if (!ShownAgent.is(wanted)
                || !String.valueOf(Path.of(wanted).getFileName()).equals(wanted)) {
            throw new InvalidSettings(
                    Location.of(wanted),
                    "This is not the file of an agent.",
                    "Name it without a folder, such as Hunter.java.");
        }
        return new Exercise(Objects.requireNonNull(file.getParent()), String.valueOf(file.getFileName()), wanted);
    }

    private static String onlyAgentIn(String scenario, Path file) {
        Set<String> named = new LinkedHashSet<>();
        collect(Yaml.read(FileSource.disk(), file.toString(), Location.of(scenario)), named);
        if (named.size() != 1) {
            throw new InvalidSettings(
                    Location.of(scenario),
                    named.isEmpty()
                            ? "This scenario names no agent in a file."
                            : "This scenario names several agents in files: %s.".formatted(String.join(", ", named)),
                    "Name the one that students hand in by --agent FILE.");
        }
        return named.iterator().next();
    }

    private static void collect(Value value, Set<String> named) {
        switch (value) {
            case Value.Scalar _ -> {}
            case Value.Sequence list -> list.items().forEach(item -> collect(item, named));
            case Value.Mapping group -> {
                group.find("type")
                        .filter(type -> type instanceof Value.Scalar scalar
                                && ShownAgent.is(scalar.value().toString()))
                        .ifPresent(
                                type -> named.add(((Value.Scalar) type).value().toString()));
                group.entries().values().forEach(each -> collect(each, named));
            }
        }
    }

    /// Makes a folder with the teacher's files and the student's: the agent, and files of the same language beside
    /// it. A student replaces no file of the teacher's but the agent.
    ///
    /// @param student a student's folder
    /// @param work the folder to make
    /// @throws Missing if the agent is not there
    void handIn(Path student, Path work) throws IOException, Missing {
        Path handedIn = find(student);
        Files.createDirectories(work);
        long bytes = 0;
        for (Path file : filesIn(folder, DEEPEST)) {
            bytes += Files.size(file);
            if (bytes > MOST_BYTES) {
                throw new IOException(
                        "the scenario's folder '%s' has more than %d MB in it".formatted(folder, MOST_BYTES >> 20));
            }
            copy(file, work.resolve(folder.relativize(file).toString()));
        }
        copy(handedIn, work.resolve(agent));
        String suffix = agent.substring(agent.lastIndexOf('.'));
        for (Path helper : filesIn(Objects.requireNonNull(handedIn.getParent()), 1)) {
            Path target = work.resolve(String.valueOf(helper.getFileName()));
            if (target.toString().endsWith(suffix) && !Files.exists(target)) {
                copy(helper, target);
            }
        }
    }

    private Path find(Path student) throws IOException, Missing {
        List<Path> files = filesIn(student, DEEPEST);
        Optional<Path> found = files.stream()
                .filter(file -> agent.equals(String.valueOf(file.getFileName())))
                .findFirst();
        if (found.isEmpty()) {
            Set<String> names = files.stream()
                    .map(file -> String.valueOf(file.getFileName()))
                    .collect(Collectors.toSet());
            throw new Missing("There is no '%s' in '%s'. %s"
                    .formatted(
                            agent,
                            student.getFileName(),
                            Suggestion.closest(agent, names)
                                    .map("There is '%s'."::formatted)
                                    .orElse("")));
        }
        return found.get();
    }

    private static void copy(Path file, Path target) throws IOException {
        Files.createDirectories(Objects.requireNonNull(target.getParent()));
        Files.copy(file, target, StandardCopyOption.REPLACE_EXISTING);
    }

    /// Files, and none that a link leads to.
    private static List<Path> filesIn(Path folder, int depth) throws IOException {
        try (Stream<Path> all = Files.walk(folder, depth)) {
            return all.filter(path -> Files.isRegularFile(path, LinkOption.NOFOLLOW_LINKS))
                    .sorted()
                    .toList();
        }
    }
}
