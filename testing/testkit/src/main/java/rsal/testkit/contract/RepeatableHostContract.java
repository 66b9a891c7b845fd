package rsal.testkit.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/// What an agent host that follows simulated time owes besides: all happens in one order, at exact instants, and equal
/// runs are equal.
public abstract class RepeatableHostContract extends AgentHostContract {
    private static long millis(HostRun run) {
        return run.scheduler().instant().toEpochMilli();
    }

    @Test
    void followsSimulatedTime() {
        assertThat(provider().followsSchedulerTime()).isTrue();
    }

    @Test
    void agentsBeginInTheOrderInWhichTheyAreStarted() {
        try (var run = run()) {
            run.start("zoe", self -> log.add(self.name()));
            run.start("amy", self -> log.add(self.name()));
            run.pass(0);
        }
        assertThat(log).containsExactly("zoe", "amy");
    }

    @Test
    void tasksRunAtTheInstantAtWhichTheyAreDue() {
        try (var run = run()) {
            long begin = millis(run);
            run.start("amy", self -> {
                self.scheduler().after(Duration.ofMillis(200), () -> log.add("200 at " + (millis(run) - begin)));
                self.scheduler().every(Duration.ofMillis(100), () -> log.add("beat at " + (millis(run) - begin)));
                self.scheduler().execute(() -> log.add("executed at " + (millis(run) - begin)));
                log.add("begun at " + (millis(run) - begin));
            });
            run.pass(250);
        }
        assertThat(log).containsExactly("begun at 0", "executed at 0", "beat at 100", "200 at 200", "beat at 200");
    }

    @Test
    void allHearInTheOrderInWhichTheySubscribedAtTheInstantItIsSaid() {
        try (var run = run()) {
            long begin = millis(run);
            for (String name : List.of("zoe", "amy", "bob")) {
                run.start(name, self -> {
                    self.subscribe(
                            WORDS, m -> log.add(name + " heard " + m.content() + " at " + (millis(run) - begin)));
                });
            }
            run.start("eve", self -> self.scheduler().after(Duration.ofMillis(300), () -> self.publish(WORDS, "hi")));
            run.pass(1000);
        }
        assertThat(log).containsExactly("zoe heard hi at 300", "amy heard hi at 300", "bob heard hi at 300");
    }

    @Test
    void sameSeedsGiveTheSameTalk() {
        assertThat(talkOfAHundred()).isEqualTo(talkOfAHundred()).hasSizeGreaterThan(1000);
    }

    private List<String> talkOfAHundred() {
        var said = new ArrayList<String>();
        try (var run = run()) {
            run.act(() -> run.platform().onMessage(m -> said.add(millis(run) + " " + m.sender() + " " + m.content())));
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
            run.pass(5000);
        }
        return said;
    }
}
