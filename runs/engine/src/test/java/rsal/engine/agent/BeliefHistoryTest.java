package rsal.engine.agent;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import rsal.agent.bdi.Mind.GoalState;
import rsal.agent.bdi.Mind.GoalView;
import rsal.engine.event.RunClock;
import rsal.engine.report.MindChange;
import rsal.engine.report.MindChange.Kind;
import rsal.engine.report.MindWords;

class BeliefHistoryTest {
    private static final long SECOND = 1_000_000_000L;

    private Instant now = Instant.EPOCH.plusSeconds(100);
    private final BeliefHistory beliefHistory = new BeliefHistory(RunClock.started(() -> now));
    private final Map<String, Map<String, String>> beliefs = new HashMap<>();
    private List<GoalView> goals = List.of();

    private Optional<MindWords> held(String agent) {
        return Optional.of(MindWords.of(new TreeMap<>(beliefs.getOrDefault(agent, Map.of())), goals));
    }

    private void look(String agent, long at) {
        beliefHistory.look(agent, held(agent).orElseThrow(), at);
    }

    private void step() {
        now = now.plusMillis(100);
        beliefHistory.step(this::held);
    }

    private static GoalView goal(String name, GoalState state, String... steps) {
        return new GoalView(name, state, 1, List.of(), List.of(steps), "");
    }

    private static MindChange change(int millis, Kind kind, String name, String words) {
        return new MindChange(Duration.ofMillis(millis), kind, name, words);
    }

    @Test
    void reportsWhatAnAgentDidThoughNobodyLooked() {
        now = now.plusSeconds(1);
        beliefHistory.does("ann", "searching");
        beliefHistory.does("bob", "waiting");
        assertThat(beliefHistory.of("ann")).containsExactly(change(1000, Kind.DOES, "", "searching"));
        assertThat(beliefHistory.of("nobody")).isEmpty();
    }

    @Test
    void reportsStepByStepWhatChangedSinceSomebodyLooked() {
        beliefs.put("ann", Map.of("fuel", "3", "load", "none"));
        goals = List.of(goal("fetch", GoalState.WAITING), goal("rest", GoalState.NOT_WANTED));
        step(); // nobody looks
        look("ann", 0);
        step(); // nothing is another
        beliefs.put("ann", Map.of("fuel", "2"));
        step();
        goals = List.of(goal("fetch", GoalState.PURSUED, "fetch: near", "go: there"));
        step();

        assertThat(beliefHistory.of("ann"))
                .containsExactly(
                        change(300, Kind.BELIEVES, "fuel", "2"),
                        change(300, Kind.BELIEVES, "load", ""),
                        change(400, Kind.WANTS, "fetch", "pursued: fetch: near > go: there"),
                        change(400, Kind.WANTS, "rest", ""));
    }

    @Test
    void looksNoMoreWhenNobodyAsks() {
        look("ann", 0);
        look("bob", 2 * SECOND);
        beliefHistory.beat(4 * SECOND);
        beliefs.put("ann", Map.of("fuel", "2"));
        beliefs.put("bob", Map.of("fuel", "2"));
        step();
        assertThat(beliefHistory.of("ann")).isEmpty();
        assertThat(beliefHistory.of("bob")).hasSize(1);
    }

    @Test
    void whatChangesAlwaysLeavesWhatChangedOnce() {
        beliefs.put("ann", Map.of("pose", "0"));
        look("ann", 0);
        beliefs.put("ann", Map.of("pose", "0", "load", "can"));
        step();
        for (int i = 1; i <= 1000; i++) {
            beliefs.put("ann", Map.of("pose", "" + i, "load", "can"));
            step();
        }
        assertThat(beliefHistory.of("ann"))
                .hasSize(1 + BeliefHistory.MOST_OF_A_NAME)
                .startsWith(change(100, Kind.BELIEVES, "load", "can"))
                .endsWith(change(100_100, Kind.BELIEVES, "pose", "1000"));
    }

    @Test
    void looksIntoAFewAtATime() {
        for (int i = 0; i < 3 * BeliefHistory.MOST_LOOKED_INTO; i++) {
            look("agent " + i, i);
        }
        for (int i = 0; i < 3 * BeliefHistory.MOST_LOOKED_INTO; i++) {
            beliefs.put("agent " + i, Map.of("fuel", "2"));
        }
        step();
        assertThat(beliefHistory.of("agent 0")).isEmpty();
        assertThat(beliefHistory.of("agent " + (3 * BeliefHistory.MOST_LOOKED_INTO - 1)))
                .hasSize(1);
    }

    @Test
    void keepsWhatItKnewOfOneThatCantReport() {
        beliefs.put("ann", Map.of("fuel", "3"));
        look("ann", 0);
        beliefHistory.step(_ -> Optional.empty());
        step();
        assertThat(beliefHistory.of("ann")).isEmpty();
    }
}
