package rsal.release;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/// `rsal dist`: packs a release for each system. The launcher builds what is packed, and says where it is. The
/// command line has the help (`DistCommand`).
@Command(name = "rsal dist")
final class Dist implements Callable<Integer> {
    private static final int UNREACHABLE = 5; // as rsal.cli.terminal.Exit

    /// What runs a release as a service, on Linux.
    private static final List<String> SERVICES = List.of(
            "rsal.service",
            "container/Dockerfile",
            "container/compose.yaml",
            "container/prometheus.yml",
            "container/grafana/datasource.yaml",
            "container/grafana/provisioning.yaml",
            "container/grafana/rsal.json");

    /// Texts of licences that no jar or package carries: of JADE and Jason, ASM, zstd-jni, javax.json, and of the
    /// search of the documentation.
    private static final List<String> LICENCES = List.of(
            "LGPL-2.1.txt",
            "LGPL-3.txt",
            "GPL-3.txt",
            "ASM.txt",
            "zstd-jni.txt",
            "CDDL-and-GPL-2-with-classpath-exception.txt",
            "docsearch.txt");

    private static final String VERSION = "0.1.0";

    @Spec
    @SuppressWarnings("NullAway.Init") // picocli fills it in
    private CommandSpec spec;

    @Parameters(paramLabel = "SYSTEM", arity = "0..*")
    private List<String> systems = List.of();

    @Option(names = "--no-runtime")
    private boolean bare;

    @Option(names = "--out", paramLabel = "FOLDER")
    private @Nullable Path given;

    @Option(names = "--project", required = true, hidden = true)
    @SuppressWarnings("NullAway.Init") // required, as those below
    private Path project;

    @Option(names = "--jars", required = true, hidden = true)
    @SuppressWarnings("NullAway.Init")
    private Path jars;

    @Option(names = "--page", required = true, hidden = true)
    @SuppressWarnings("NullAway.Init")
    private Path page;

    @Option(names = "--site", hidden = true)
    private @Nullable Path site;

    /// Where to put the sources of a wheel, with all that it has inside. The launcher makes a wheel of them.
    @Option(names = "--wheel-sources", paramLabel = "FOLDER", hidden = true)
    private @Nullable Path wheel;

    @Option(names = "--bill", required = true, hidden = true)
    @SuppressWarnings("NullAway.Init")
    private Path bill;

    @Option(names = "--jdk", required = true, hidden = true)
    @SuppressWarnings("NullAway.Init")
    private Path jdk;

    @Option(names = "--cache", required = true, hidden = true)
    @SuppressWarnings("NullAway.Init")
    private Path cache;

    @Option(names = "--commit", hidden = true)
    private @Nullable String commit;

    public static void main(String[] args) {
        System.exit(new CommandLine(new Dist())
                .setExecutionExceptionHandler((failure, line, _) -> {
                    line.getErr().println("rsal: " + failure.getMessage());
                    return failure instanceof IOException ? UNREACHABLE : 1;
                })
                .execute(args));
    }

    @Override
    public Integer call() throws IOException, InterruptedException {
        if (wheel != null) {
            var tree = new FileTree();
            addProgram(tree, components(List.of()));
            wheelSources(tree).unpack(wheel);
            return 0;
        }
        if (site == null) {
            throw new ParameterException(spec.commandLine(), "Missing --site: only wheels have no documentation.");
        }
        List<TargetSystem> wanted = wanted();
        Components components = components(List.of(site.resolve("licenses.json")));
        Path out = given == null ? project.resolve("target").resolve("dist") : given;
        Files.createDirectories(out);
        var runtimes = new JavaRuntimes(jdk, cache);
        for (TargetSystem system : wanted) {
            pack(system, components, runtimes, site, out);
        }
        return 0;
    }

    /// @param more lists of further libraries, besides those of the program and its page
    private Components components(List<Path> more) throws IOException {
        var components = new Components();
        components.add(bill);
        components.addBundled(page.resolve("licenses.json"));
        components.addBundled(page.resolve("licenses-of-plots.json"));
        for (Path list : more) {
            components.addBundled(list);
        }
        if (!components.unlicensed().isEmpty()) {
            throw new IllegalStateException("These parts have no licence, so they can't be distributed: "
                    + String.join(", ", components.unlicensed()));
        }
        return components;
    }

    /// The Python package, with the program as its folder `_program`.
    private FileTree wheelSources(FileTree program) throws IOException {
        var sources = new FileTree();
        Path python = project.resolve("clients").resolve("python");
        for (String name : List.of("pyproject.toml", "README.md")) {
            sources.add(name, Files.readAllBytes(python.resolve(name)));
        }
        sources.add("LICENSE", Files.readAllBytes(project.resolve("LICENSE")));
        sources.addFolder("src", python.resolve("src"), name -> !name.contains("__pycache__"));
        program.files().forEach((name, content) -> sources.add("src/rsal/_program/" + name, content));
        return sources;
    }

    private List<TargetSystem> wanted() {
        if (systems.isEmpty()) {
            return List.of(TargetSystem.values());
        }
        return systems.stream()
                .map(word -> TargetSystem.of(word)
                        .orElseThrow(() -> new ParameterException(
                                spec.commandLine(),
                                "There is no system '%s'. There are %s."
                                        .formatted(word, String.join(", ", TargetSystem.words())))))
                .distinct()
                .toList();
    }

    private void pack(TargetSystem system, Components components, JavaRuntimes runtimes, Path site, Path out)
            throws IOException, InterruptedException {
        var tree = new FileTree();
        String runtime = bare ? "none: it needs Java 25 or newer" : runtimes.addTo(tree, system);
        addProgram(tree, components);
        tree.addFolder("docs", site, _ -> true);
        for (String name : List.of("CHANGELOG.md", "SECURITY.md", "CITATION.cff")) {
            tree.add(name, Files.readAllBytes(project.resolve(name)));
        }
        tree.add("README.md", resource("README.md"));
        if (system.isLinux()) {
            for (String name : SERVICES) {
                tree.add(name, resource(name));
            }
        }
        String starter = system.isWindows() ? "rsal.cmd" : "rsal";
        byte[] script = resource(starter);
        tree.add(starter, new FileTree.Content(() -> script, true));

        String top = "rsal-%s-%s%s".formatted(VERSION, system.word(), bare ? "-no-runtime" : "");
        Path file = out.resolve(top + Archive.of(system).suffix());
        Archive.of(system).write(tree, top, file);
        String sum = JavaRuntimes.sha256(file);
        Files.writeString(out.resolve(file.getFileName() + ".sha256"), "%s  %s\n".formatted(sum, file.getFileName()));
        IO.println("%s  (%.1f MB; Java runtime: %s)".formatted(file, Files.size(file) / 1e6, runtime));
    }

    /// What archives and wheels have in them: the program, its page, and the licences of both.
    private void addProgram(FileTree tree, Components components) throws IOException {
        tree.addFolder("lib", jars, name -> name.endsWith(".jar"));
        tree.addFolder("page", page, _ -> true);
        tree.add("lib/java.options", options());
        tree.add("LICENSE", Files.readAllBytes(project.resolve("LICENSE")));
        tree.add("NOTICE", notice(components).getBytes(StandardCharsets.UTF_8));
        tree.add("sbom.cdx.json", components.bill(VERSION));
        components.addTexts(tree, jars);
        for (String name : LICENCES) {
            tree.add("licenses/" + name, resource("licenses/" + name));
        }
    }

    private String notice(Components components) throws IOException {
        return new String(resource("NOTICE"), StandardCharsets.UTF_8) + components.table();
    }

    /// Options of Java, read by both scripts.
    private byte[] options() throws IOException {
        var lines = new ArrayList<String>(new String(resource("java.options"), StandardCharsets.UTF_8)
                .lines()
                .toList());
        if (commit != null) {
            lines.add("-Drsal.commit=" + commit);
        }
        return lines.stream().collect(Collectors.joining("\n", "", "\n")).getBytes(StandardCharsets.UTF_8);
    }

    private static byte[] resource(String name) throws IOException {
        try (var in = Dist.class.getResourceAsStream("unpacked/" + name)) {
            if (in == null) {
                throw new IllegalStateException("no resource " + name);
            }
            return in.readAllBytes();
        }
    }
}
