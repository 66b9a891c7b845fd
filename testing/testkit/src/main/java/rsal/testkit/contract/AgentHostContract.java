package rsal.testkit.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import rsal.agent.Agent;
import rsal.agent.AgentContext;
import rsal.agent.AgentHostProvider;
import rsal.agent.AgentSpec;
import rsal.agent.Society;
import rsal.agent.Society.Status;
import rsal.agent.Topic;
import rsal.settings.Arguments;
import rsal.testkit.fake.TestedType;
import rsal.time.LockstepScheduler;

/// What every agent host that follows simulated time must do: agents on it start, hear, wait and end alike.
public abstract class AgentHostContract {
    private static final Topic<String> WORDS = new Topic<>("words", String.class);

    /// The host under test, set up with its fallbacks.
    protected abstract AgentHostProvider provider();

    private final List<String> log = new ArrayList<>();

    @Test
    void hasAKeyAndFollowsSimulatedTime() {
        assertThat(provider().key()).isNotBlank();
        assertThat(provider().followsSchedulerTime()).isTrue();
    }

    @Test
    void agentsBeginInTheOrderInWhichTheyAreStarted() {
        try (var run = new Run()) {
            run.start("zoe", self -> log.add(self.name()));
            run.start("amy", self -> log.add(self.name()));
            run.advance(0);
        }
        assertThat(log).containsExactly("zoe", "amy");
    }

    @Test
    void tasksRunWhenTheyAreDueAndInOrder() {
        try (var run = new Run()) {
            run.start("amy", self -> {
                self.scheduler().after(Duration.ofMillis(200), () -> log.add("200 at " + run.millis()));
                self.scheduler().every(Duration.ofMillis(100), () -> log.add("beat at " + run.millis()));
                self.scheduler().execute(() -> log.add("executed at " + run.millis()));
                log.add("begun at " + run.millis());
            });
            run.advance(250);
        }
        assertThat(log).containsExactly("begun at 0", "executed at 0", "beat at 100", "200 at 200", "beat at 200");
    }

    @Test
    void allHearInTheOrderInWhichTheySubscribedAtTheInstantItIsSaid() {
        try (var run = new Run()) {
            for (String name : List.of("zoe", "amy", "bob")) {
                run.start(name, self -> {
                    self.subscribe(WORDS, m -> log.add(name + " heard " + m.content() + " at " + run.millis()));
                });
            }
            run.start("eve", self -> self.scheduler().after(Duration.ofMillis(300), () -> self.publish(WORDS, "hi")));
            run.advance(1000);
        }
        assertThat(log).containsExactly("zoe heard hi at 300", "amy heard hi at 300", "bob heard hi at 300");
    }

    @Test
    void oneThatThrowsEndsAlone() {
        try (var run = new Run()) {
            run.start("amy", self -> self.scheduler().every(Duration.ofMillis(100), () -> log.add("amy lives")));
            run.start("bob", self -> {
                self.scheduler().every(Duration.ofMillis(100), () -> log.add("bob lives"));
                self.scheduler().after(Duration.ofMillis(150), () -> {
                    throw new IllegalStateException("a slip");
                });
            });
            run.advance(250);
            assertThat(run.society.views())
                    .extracting(Society.View::status)
                    .containsExactly(Status.RUNNING, Status.FAILED);
        }
        assertThat(log).containsExactly("amy lives", "bob lives", "amy lives");
    }

    @Test
    void nothingOfAStoppedAgentRuns() {
        try (var run = new Run()) {
            run.start("amy", new Agent() {
                @Override
                public void start(AgentContext self) {
                    self.subscribe(WORDS, _ -> log.add("heard"));
                    self.scheduler().every(Duration.ofMillis(100), () -> log.add("beat"));
                }

                @Override
                public void stop(AgentContext self) {
                    log.add("stopped");
                }
            });
            run.advance(100);
            run.society.stop("amy");
            run.society.publish("operator", WORDS, "hi");
            run.advance(500);
        }
        assertThat(log).containsExactly("beat", "stopped");
    }

    @Test
    void oneMayStartAgainUnderItsName() {
        try (var run = new Run()) {
            run.start("amy", _ -> log.add("first"));
            run.advance(0);
            run.society.stop("amy");
            run.start("amy", _ -> log.add("second"));
            run.advance(0);
        }
        assertThat(log).containsExactly("first", "second");
    }

    @Test
    void closingStopsAll() {
        var run = new Run();
        run.start("amy", self -> self.atEnd(() -> log.add("amy")));
        run.start("bob", self -> self.atEnd(() -> log.add("bob")));
        run.advance(0);
        run.close();
        assertThat(log).containsExactly("bob", "amy");
    }

    @Test
    void sameSeedsGiveTheSameTalk() {
        assertThat(talkOfAHundred()).isEqualTo(talkOfAHundred()).hasSizeGreaterThan(1000);
    }

    private List<String> talkOfAHundred() {
        var said = new ArrayList<String>();
        try (var run = new Run()) {
            run.society.onMessage(m -> said.add(run.millis() + " " + m.sender() + " " + m.content()));
            for (int i = 0; i < 100; i++) {
                run.start("agent-" + i, self -> {
                    var pause = Duration.ofMillis(100 + self.random().nextInt(900));
                    self.scheduler()
                            .every(
                                    pause,
                                    () -> self.publish(WORDS, "" + self.random().nextInt()));
                    self.subscribe(WORDS, m -> {
                        if (self.random().nextInt(500) == 0) {
                            self.publish(WORDS, "to " + m.sender());
                        }
                    });
                });
            }
            run.advance(5000);
        }
        return said;
    }

    private final class Run implements AutoCloseable {
        final LockstepScheduler scheduler = new LockstepScheduler();
        final Society society = new Society(
                scheduler, provider().create(Arguments.defaults(provider().parameters()), scheduler), Optional.empty());

        void start(String name, Agent agent) {
            society.start(new AgentSpec(
                    name,
                    "tested",
                    new TestedType(agent),
                    Arguments.defaults(List.of()),
                    Optional.empty(),
                    name.hashCode()));
        }

        void advance(long millis) {
            scheduler.advance(Duration.ofMillis(millis));
        }

        long millis() {
            return scheduler.elapsed().toMillis();
        }

        @Override
        public void close() {
            society.close();
        }
    }
}
