package rsal.cli.page;

import com.sun.management.OperatingSystemMXBean;
import java.io.File;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.lang.module.ModuleDescriptor.Version;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import rsal.cli.terminal.Exit;
import rsal.cli.terminal.Subcommand;
import rsal.cli.terminal.TextTable;
import rsal.scenario.installed.Providers;
import rsal.settings.Arguments;
import rsal.settings.Suggestion;
import rsal.system.Diagnosis;
import rsal.system.Diagnosis.Finding;

/// `rsal doctor`
@Command(
        name = "doctor",
        description = "Check whether this machine has everything that RSAL needs, and say what to do if not.")
public final class DoctorCommand extends Subcommand {
    private static final long ENOUGH_MEMORY = 2L << 30;
    private static final String CACHE = "-XX:AOTCache=";
    private static final Version NODE_LEAST = Version.parse("20.19");
    private static final List<Path> MAC_BROWSERS =
            List.of(Path.of("/Applications/Chromium.app"), Path.of("/Applications/Google Chrome.app"));

    @Option(
            names = "--offline",
            description = "Do not check programs that only build and test RSAL, as in a release: Node.js and Chromium.")
    private boolean offline;

    @Parameters(
            arity = "0..1",
            paramLabel = "WHAT",
            defaultValue = "",
            description = "What to check instead of this machine: ros2, the network of ROS 2.")
    private String what = "";

    @Option(
            names = "--set",
            paramLabel = "NAME=VALUE",
            description = "A setting of WHAT, such as domain=5 or address=192.168.1.5.")
    private Map<String, String> set = Map.of();

    @Override
    protected int run() {
        List<Finding> findings = what.isEmpty() ? machine() : diagnosis();
        if (json) {
            printJson(Map.of("findings", findings));
        } else {
            print(findings);
        }
        return Exit.SUCCESS;
    }

    private List<Finding> machine() {
        boolean release = System.getProperty("rsal.docs") != null;
        var findings = new ArrayList<>(List.of(jdk(), cores(), memory(), fastStart(release), port(), page()));
        if (!offline && !release) {
            findings.addAll(List.of(node(), chromium()));
        }
        return findings;
    }

    private List<Finding> diagnosis() {
        Map<String, Diagnosis> all = Providers.byKey(Diagnosis.class, Diagnosis::key);
        Diagnosis one = all.get(what);
        if (one == null) {
            throw new ParameterException(
                    spec.commandLine(),
                    "There is no check '%s'. %s".formatted(what, Suggestion.among(what, all.keySet())));
        }
        try {
            return one.look(Arguments.parse(one.parameters(), set));
        } catch (IllegalArgumentException e) {
            throw new ParameterException(spec.commandLine(), String.valueOf(e.getMessage()), e);
        }
    }

    private void print(List<Finding> findings) {
        var table = new TextTable("");
        for (Finding finding : findings) {
            List<String> lines = finding.found().lines().toList();
            table.row(finding.ok() ? "ok" : "warn", finding.what(), lines.isEmpty() ? "" : lines.getFirst());
            lines.stream().skip(1).forEach(line -> table.row("", "", line));
            if (!finding.remedy().isEmpty()) {
                table.row("", "", "→ " + finding.remedy());
            }
        }
        out().print(table);
        out().flush();
    }

    private static Finding jdk() {
        return new Finding(
                "JDK",
                true, // an older one could not have loaded this class
                "%s %s, %s"
                        .formatted(
                                System.getProperty("java.vendor"), Runtime.version(), System.getProperty("java.home")),
                "");
    }

    private static Finding cores() {
        int cores = Runtime.getRuntime().availableProcessors();
        return new Finding("cores", true, Integer.toString(cores), "");
    }

    private static Finding memory() {
        var system = ManagementFactory.getPlatformMXBean(OperatingSystemMXBean.class);
        long bytes = system.getTotalMemorySize();
        boolean enough = bytes >= ENOUGH_MEMORY;
        return new Finding(
                "memory",
                enough,
                String.format(Locale.ROOT, "%.1f GiB", (double) bytes / (1 << 30)),
                enough ? "" : "2 GiB are enough for all that comes with RSAL; close something.");
    }

    private static Finding fastStart(boolean release) {
        boolean cached = ManagementFactory.getRuntimeMXBean().getInputArguments().stream()
                .filter(flag -> flag.startsWith(CACHE))
                .anyMatch(flag -> new File(flag.substring(CACHE.length())).length() > 0);
        return new Finding(
                "fast start",
                cached,
                cached ? "with an AOT cache" : "no AOT cache",
                cached
                        ? ""
                        : release
                                ? "'rsal prepare' makes one, or says why it can't."
                                : "Start with ./rsal, which makes one after each build.");
    }

    private static Finding port() {
        int port = PageRuns.DEFAULT_PORT;
        try (var socket = new ServerSocket()) {
            socket.bind(new InetSocketAddress(InetAddress.getLoopbackAddress(), port));
            return new Finding("port", true, port + " is free", "");
        } catch (IOException _) {
            return new Finding(
                    "port", true, port + " is in use; a run takes another one, or the one given by --port", "");
        }
    }

    private static Finding page() {
        Optional<Path> page = PageRuns.page();
        return new Finding(
                "page",
                page.isPresent(),
                page.map(Path::toString).orElse("not built"),
                page.isPresent() ? "" : "./rsal run builds it.");
    }

    private static Finding node() {
        Optional<Path> node = program("node");
        Optional<String> version = node.flatMap(DoctorCommand::version);
        boolean newEnough = version.map(v -> Version.parse(v.substring(1)).compareTo(NODE_LEAST) >= 0)
                .orElse(false);
        return new Finding(
                "Node.js",
                newEnough,
                version.map(v -> v + ", " + node.orElseThrow()).orElse("not found"),
                newEnough ? "" : "The page is built with Node.js 20.19 or newer: https://nodejs.org");
    }

    private static Finding chromium() {
        Optional<Path> browser = program(
                        "chromium-headless-shell",
                        "chromium",
                        "chromium-browser",
                        "google-chrome",
                        "google-chrome-stable")
                .or(() -> MAC_BROWSERS.stream().filter(Files::exists).findFirst());
        return new Finding(
                "Chromium",
                browser.isPresent(),
                browser.map(Path::toString).orElse("not found"),
                browser.isPresent()
                        ? ""
                        : "Some tests of the page need it: apt-get install chromium, or brew install --cask chromium");
    }

    /// Looks for a program on the PATH under any of its names.
    private static Optional<Path> program(String... names) {
        String path = Optional.ofNullable(System.getenv("PATH")).orElse("");
        return Arrays.stream(path.split(File.pathSeparator))
                .flatMap(folder -> Arrays.stream(names).flatMap(name -> file(folder, name)))
                .filter(Files::isExecutable)
                .findFirst();
    }

    /// A program in a folder of the PATH, which can have anything in it. On Windows, names of programs end in `.exe`.
    private static Stream<Path> file(String folder, String name) {
        try {
            return Stream.of(Path.of(folder, name), Path.of(folder, name + ".exe"));
        } catch (InvalidPathException e) {
            return Stream.empty();
        }
    }

    /// What a program prints when asked for its version, if that looks like one.
    private static Optional<String> version(Path program) {
        try {
            var process = new ProcessBuilder(program.toString(), "--version")
                    .redirectErrorStream(true)
                    .start();
            try (var reader = process.inputReader()) {
                return Optional.ofNullable(reader.readLine()).filter(line -> line.matches("v\\d+(\\.\\d+)*"));
            }
        } catch (IOException _) {
            return Optional.empty();
        }
    }
}
