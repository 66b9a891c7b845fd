package rsal.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.lang.ProcessBuilder.Redirect;
import java.net.URI;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.FileTime;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import picocli.CommandLine;

/// Starts the command line as the launcher does: a JVM of its own, from the jars that were just packaged.
final class Rsal {
    private static final Path TARGET =
            Path.of(System.getProperty("rsal.target", "target")).toAbsolutePath();

    /// The first compiler only: a process that ends soon does not pay for the second one.
    private static final List<String> FLAGS =
            List.of("-XX:+UseSerialGC", "-XX:TieredStopAtLevel=1", "--enable-native-access=ALL-UNNAMED");

    private final Path folder;
    private final String own;
    private final List<String> flags = new ArrayList<>();
    private final Map<String, String> environment;
    private final boolean apart;

    /// @param folder where it is started
    Rsal(Path folder) {
        this(folder, "");
    }

    /// @param own what is on the class path, too
    Rsal(Path folder, String own) {
        this.folder = folder;
        this.own = own;
        this.environment = Map.of();
        this.apart = false;
    }

    private Rsal(Rsal other, boolean apart, List<String> flags, Map<String, String> environment) {
        this.apart = apart;
        this.folder = other.folder;
        this.own = other.own;
        this.flags.addAll(other.flags);
        this.flags.addAll(flags);
        this.environment = environment;
    }

    Rsal with(String... moreFlags) {
        return new Rsal(this, apart, List.of(moreFlags), environment);
    }

    Rsal inEnvironment(Map<String, String> variables) {
        return new Rsal(this, apart, List.of(), variables);
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
        if (WarmProcess.isIn(folder)) {
            builder.environment().put(WarmProcess.RUNTIME, folder.toString()); // it is to find pages
        }
        builder.environment().putAll(environment);
        return builder.start();
    }

    /// In a process that is there already where that has this folder and nothing else is asked for.
    Ended run(String... arguments) throws Exception {
        boolean isPlain = !apart && own.isEmpty() && flags.isEmpty() && environment.isEmpty();
        return isPlain && WarmProcess.isIn(folder) ? WarmProcess.run(arguments) : Ended.of(start(arguments));
    }

    /// With a process for each command in any case.
    Rsal apart() {
        return new Rsal(this, true, List.of(), environment);
    }

    /// Does what a command line says in this process, which is faster by far: for those that start nothing and name
    /// no file by a relative path.
    static Ended inProcess(String... arguments) {
        var out = new ByteArrayOutputStream();
        var err = new StringWriter();
        CommandLine commandLine = Main.commandLine(out).setErr(new PrintWriter(err, true));
        int code = commandLine.execute(arguments);
        commandLine.getOut().flush();
        return new Ended(code, out.toString(StandardCharsets.UTF_8), err.toString());
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
        List<String> all = javaCommand("rsal.cli.Main");
        all.addAll(List.of(arguments));
        return all;
    }

    /// @param main the class whose program it is
    List<String> javaCommand(String main) {
        var all = new ArrayList<>(List.of("-XX:AOTCache=" + Trained.CACHE));
        all.addAll(flags);
        return java(all, own.isEmpty() ? classPath() : classPath() + ":" + own, main);
    }

    private static List<String> java(List<String> flags, String classPath, String main) {
        var command = new ArrayList<String>();
        command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
        command.addAll(FLAGS);
        command.addAll(flags);
        command.addAll(List.of("-cp", classPath, main));
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

    /// What processes share that are started for tests: the loaded classes (JEP 483 and 514), as the launcher has
    /// them. A start takes a third less processor time.
    private static final class Trained {
        static final Path CACHE = make(TARGET.resolve("tests.aot"));

        /// @param cache of which one is made for the jars that are there now; tests in another process use it, too
        private static Path make(Path cache) {
            try (var lock = FileChannel.open(
                    TARGET.resolve("tests.aot.lock"), StandardOpenOption.CREATE, StandardOpenOption.WRITE)) {
                lock.lock();
                FileTime built = Files.getLastModifiedTime(TARGET.resolve("rsal-cli.jar"));
                if (Files.notExists(cache) || Files.getLastModifiedTime(cache).compareTo(built) < 0) {
                    train(cache);
                }
                return cache;
            } catch (IOException e) {
                throw new UncheckedIOException(e);
            } catch (InterruptedException e) {
                throw new IllegalStateException(e);
            }
        }

        private static void train(Path cache) throws IOException, InterruptedException {
            List<String> flags = List.of("-XX:AOTCacheOutput=" + cache);
            String[] run = {"run", "hunt-and-prey", "--headless", "--speed", "max", "--for", "5"};
            List<String> command = java(flags, classPath(), "rsal.cli.Main");
            command.addAll(List.of(run));
            Process training = new ProcessBuilder(command)
                    .redirectOutput(Redirect.DISCARD)
                    .redirectError(Redirect.DISCARD)
                    .start();
            assertThat(training.waitFor()).isZero();
        }
    }
}
