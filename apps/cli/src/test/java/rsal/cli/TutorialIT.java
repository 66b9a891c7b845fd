package rsal.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.CleanupMode;
import org.junit.jupiter.api.io.TempDir;
import rsal.cli.terminal.Exit;
import rsal.testkit.LongTest;

/// Does what the tutorials say, and sees what they say.
class TutorialIT {
    private static final Path TUTORIALS = Path.of("../../docs/tutorials");
    private static final String PROMPT = "$ ./rsal ";
    private static final String WATCHED = "./rsal run ";

    @TempDir(factory = WarmProcess.Folder.class, cleanup = CleanupMode.NEVER)
    Path folder;

    @Test
    @LongTest
    void aScenarioDoesWhatItsTutorialShows() throws Exception {
        String tutorial = tutorial("first-scenario.md");
        Files.writeString(
                folder.resolve("corridor.yaml"), blocks(tutorial, "yaml").getFirst());
        follow(tutorial, new Rsal(folder));
    }

    @Test
    void anAgentDoesWhatItsTutorialShows() throws Exception {
        String tutorial = tutorial("first-agent.md");
        Files.writeString(folder.resolve("watch.yaml"), blocks(tutorial, "yaml").getFirst());
        List<String> classes = blocks(tutorial, "java");
        Files.writeString(folder.resolve("Sentry.java"), classes.getFirst());
        Files.writeString(folder.resolve("Logbook.java"), classes.getLast());
        follow(tutorial, new Rsal(folder));
    }

    @Test
    @LongTest
    void aHostDoesWhatItsHowToShows() throws Exception {
        String page = Files.readString(TUTORIALS.resolve("../how-to/another-mas.md"));
        compile(blocks(page, "java").stream()
                .filter(block -> block.contains(" implements "))
                .toList());
        Path services = Files.createDirectories(folder.resolve("META-INF/services"));
        Files.writeString(
                services.resolve("rsal.agent.AgentHostProvider"),
                blocks(page, "text").getFirst());
        var rsal = new Rsal(folder, folder.toString());
        follow(page, rsal);
        String setting = blocks(page, "yaml").getFirst().lines().findFirst().orElseThrow();
        Files.writeString(folder.resolve("threads.yaml"), """
                rsal: 1
                scenario: threads
                title: A robot along a wall
                world: {map: office}
                robots:
                  one: {model: pioneer2dx, pose: [-4, -1, 180], devices: {laser: urg04lx, localizer: {type: amcl}, pilot: {}}}
                agents:
                  walk: {type: wall-follow, robot: one}
                run: {stop: [{when: time > 2, outcome: success}]}
                metrics:
                  - {name: way, unit: m, from: distance}
                """ + setting);
        Ended run = rsal.run("run", "threads.yaml", "--headless", "--clock", "wall", "--json");
        assertThat(run.code()).as(run.err()).isEqualTo(Exit.SUCCESS);
        Ended simulated = rsal.run("run", "threads.yaml", "--headless");
        assertThat(simulated.code()).isEqualTo(Exit.INVALID);
        assertThat(simulated.err() + simulated.out()).contains("'threads' can't follow simulated time");
    }

    @Test
    @LongTest
    void anAgentInAgentSpeakDoesWhatItsTutorialShows() throws Exception {
        String tutorial = tutorial("first-agentspeak-robot.md");
        String sentry = blocks(tutorial, "asl").getFirst();
        Files.writeString(folder.resolve("sentry.asl"), sentry);
        String guard = blocks(tutorial, "yaml").getFirst();
        Files.writeString(folder.resolve("guard.yaml"), guard);
        var rsal = new Rsal(folder);
        follow(tutorial, rsal);
        Ended run = rsal.run("run", "guard.yaml", "--headless", "--speed", "max", "--json");
        assertThat(run.out()).contains("\"topic\":\"text\",\"said\":").doesNotContain("\"topic\":\"text\",\"said\":0");

        Files.writeString(folder.resolve("sentry.asl"), sentry.replace("goto(X, Y)", "godo(X, Y)"));
        Ended error = rsal.run("validate", "guard.yaml");
        assertThat(error.code()).isEqualTo(Exit.INVALID);
        assertThat(error.out().lines())
                .containsAll(blocks(tutorial, "text").getFirst().lines().toList());
        assertThat(rsal.run("run", "guard.yaml", "--headless").code()).isEqualTo(Exit.INVALID);

        Files.writeString(folder.resolve("sentry.asl"), sentry);
        Files.writeString(folder.resolve("guard.yaml"), guard.replace("navigator: {}", "pilot: {}"));
        assertThat(rsal.run("validate", "guard.yaml").out()).contains("needs a robot with a Navigator");
    }

    @Test
    @LongTest
    void faultsAreAsTheirReferenceShows() throws Exception {
        String reference = Files.readString(TUTORIALS.resolve("../reference/faults.md"));
        Files.writeString(
                folder.resolve("bad-day.yaml"), blocks(reference, "yaml").getFirst());
        follow(reference, new Rsal(folder));
    }

    @Test
    void theErrorItProposesIsExplained() throws Exception {
        String corridor = blocks(tutorial("first-scenario.md"), "yaml").getFirst();
        Files.writeString(folder.resolve("corridor.yaml"), corridor.replace("model:", "modle:"));
        Ended ended = new Rsal(folder).run("validate", "corridor.yaml");
        assertThat(ended.code()).isEqualTo(Exit.INVALID);
        assertThat(ended.out()).contains("'modle'", "Maybe 'model'");
    }

    /// Types all commands; what is shown below each must be among the lines that it prints.
    static void follow(String tutorial, Rsal rsal) throws Exception {
        int commands = 0;
        for (String console : blocks(tutorial, "console")) {
            String out = "";
            for (String line : console.lines().toList()) {
                if (line.startsWith(PROMPT)) {
                    Ended ended = rsal.run(line.substring(PROMPT.length()).split(" "));
                    assertThat(ended.code()).as(line + "\n" + ended.err()).isEqualTo(Exit.SUCCESS);
                    out = ended.out();
                    commands++;
                } else {
                    assertThat(out.lines()).contains(line);
                }
            }
        }
        assertThat(commands).isPositive();
        for (String line :
                tutorial.lines().filter(line -> line.startsWith(WATCHED)).toList()) {
            watch(line, rsal.withPage());
        }
    }

    /// Runs that are to be watched stand without a prompt. They are ended once their page is there.
    private static void watch(String line, Rsal rsal) throws Exception {
        Process run = rsal.start(line.substring("./rsal ".length()).split(" "));
        try (var err = run.errorReader()) {
            Rsal.page(err);
            Ended.signal("INT", run);
            assertThat(run.waitFor()).as(line).isEqualTo(130);
        } finally {
            run.destroyForcibly();
        }
    }

    private void compile(List<String> classes) throws IOException {
        var command = new ArrayList<>(List.of("-d", folder.toString(), "-cp", Rsal.classPath()));
        for (String source : classes) {
            Matcher name = Pattern.compile("class (\\w+) implements").matcher(source);
            assertThat(name.find()).isTrue();
            Path file = folder.resolve(name.group(1) + ".java");
            command.add(Files.writeString(file, source).toString());
        }
        assertThat(ToolProvider.getSystemJavaCompiler().run(null, null, null, command.toArray(String[]::new)))
                .isZero();
    }

    private static String tutorial(String name) throws IOException {
        return Files.readString(TUTORIALS.resolve(name));
    }

    static List<String> blocks(String tutorial, String language) {
        return Pattern.compile("(?m)^```" + language + "\n(.*?)```", Pattern.DOTALL)
                .matcher(tutorial)
                .results()
                .map((MatchResult block) -> block.group(1))
                .toList();
    }
}
