package rsal.agent.presence;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import rsal.agent.Agent;
import rsal.agent.AgentContext;
import rsal.agent.message.PoseReport;
import rsal.agent.platform.Run;
import rsal.agent.presence.FailureDetector.Change;
import rsal.data.Pose2d;

class FailureDetectorTest {
    private static final Duration ROUND = Duration.ofSeconds(1);
    private static final Duration TIMEOUT = Duration.ofSeconds(4);

    private final Run run = new Run();
    private final List<Change> changes = new ArrayList<>();
    private final Set<String> silenced = new HashSet<>();

    FailureDetectorTest() {
        run.deliverBy((message, listener) -> silenced.contains(message.sender()) || silenced.contains(listener)
                ? List.of()
                : List.of(Duration.ZERO));
    }

    private void present(String name) {
        run.start(name, new Agent() {
            @Override
            public void start(AgentContext self) {
                Presence.begin(self);
            }

            @Override
            public void stop(AgentContext self) {
                Presence.end(self);
            }
        });
    }

    private void roll() {
        run.start("zoe", self -> new FailureDetector(self, ROUND, TIMEOUT, changes::add).begin());
    }

    private static FailureDetector.Member member(String name) {
        return new FailureDetector.Member(name, "");
    }

    @Test
    void thoseWhoWereThereBeforeAndThoseWhoComeLaterAreKnown() {
        present("amy");
        roll();
        run.advance(1);
        present("bob");
        run.advance(0);
        assertThat(changes).containsExactly(new Change.Appeared(member("amy")), new Change.Appeared(member("bob")));
    }

    @Test
    void oneThatFallsSilentIsMissedAndHeardAgain() {
        present("amy");
        roll();
        run.advance(10);
        silenced.add("amy");
        run.advance(3.9);
        assertThat(changes).hasSize(1);
        run.advance(2.1);
        assertThat(changes).hasSize(2).last().isInstanceOf(Change.FellSilent.class);
        silenced.clear();
        run.advance(1);
        assertThat(changes).hasSize(3).last().isEqualTo(new Change.CameBack(member("amy")));
    }

    @Test
    void oneThatSaysByeHasLeft() {
        present("amy");
        roll();
        run.advance(1);
        run.stop("amy");
        run.advance(20);
        assertThat(changes).containsExactly(new Change.Appeared(member("amy")), new Change.Left(member("amy")));
    }

    @Test
    void oneWhoseGreetingWasLostIsFoundByTheNextCall() {
        roll();
        run.advance(1);
        silenced.add("amy");
        present("amy");
        run.advance(2);
        silenced.clear();
        run.advance(10);
        assertThat(changes).containsExactly(new Change.Appeared(member("amy")));
    }

    @Test
    void oneThatReportsItsPoseIsNotAsked() {
        List<String> said = run.transcript();
        run.start("amy", self -> {
            Presence.begin(self);
            self.scheduler()
                    .every(
                            Duration.ofMillis(500),
                            () -> self.publish(PoseReport.TOPIC, new PoseReport("r1", "nav", new Pose2d(1, 2, 0))));
        });
        roll();
        run.advance(9.5);
        assertThat(said.stream().filter(line -> line.contains("-> amy")).toList())
                .isEmpty();
        assertThat(changes).hasSize(1);
    }

    @Test
    void lossOfEveryFifthMessageSilencesNobody() {
        var random = new SplittableRandom(7);
        run.deliverBy((_, _) -> random.nextDouble() < 0.2 ? List.of() : List.of(Duration.ZERO));
        for (int i = 0; i < 20; i++) {
            present("r" + i);
        }
        run.start("zoe", self -> new FailureDetector(self, ROUND, Duration.ofSeconds(10), changes::add).begin());
        run.advance(300);
        assertThat(changes).hasSize(20).allMatch(Change.Appeared.class::isInstance);
    }

    @Test
    void timeoutIsLongerThanARound() {
        run.start(
                "zoe",
                self -> assertThatThrownBy(() -> new FailureDetector(self, ROUND, ROUND, changes::add))
                        .hasMessageContaining("round < timeout"));
        run.advance(0);
    }
}
