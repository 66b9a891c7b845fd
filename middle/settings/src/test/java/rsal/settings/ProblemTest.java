package rsal.settings;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;

class ProblemTest {
    @Test
    void writesControlCharactersOut() {
        var problem = new Problem(Location.of("a.world"), "'\u001b[31m' is not allowed here.", "Bell\u0007?");
        assertThat(problem.toString()).isEqualTo("a.world: '\\u001b[31m' is not allowed here.\n    Bell\\u0007?");
    }

    @Test
    void areReportedAsTheyAreRead() {
        var typed = new Problem(Location.of("--set"), "d", "");
        var last = new Problem(new Location("a.yaml", 7, 3), "c", "");
        var first = new Problem(new Location("a.yaml", 2, 9), "a", "");
        var next = new Problem(new Location("a.yaml", 7, 1), "b", "");
        var included = new Problem(new Location("b.yaml", 1, 1), "e", "");
        var errors = new InvalidSettings(List.of(last, first, typed, next, included), List.of(last, first));
        assertThat(errors.problems()).containsExactly(first, next, last, typed, included);
        assertThat(errors.warnings()).containsExactly(first, last);
        assertThat(errors).hasMessage("""
                a.yaml:2:9: a
                a.yaml:7:1: b
                a.yaml:7:3: c
                --set: d
                b.yaml:1:1: e
                Warning: a.yaml:2:9: a
                Warning: a.yaml:7:3: c""");
    }

    @Test
    void filesBesideAnotherHaveItsFolder() {
        var errors = new InvalidSettings(List.of(
                new Problem(new Location("Hunter.java", 5, 1), "It is wrong.", ""),
                new Problem(new Location("lab/lab.yaml", 3, 1), "It is wrong.", ""),
                new Problem(Location.of("/rsal/Hunter.java"), "It is wrong.", "")));

        assertThat(errors.beside(new Location("lab/lab.yaml", 3, 9)).problems())
                .extracting(problem -> problem.location().toString())
                .containsExactly("lab/Hunter.java:5:1", "lab/lab.yaml:3:1", "/rsal/Hunter.java");
        assertThat(errors.beside(Location.of("lab.yaml"))).isSameAs(errors);
    }
}
