package rsal.agent.platform;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import org.junit.jupiter.api.Test;

class AgentTurnsTest {
    private final AgentTurns turns = new AgentTurns();

    @Test
    void reportsWhoseTurnItIsAndWhichOne() {
        AgentTurns.Turn amy = turns.of("amy");
        AgentTurns.Turn bob = turns.of("bob");
        assertThat(turns.inProgress()).isEmpty();
        assertThat(bob.begin()).isTrue();
        long first = turns.inProgress().get("bob");
        assertThat(amy.begin()).isTrue();
        assertThat(turns.inProgress()).containsOnlyKeys("amy", "bob");
        bob.end();
        assertThat(turns.inProgress()).containsOnlyKeys("amy");
        assertThat(bob.begin()).isTrue();
        assertThat(turns.inProgress().get("bob")).isNotEqualTo(first);
    }

    @Test
    void aTurnWithinATurnIsNoOther() {
        AgentTurns.Turn amy = turns.of("amy");
        assertThat(amy.begin()).isTrue();
        long turn = turns.inProgress().get("amy");
        assertThat(amy.begin()).isFalse();
        assertThat(turns.inProgress()).containsEntry("amy", turn);
        amy.end();
        assertThat(turns.inProgress()).isEmpty();
    }

    @Test
    void reportsWhoseCodeRunsWhere() throws InterruptedException {
        assertThat(turns.thread("amy")).isEmpty();
        AgentTurns.Turn amy = turns.of("amy");
        Thread other = Thread.ofPlatform().start(() -> {
            amy.begin();
            amy.end();
        });
        other.join();
        assertThat(turns.thread("amy")).contains(other);
        assertThat(amy.isHere()).isFalse();
        amy.begin();
        assertThat(turns.thread("amy")).contains(Thread.currentThread());
        assertThat(amy.isHere()).isTrue();
    }

    @Test
    void anAgentIsAtWorkOnlyWhileItsCodeRuns() {
        var run = new Run();
        var seen = new ArrayList<String>();
        run.start(
                "amy",
                self -> self.scheduler()
                        .execute(() ->
                                seen.add("" + run.platform.turns().inProgress().keySet())));
        run.advance(1);
        assertThat(seen).containsExactly("[amy]");
        assertThat(run.platform.turns().inProgress()).isEmpty();
    }
}
