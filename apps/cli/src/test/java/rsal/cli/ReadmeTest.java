package rsal.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Function;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import rsal.agent.AgentHostProvider;
import rsal.cli.terminal.Build;
import rsal.scenario.installed.Providers;
import rsal.system.BridgeProvider;
import rsal.system.RobotSystemProvider;

/// What the README says that RSAL works with is what is installed.
class ReadmeTest {
    private static final Path ROOT = Path.of("../..");
    private static final Pattern ROW = Pattern.compile("(?m)^\\| ([^|]*)\\| ([^|]+) \\| (yes|partly|not yet) \\|$");
    private static final Pattern KEY = Pattern.compile("\\(`([\\w.-]+)`\\)");
    private static final Pattern COMMAND = Pattern.compile("\\./rsal ([a-z]+)");

    private static String readme() throws IOException {
        return Files.readString(ROOT.resolve("README.md"));
    }

    /// Keys of what ships; those of tests are not for users.
    private static <T> Set<String> installed(Class<T> kind, Function<T, String> key) {
        Map<String, T> all = Providers.byKey(kind, key);
        return all.entrySet().stream()
                .filter(one -> !one.getValue().getClass().getName().startsWith("rsal.testkit"))
                .map(Map.Entry::getKey)
                .collect(Collectors.toCollection(TreeSet::new));
    }

    private static List<MatchResult> rows() throws IOException {
        return ROW.matcher(readme()).results().toList();
    }

    @Test
    void whatItSaysToWorkWithIsInstalledAndAllThatIsInstalledIsThere() throws IOException {
        var said = new TreeSet<String>();
        for (MatchResult row : rows()) {
            List<String> keys =
                    KEY.matcher(row.group(2)).results().map(key -> key.group(1)).toList();
            if (!row.group(3).equals("yes")) {
                assertThat(keys).as(row.group()).isEmpty();
            }
            said.addAll(keys);
        }
        var installed = new TreeSet<String>();
        installed.addAll(installed(RobotSystemProvider.class, RobotSystemProvider::key));
        installed.addAll(installed(AgentHostProvider.class, AgentHostProvider::key));
        installed.addAll(installed(BridgeProvider.class, BridgeProvider::key));
        installed.remove("player-3.0"); // an older Player
        assertThat(said).isEqualTo(installed);
        assertThat(rows()).hasSizeGreaterThan(10);
    }

    @Test
    void eachOfItsCommandsExists() throws IOException {
        Set<String> commands = Main.commandLine(OutputStream.nullOutputStream())
                .getSubcommands()
                .keySet();
        Set<String> shown = COMMAND.matcher(readme())
                .results()
                .map(command -> command.group(1))
                .collect(Collectors.toCollection(TreeSet::new));
        assertThat(commands).containsAll(shown);
        assertThat(shown).contains("run", "test", "serve", "sweep");
    }

    @Test
    void theVersionIsTheSameEverywhere() throws IOException {
        String version = version();
        assertThat(Files.readString(ROOT.resolve("CITATION.cff"))).contains("\nversion: " + version + "\n");
        assertThat(Files.readString(ROOT.resolve("CHANGELOG.md"))).contains("\n## " + version);
        assertThat(Files.readString(ROOT.resolve("apps/release/src/main/java/rsal/release/Dist.java")))
                .contains(" VERSION = \"" + version + "\"");
        assertThat(readme()).contains("rsal-" + version + "-linux-x64.tar.gz");
        assertThat(Files.readString(ROOT.resolve("pom.xml"))).contains("<version>" + version + "-SNAPSHOT</version>");
    }

    /// A page that is loaded by people who only want to look.
    @Test
    void itsAnimationIsSmall() throws IOException {
        assertThat(Files.size(ROOT.resolve("docs/images/hunt.gif"))).isLessThan(3_000_000);
    }

    @Test
    void badgesAreTrue() throws IOException {
        String pom = Files.readString(ROOT.resolve("pom.xml"));
        assertThat(badge("version")).startsWith("version: " + version() + ",");
        assertThat(badge("license")).isEqualTo("license: Apache-2.0");
        assertThat(Files.readString(ROOT.resolve("LICENSE"))).contains("Apache License", "Version 2.0");
        assertThat(pom).contains("<java.version>25</java.version>");
        assertThat(badge("java")).isEqualTo("Java: 25 or newer");
    }

    private static String version() {
        return Build.name().replaceFirst("^rsal ", "").replaceFirst(" .*", "");
    }

    /// What a badge shows, which is what the README says of it to those who see no images.
    private static String badge(String name) throws IOException {
        String shown = Pattern.compile("aria-label=\"([^\"]+)\"")
                .matcher(Files.readString(ROOT.resolve("docs/images/badges/%s.svg".formatted(name))))
                .results()
                .map(label -> label.group(1))
                .findFirst()
                .orElseThrow();
        assertThat(readme()).contains("![%s](docs/images/badges/%s.svg)".formatted(shown, name));
        return shown;
    }
}
