package rsal.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import javax.tools.ToolProvider;

/// What a page of the documentation has people write into `agents/own`, and files beside that, written and compiled.
/// Only Maven is left out, which would build all of RSAL again.
///
/// @param folder in place of the repository
record OwnFolder(Path folder) {
    static final OwnFolder NONE = new OwnFolder(Path.of(""));

    /// A file's name, the rest of the sentence, and what is in it.
    private static final Pattern FILE = Pattern.compile(
            "`(agents/own/[^`]+|[\\w-]+\\.(?:yaml|plan|table))`[^`]*:\n\n```\\w*\n(.*?)```", Pattern.DOTALL);

    /// Writes all files of a page, which must be all Java and YAML that it shows.
    static OwnFolder of(String page, Path folder) throws IOException {
        var files = new LinkedHashMap<String, String>();
        FILE.matcher(page).results().forEach(file -> files.put(file.group(1), file.group(2)));
        assertThat(files.values())
                .containsAll(TutorialIT.blocks(page, "java"))
                .containsAll(TutorialIT.blocks(page, "yaml"));
        for (Map.Entry<String, String> file : files.entrySet()) {
            Path path = folder.resolve(file.getKey());
            Files.createDirectories(path.getParent());
            Files.writeString(path, file.getValue());
        }
        var own = new OwnFolder(folder);
        own.compile("main", Rsal.classPath());
        Files.move(
                folder.resolve("agents/own/src/main/resources/META-INF"),
                own.classes().resolve("META-INF"));
        return own;
    }

    Path classes() {
        return folder.resolve("classes");
    }

    /// @param sources `main` or `test`
    void compile(String sources, String classPath) throws IOException {
        var command = new ArrayList<>(List.of("-d", classes().toString(), "-cp", classPath));
        try (Stream<Path> files = Files.list(folder.resolve("agents/own/src/%s/java/own".formatted(sources)))) {
            files.map(Path::toString).sorted().forEach(command::add);
        }
        assertThat(ToolProvider.getSystemJavaCompiler().run(null, null, null, command.toArray(String[]::new)))
                .isZero();
    }
}
