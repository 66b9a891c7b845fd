package rsal.release;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Objects;
import java.util.Set;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/// What runs a release as a service, beside the rest of the project.
class ServiceFilesTest {
    private static final Pattern METRIC = Pattern.compile("\\b(rsal|process|jvm)_[a-z_]+");

    private static String text(String name) throws IOException {
        try (var in = Objects.requireNonNull(ServiceFilesTest.class.getResourceAsStream("unpacked/" + name))) {
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        }
    }

    @Test
    void theDashboardShowsMetricsThatThereAre() throws IOException {
        String there = Files.readString(Path.of("../../docs/how-to/metrics.md"));
        JsonNode panels = JsonMapper.shared()
                .readTree(text("container/grafana/rsal.json"))
                .path("panels");
        assertThat(panels).isNotEmpty();
        Set<String> shown = panels.findValuesAsString("expr").stream()
                .flatMap(expression -> METRIC.matcher(expression).results())
                .map(MatchResult::group)
                .map(name -> name.replaceFirst("_(bucket|sum|count)$", ""))
                .collect(Collectors.toSet());
        assertThat(shown)
                .hasSizeGreaterThan(10)
                .allSatisfy(name -> assertThat(there).contains("`" + name + "`"));
    }

    @Test
    void theServiceTakesItsEndForSuccess() throws IOException {
        assertThat(text("rsal.service"))
                .contains("\nSuccessExitStatus=143\n")
                .contains("\nExecStart=/opt/rsal/rsal serve ");
    }

    @Test
    void filesThatOthersNameAreThere() throws IOException {
        assertThat(text("container/compose.yaml")
                        .lines()
                        .map(String::strip)
                        .filter(line -> line.startsWith("- ./grafana/") || line.startsWith("- ./prometheus"))
                        .map(line -> line.replaceFirst("^- \\./([^:]+):.*", "container/$1")))
                .hasSize(4)
                .allSatisfy(name -> assertThat(text(name)).isNotEmpty());
    }
}
