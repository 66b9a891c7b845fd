package rsal.cli;

import java.io.File;
import java.io.IOException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import rsal.agent.AgentHostProvider;
import rsal.cli.show.ShownAgent;
import rsal.cli.terminal.Exit;
import rsal.cli.terminal.FileName;
import rsal.cli.terminal.Subcommand;
import rsal.cli.terminal.Unreachable;
import rsal.experiment.report.ShellWords;
import rsal.scenario.RunOptions;
import rsal.scenario.Scenario;
import rsal.scenario.Template;
import rsal.scenario.installed.Providers;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;
import rsal.settings.Suggestion;

/// `rsal new`
@Command(
        name = "new",
        description =
                "Make a folder with a new scenario: NAME.yaml, an agent in Java, Python or AgentSpeak, a controller or a"
                        + " metric, the other files that it names, and a README. The scenario runs without changes."
                        + " Existing files are not overwritten.")
final class NewCommand extends Subcommand {
    private static final String PLAIN = "plain"; // runs agents in Java
    private static final String README = "README.md";
    private static final boolean ON_WINDOWS = File.separatorChar == '\\'; // whose shells have quotes of their own
    private static final String ABOUT_AGENTS = """
            Agents are named by their `type` under `agents`: a file here, in Java (`.java`), Python (`.py`) or AgentSpeak (`.asl`), or one that comes
            with RSAL. Change a file and run the scenario again. `rsal list agents` tells which agents come with RSAL, and `rsal show TYPE`
            what can be set of one. The tutorials "Your first agent" and "Your first AgentSpeak robot" explain how to write one; `rsal docs --serve`
            shows them.""";
    private static final String ABOUT_CONTROLLERS = """
            A navigator's `controller` names a file here, in Java (`.java`), or a controller that comes with RSAL. `rsal list controllers` tells
            which there are. `docs/how-to/own-controller.md` of RSAL explains how to write one.""";
    private static final String ABOUT_METRICS = """
            Metric types are named by their `type` under `metricTypes`: a file here, in Java (`.java`), or one that comes with RSAL. Conditions
            (`when`) and metrics (`from`) ask for the quantities and signals that a metric offers. `rsal list metrics` tells which metrics
            come with RSAL. `docs/how-to/own-metric.md` of RSAL explains how to write one.""";

    @Parameters(paramLabel = "NAME", description = "Name of the scenario and its folder; or a path to the folder.")
    private String name = "";

    @Option(
            names = "--from",
            converter = FileName.class,
            paramLabel = "SCENARIO",
            description = "A scenario of RSAL ('rsal list') to copy. Default: a hunt, with a hunter for you to change.")
    private @Nullable String from;

    @Option(
            names = "--mas",
            paramLabel = "KEY",
            description = "jason for an agent in AgentSpeak. Default: an agent in Java.")
    private @Nullable String mas;

    @Option(names = "--python", description = "An agent in Python, with numpy.")
    private boolean python;

    @Option(
            names = "--kind",
            paramLabel = "KIND",
            defaultValue = "agent",
            description = "The program that you want to write: ${COMPLETION-CANDIDATES}. Default: ${DEFAULT-VALUE}.")
    private Own kind = Own.agent;

    enum Own {
        agent,
        controller,
        metric
    }

    /// @param run the scenario's file
    /// @param files all that were made
    record Made(String scenario, String run, List<String> files) {}

    @Override
    protected int run() {
        Path folder = folder();
        String own = folder.getFileName().toString();
        Template template = template();
        var texts = new LinkedHashMap<>(template.named(own));
        if (Files.exists(folder)) {
            throw there(folder);
        }
        texts.put(README, readme(own, template, texts));
        write(folder, texts);
        print(own, folder, template, List.copyOf(texts.keySet()));
        return Exit.SUCCESS;
    }

    private Path folder() {
        try {
            Path folder = Path.of(name);
            check(folder.getFileName() != null, "'%s' can't be a folder.".formatted(name));
            return folder;
        } catch (InvalidPathException e) {
            throw new ParameterException(spec.commandLine(), "'%s' can't be a folder.".formatted(name), e);
        }
    }

    private Template template() {
        if (kind != Own.agent) {
            check(
                    from == null && mas == null && !python,
                    "--kind %s begins with a scenario of its own. Remove --from, --mas and --python.".formatted(kind));
            return Template.withPlugin(kind.name());
        }
        if (python) {
            check(from == null && mas == null, "--python begins with a scenario of its own. Remove --from and --mas.");
            return Template.inLanguage("python").orElseThrow();
        }
        if (mas == null || mas.equals(PLAIN)) {
            return from == null ? Template.inLanguage("java").orElseThrow() : Template.of(from);
        }
        List<String> hosts = List.copyOf(
                Providers.byKey(AgentHostProvider.class, AgentHostProvider::key).keySet());
        check(
                hosts.contains(mas),
                "There is no multi-agent system '%s'. %s".formatted(mas, Suggestion.among(mas, hosts)));
        Template template = Template.inLanguage(mas)
                .orElseThrow(() -> new ParameterException(
                        spec.commandLine(),
                        "Multi-agent system '%s' runs the same agents as '%s'. Remove --mas here, and use it with 'rsal run'."
                                .formatted(mas, PLAIN)));
        check(from == null, "--mas %s begins with a scenario of its own. Remove --from %s.".formatted(mas, from));
        return template;
    }

    // ── What is written ──────────────────────────────────────────────────────────────────────────────────────────

    /// As a word for a shell, wherever it is called from.
    private static String command() {
        String launcher = System.getProperty("rsal.launcher", "rsal");
        if (ON_WINDOWS) {
            return launcher.contains(" ") ? "\"" + launcher + "\"" : launcher;
        }
        return ShellWords.of(List.of(launcher));
    }

    private String readme(String name, Template template, Map<String, String> texts) {
        String files = texts.keySet().stream()
                .map(file -> "| `%s` | %s |%n".formatted(file, about(file, name)))
                .collect(Collectors.joining());
        return """
                # %s

                %s. Made by `rsal new`, from %s.

                ```
                rsal run %s.yaml
                rsal show %s.yaml
                %s
                ```

                `rsal` is the program in RSAL's folder. The first command runs the scenario and shows it on a page. The second one shows
                what can be set, and lists robots, agents, endings and metrics. The third one %s.

                | file | |
                |---|---|
                %s
                %s
                """.formatted(
                        name,
                        template.scenario().title(),
                        origin(),
                        name,
                        name,
                        test("rsal", Scenario.fileIn(name), template),
                        ends(template)
                                ? "runs it with three seeds, and fails when one does not end in success"
                                : "runs it for 30 s, as fast as it can",
                        files,
                        about());
    }

    /// The command that tests it. A scenario without an end of its own can't succeed, so that it is run for a while.
    private static String test(String command, Object scenario, Template template) {
        return (ends(template) ? "%s test-agent %s --seeds 3" : "%s run %s --headless --speed max --for 30")
                .formatted(command, scenario);
    }

    private static boolean ends(Template template) {
        return !template.scenario().plan(RunOptions.NONE).stops().isEmpty();
    }

    private String about() {
        return switch (kind) {
            case agent -> ABOUT_AGENTS;
            case controller -> ABOUT_CONTROLLERS;
            case metric -> ABOUT_METRICS;
        };
    }

    private String origin() {
        if (from != null) {
            return "`%s`".formatted(from);
        }
        if (kind != Own.agent) {
            return "its template for %ss".formatted(kind);
        }
        String language = python ? "Python" : mas == null || mas.equals(PLAIN) ? "Java" : "AgentSpeak";
        return "its template for agents in %s".formatted(language);
    }

    private String about(String file, String name) {
        if (file.equals(Scenario.fileIn(name))) {
            return "the scenario";
        }
        if (file.equals(Template.WATCHER)) {
            return "an agent in Java, which listens to the others: `rsal run %s.yaml:%s`"
                    .formatted(name, Template.WATCHED);
        }
        if (kind != Own.agent && file.endsWith(".java")) {
            return "a %s in Java%s".formatted(kind, kind == Own.metric ? ": `rsal show %s`".formatted(file) : "");
        }
        if (ShownAgent.is(file)) {
            String language = file.endsWith(".asl") ? "AgentSpeak" : file.endsWith(".py") ? "Python" : "Java";
            return "an agent in %s: `rsal show %s`".formatted(language, file);
        }
        return "named by the scenario";
    }

    private static void write(Path folder, Map<String, String> texts) {
        try {
            Files.createDirectory(folder);
            for (Map.Entry<String, String> text : texts.entrySet()) {
                Files.writeString(folder.resolve(text.getKey()), text.getValue());
            }
        } catch (FileAlreadyExistsException e) {
            throw there(folder);
        } catch (NoSuchFileException e) {
            throw new Unreachable("There is no folder '%s' in which '%s' could be made."
                    .formatted(folder.toAbsolutePath().getParent(), folder.getFileName()));
        } catch (IOException e) {
            throw new Unreachable("'%s' can't be written: %s.".formatted(folder, e));
        }
    }

    private static InvalidSettings there(Path folder) {
        return new InvalidSettings(Location.of(folder.toString()), "This is there already.", "Choose another name.");
    }

    private void print(String own, Path folder, Template template, List<String> files) {
        Path run = folder.resolve(Scenario.fileIn(own));
        List<String> all =
                files.stream().map(file -> folder.resolve(file).toString()).toList();
        if (json) {
            printJson(new Made(own, run.toString(), all));
            return;
        }
        all.forEach(out()::println);
        out().println("\nRun it by   %s run %s%nTest it by  %s"
                .formatted(command(), run, test(command(), run, template)));
        out().flush();
    }
}
