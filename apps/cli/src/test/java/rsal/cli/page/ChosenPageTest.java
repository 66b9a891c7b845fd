package rsal.cli.page;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;

class ChosenPageTest {
    @Test
    void theOnlyPageIsMeant() {
        assertThat(ChosenPage.among(List.of())).isEqualTo(new ChosenPage(8735, Optional.empty()));
        assertThat(ChosenPage.among(List.of(40321))).isEqualTo(new ChosenPage(40321, Optional.empty()));
    }

    @Test
    void ofSeveralTheOneAtTheUsualPortIsMeantAndTheOthersAreNamed() {
        ChosenPage chosen = ChosenPage.among(List.of(8735, 40321));
        assertThat(chosen.port()).isEqualTo(8735);
        assertThat(chosen.note().orElseThrow()).contains("8735, 40321", "for the run at 8735");
    }

    @Test
    void ofSeveralAtOtherPortsOneMustBeChosen() {
        assertThatThrownBy(() -> ChosenPage.among(List.of(40000, 40321)))
                .hasMessage(
                        "There are several runs with a page on this machine, at the ports 40000, 40321. Choose one: --port 40000.");
    }
}
