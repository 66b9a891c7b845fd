package rsal.navigation.control;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Map;
import org.junit.jupiter.api.Test;
import rsal.settings.Arguments;

class VfhControllerTypeTest {
    private final VfhControllerType vfh = new VfhControllerType();

    @Test
    void theWindowIsCountedInCells() {
        var given = Arguments.of(vfh.parameters(), Map.of("windowDiameter", 61, "cellSize", 0.1));
        assertThat(VfhOptions.settings(given, 1.4).lookahead()).isCloseTo(3.05, within(1e-9));
        assertThat(VfhOptions.settings(Arguments.defaults(vfh.parameters()), 1.4)
                        .lookahead())
                .isEqualTo(1.4);
    }

    @Test
    void weightsAreAsThePaperWantsThem() {
        assertThat(vfh.refusal(weights(5, 3, 2)).orElseThrow())
                .contains("to the target '5.0'", "'3.0'", "'2.0'", "Raise 'weightDesiredDir'");
        assertThat(vfh.refusal(weights(5, 3, 0))).as("Player's own").isEmpty();
        assertThat(vfh.refusal(Arguments.defaults(vfh.parameters()))).isEmpty();
    }

    private Arguments weights(double desired, double current, double previous) {
        return Arguments.of(
                vfh.parameters(),
                Map.of(
                        "weightDesiredDir", desired,
                        "weightCurrentDir", current,
                        "weightPreviousDir", previous));
    }
}
