package rsal.python;

import java.io.File;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.URI;
import java.net.URISyntaxException;
import java.net.URL;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Stream;

/// The Python that runs agents: the one that `-Drsal.python` or `RSAL_PYTHON` names, else `python3`, `python` or `py`
/// of the `PATH`. It gets RSAL's own modules from where this class is: a folder, or a jar, of which Python reads as
/// well.
final class Interpreter {
    static final String PROPERTY = "rsal.python";
    static final String VARIABLE = "RSAL_PYTHON";
    private static final List<String> NAMES = List.of("python3", "python3.exe", "py.exe", "python.exe", "python");

    private Interpreter() {}

    /// Why there is none, and what to do; empty where one is named or found. One that is named may still be none.
    static Optional<String> missing() {
        return command().isPresent()
                ? Optional.empty()
                : Optional.of("There is no 'python3' on the PATH. Agents in Python need Python 3.10 or newer with numpy"
                        + " (pip install numpy); RSAL_PYTHON=/path/to/python3 names one that is elsewhere.");
    }

    /// Starts it with a module of RSAL's own, which talks by frames. Ctrl-C on the terminal is for RSAL, from the first
    /// moment on.
    ///
    /// @param module of `rsal.agents`
    /// @throws IOException when it can't be started
    static Process start(String module) throws IOException {
        String python = command().orElseThrow(() -> new IOException(missing().orElseThrow()));
        var builder = new ProcessBuilder(
                python,
                "-X",
                "utf8",
                "-c",
                "import signal, sys; signal.signal(signal.SIGINT, signal.SIG_IGN); sys.path[0] = sys.argv[1];"
                        + " from rsal.agents.%s import main; main()".formatted(module),
                home());
        builder.environment().put("PYTHONHASHSEED", "0"); // else sets of texts have another order in each process
        builder.environment().put("PYTHONDONTWRITEBYTECODE", "1");
        return builder.start();
    }

    private static Optional<String> command() {
        return Stream.of(
                        Optional.ofNullable(System.getProperty(PROPERTY)),
                        Optional.ofNullable(System.getenv(VARIABLE)),
                        onPath())
                .flatMap(Optional::stream)
                .filter(named -> !named.isBlank())
                .findFirst();
    }

    private static Optional<String> onPath() {
        String path = Objects.requireNonNullElse(System.getenv("PATH"), "");
        return NAMES.stream()
                .flatMap(name -> Stream.of(path.split(File.pathSeparator))
                        .filter(folder -> !folder.isBlank())
                        .map(folder -> Path.of(folder, name)))
                .filter(Files::isExecutable)
                .filter(Files::isRegularFile)
                .map(Path::toString)
                .findFirst();
    }

    /// Where Python finds the package `rsal`: a folder, or a place in a jar.
    private static String home() {
        URL marker = Objects.requireNonNull(
                Interpreter.class.getResource("/python/rsal/protocol.py"), "The Python package is beside this class.");
        try {
            if (marker.getProtocol().equals("jar")) {
                String inside = marker.getPath();
                int end = inside.indexOf("!/");
                return Path.of(new URI(inside.substring(0, end)))
                        .resolve("python")
                        .toString();
            }
            return Path.of(marker.toURI()).resolve("../..").normalize().toString();
        } catch (URISyntaxException e) {
            throw new UncheckedIOException(new IOException(marker.toString(), e));
        }
    }
}
