package rsal.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;

/// Starts the command line as the launcher does: a JVM of its own, from the jars that were just packaged.
final class Rsal {
    private static final Path TARGET =
            Path.of(System.getProperty("rsal.target", "target")).toAbsolutePath();

    private final Path folder;
    private final String own;
    private final List<String> flags = new ArrayList<>();
    private final Map<String, String> environment;

    /// @param folder where it is started
    Rsal(Path folder) {
        this(folder, "");
    }

    /// @param own what is on the class path, too
    Rsal(Path folder, String own) {
        this.folder = folder;
        this.own = own;
        this.environment = Map.of();
    }

    private Rsal(Rsal other, List<String> flags, Map<String, String> environment) {
        this.folder = other.folder;
        this.own = other.own;
        this.flags.addAll(other.flags);
        this.flags.addAll(flags);
        this.environment = environment;
    }

    Rsal with(String... moreFlags) {
        return new Rsal(this, List.of(moreFlags), environment);
    }

    Rsal inEnvironment(Map<String, String> variables) {
        return new Rsal(this, List.of(), variables);
    }

    /// With a page that is blank.
    Rsal withPage() throws IOException {
        Path page = Files.createDirectories(folder.resolve("page"));
        Files.writeString(page.resolve("index.html"), "<!doctype html>");
        return with("-Drsal.page=" + page);
    }

    Process start(String... arguments) throws Exception {
        var builder = new ProcessBuilder(Ended.interruptible(command(arguments))).directory(folder.toFile());
        builder.environment().remove("NO_COLOR");
        builder.environment().putAll(environment);
        return builder.start();
    }

    Ended run(String... arguments) throws Exception {
        return Ended.of(start(arguments));
    }

    /// Reads on until a command tells where its page is.
    static URI page(BufferedReader err) throws IOException {
        String line = "";
        while (!line.startsWith("Watch it at ")) {
            line = err.readLine();
            assertThat(line).as("tells the address").isNotNull();
        }
        return URI.create(line.substring("Watch it at ".length()));
    }

    List<String> command(String... arguments) {
        var command = new ArrayList<String>();
        command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
        command.add("-XX:+UseSerialGC");
        command.add("-XX:TieredStopAtLevel=1");
        command.addAll(flags);
        command.addAll(List.of("-cp", classPath() + ":" + own, "rsal.cli.Main"));
        command.addAll(List.of(arguments));
        return command;
    }

    static String classPath() {
        try (var jars = Files.list(TARGET.resolve("lib"))) {
            return TARGET.resolve("rsal-cli.jar") + ":"
                    + jars.map(Path::toString).sorted().collect(Collectors.joining(":"));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
