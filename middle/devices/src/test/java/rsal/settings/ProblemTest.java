package rsal.settings;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class ProblemTest {
    @Test
    void writesControlCharactersOut() {
        var problem = new Problem(Location.of("a.world"), "(\u001b[31m) means nothing here.", "Bell\u0007?");
        assertThat(problem.toString()).isEqualTo("a.world: (\\u001b[31m) means nothing here.\n    Bell\\u0007?");
    }
}
