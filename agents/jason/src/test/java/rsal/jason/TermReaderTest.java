package rsal.jason;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import org.junit.jupiter.api.Test;

class TermReaderTest {
    private final TermReader reader = new TermReader(new Reasoner());

    @Test
    void readsOneTextAfterTheOther() {
        assertThat(reader.read("pose(1,2,3)")).hasToString("pose(1,2,3)");
        assertThat(reader.read("[a,\"b\",{ +!go(X) <- stop }]")).matches(term -> term.isList());
        assertThat(reader.read("ns::b(x)[c]")).hasToString("ns::b(x)[c]");
        assertThat(reader.read("b(x)")).hasToString("b(x)");
    }

    @Test
    void readsOnAfterWhatIsNoTerm() {
        for (String none : new String[] {"pose(1,", "pose(1) pose(2)", "\"open", "[a|b", "#"}) {
            assertThatIllegalArgumentException().isThrownBy(() -> reader.read(none));
            assertThat(reader.read("pose(1)")).hasToString("pose(1)");
        }
    }
}
