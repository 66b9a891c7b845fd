package rsal.jadex.hunt;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import rsal.agent.AgentSpec;
import rsal.agent.Society;
import rsal.agent.plain.PlainHostProvider;
import rsal.settings.Arguments;
import rsal.time.LockstepScheduler;

class JadexHunterTest {
    @Test
    void saysWhereItBelongsWhenItIsOnAnotherHost() {
        var time = new LockstepScheduler();
        var host = new PlainHostProvider().create(Arguments.defaults(List.of()), time);
        var society = new Society(time, host, Optional.empty());
        var type = new JadexHunter();
        society.start(
                new AgentSpec("follow-1", "follow", type, Arguments.defaults(type.parameters()), Optional.empty(), 1));
        time.advance(Duration.ofSeconds(1));
        assertThat(society.views()).singleElement().satisfies(view -> {
            assertThat(view.status()).isEqualTo(Society.Status.FAILED);
            assertThat(view.state())
                    .isEqualTo("Agent (follow-1) thinks by Jadex and needs its host."
                            + " Maybe run it by '--mas jadex --clock wall'.");
        });
    }
}
