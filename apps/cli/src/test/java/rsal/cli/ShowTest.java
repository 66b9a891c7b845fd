package rsal.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ShowTest {
    private static String show(String... line) {
        var out = new ByteArrayOutputStream();
        var rsal = Main.commandLine(out);
        assertThat(rsal.execute(line)).isEqualTo(Exit.SUCCESS);
        rsal.getOut().flush();
        return out.toString(StandardCharsets.UTF_8);
    }

    @ParameterizedTest
    @ValueSource(strings = {"patrol", "rescue"})
    void aScenarioComesBeforeAnAgentOfItsName(String name) {
        assertThat(show("show", name))
                .contains("Configurations", "Measures")
                .endsWith("\n(%s) is also a type of agents: rsal show agent:%s\n".formatted(name, name));
        assertThat(show("show", "agent:" + name))
                .startsWith(name + ": a type of agents\n")
                .doesNotContain("Measures");
        assertThat(show("show", name, "--json")).startsWith("{\"scenario\":\"%s\"".formatted(name));
    }
}
