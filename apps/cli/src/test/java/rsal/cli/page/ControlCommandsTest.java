package rsal.cli.page;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import rsal.cli.page.ControlCommands.Controlled;
import rsal.cli.terminal.Unreachable;
import tools.jackson.databind.json.JsonMapper;

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
    void whyACommandWasRefusedIsReportedAlsoWhenControlCannotBeGivenBack() {
        assertThatThrownBy(() -> Controlled.andThen(() -> refuse("The run is over."), () -> refuse("Nobody is there.")))
                .hasMessage("The run is over.")
                .hasSuppressedException(new Unreachable("Nobody is there."));
    }

    @Test
    void thatControlCannotBeGivenBackIsReported() {
        assertThatThrownBy(() -> Controlled.andThen(() -> "answer", () -> refuse("Nobody is there.")))
                .hasMessage("Nobody is there.");
    }

    @Test
    void aStatusListsRobotsAndAgents() {
        assertThat(ControlCommands.Status.text(JsonMapper.shared().readTree("""
                {"scenario": "hunt", "configuration": "virtual", "seed": "7", "time": 12.34, "paused": false,
                 "stopped": false, "outcome": "", "goals": [],
                 "robots": [{"id": "hunter-1", "x": 1, "y": 2, "heading": 0, "gone": false, "stopped": false,
                             "inCharge": "navigator"}],
                 "agents": [{"name": "hunter-1", "robot": "hunter-1", "status": "RUNNING", "state": "follows"},
                            {"name": "chief", "robot": "", "status": "FAILED", "state": "no plan"},
                            {"name": "clerk", "robot": "", "status": "ENDED", "state": ""}]}
                """)))
                .isEqualTo("""
                hunt:virtual, seed 7: runs at 12.3 s
                Robots
                  hunter-1   (1.00, 2.00, 0°)   navigator
                Agents
                  hunter-1   follows
                  chief      failed: no plan
                  clerk      ended
                """);
    }
}
