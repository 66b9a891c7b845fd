package rsal.bench.robots;

import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;

class WholeRunTest {
    @Test
    void runThatEndedEarlyIsNotMeasured() {
        String result = "patrol:virtual, seed 1\n  outcome  limit\n  time     60.0 s simulated in 9.1 s\n";
        assertThatCode(() -> WholeRun.checkLength("patrol", 60, result)).doesNotThrowAnyException();
        assertThatThrownBy(() -> WholeRun.checkLength("patrol", 300, result)).hasMessageContaining("'300.0' s");
        assertThatThrownBy(() -> WholeRun.checkLength("patrol", 60, "")).hasMessageContaining("'patrol'");
    }
}
