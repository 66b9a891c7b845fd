package rsal.jade;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class JadeNamesTest {
    private final JadeHostProvider jade = new JadeHostProvider();

    @ParameterizedTest
    @ValueSource(strings = {"df", "DF", "ams", "rma", "Sniffer", "introspector"})
    void thoseOfJadesOwnAgentsAreTaken(String name) {
        assertThat(jade.nameProblem(name, List.of()).orElseThrow()).contains("JADE has an agent");
    }

    @Test
    void thoseThatDifferInCaseOnlyAreNotDistinguished() {
        assertThat(jade.nameProblem("bob", List.of("ann", "Bob")).orElseThrow()).contains("'Bob' and 'bob'");
        assertThat(jade.nameProblem("bob", List.of("ann", "bob-1"))).isEmpty();
    }
}
