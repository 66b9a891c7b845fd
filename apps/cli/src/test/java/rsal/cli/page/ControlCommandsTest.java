package rsal.cli.page;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import rsal.cli.page.ControlCommands.Controlled;
import rsal.cli.terminal.Unreachable;

class ControlCommandsTest {
    private final List<String> done = new ArrayList<>();

    private String refuse(String why) {
        done.add("refused");
        throw new Unreachable(why);
    }

    @Test
    void controlIsGivenBack() throws InterruptedException {
        assertThat(Controlled.andThen(() -> "answer", () -> done.add("back"))).isEqualTo("answer");
        assertThat(done).containsExactly("back");
    }

    @Test
    void controlIsGivenBackAlsoWhenTheCommandIsRefused() {
        assertThatThrownBy(() -> Controlled.andThen(() -> refuse("The run is over."), () -> done.add("back")))
                .hasMessage("The run is over.");
        assertThat(done).containsExactly("refused", "back");
    }

    @Test
    void whyACommandWasRefusedIsToldAlsoWhenControlCannotBeGivenBack() {
        assertThatThrownBy(() -> Controlled.andThen(() -> refuse("The run is over."), () -> refuse("Nobody is there.")))
                .hasMessage("The run is over.")
                .hasSuppressedException(new Unreachable("Nobody is there."));
    }

    @Test
    void thatControlCannotBeGivenBackIsTold() {
        assertThatThrownBy(() -> Controlled.andThen(() -> "answer", () -> refuse("Nobody is there.")))
                .hasMessage("Nobody is there.");
    }
}
