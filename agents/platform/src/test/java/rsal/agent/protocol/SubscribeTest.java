package rsal.agent.protocol;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import rsal.agent.AgentContext;
import rsal.agent.platform.AgentPlatform.Status;
import rsal.agent.platform.Run;
import rsal.agent.protocol.Subscribe.Subscriber;

class SubscribeTest {
    private final Run run = new Run();
    private final List<Integer> news = new ArrayList<>();
    private final List<ConversationResult<Integer>> endings = new ArrayList<>();

    private static Subscribe<String, Integer> count(AgentContext self) {
        return new Subscribe<>(self, "count", String.class, Integer.class);
    }

    /// Counts up, a number each second.
    private static void teller(Run run, int last) {
        run.start(
                "amy",
                self -> count(self).answer(subscriber -> {
                    if (subscriber.what().isEmpty()) {
                        subscriber.refuse("of what?");
                        return;
                    }
                    subscriber.agree();
                    publish(self, subscriber, 1, last);
                }));
    }

    private static void publish(AgentContext self, Subscriber<String, Integer> subscriber, int number, int last) {
        self.scheduler().after(Duration.ofSeconds(1), () -> {
            if (number > last) {
                subscriber.fail("that is all");
            } else {
                subscriber.inform(number);
                publish(self, subscriber, number + 1, last);
            }
        });
    }

    @Test
    void newsComeUntilThereAreNoMore() {
        teller(run, 3);
        run.start("zoe", self -> count(self).subscribe("amy", "sheep", news::add, endings::add));
        run.advance(10);
        assertThat(news).containsExactly(1, 2, 3);
        assertThat(endings).containsExactly(new ConversationResult.Failed<>("that is all"));
    }

    @Test
    void newsComeUntilTheyAreNotWanted() {
        teller(run, 100);
        run.start("zoe", self -> {
            Conversation sheep = count(self).subscribe("amy", "sheep", news::add, endings::add);
            self.scheduler().after(Duration.ofMillis(2500), sheep::cancel);
        });
        run.advance(10);
        assertThat(news).containsExactly(1, 2);
        assertThat(endings).containsExactly(new ConversationResult.Cancelled<>());
        assertThat(run.view("amy").status()).isEqualTo(Status.RUNNING);
    }

    @Test
    void tellerMayRefuse() {
        teller(run, 1);
        run.start("zoe", self -> count(self).subscribe("amy", "", news::add, endings::add));
        run.advance(1);
        assertThat(endings).containsExactly(new ConversationResult.Refused<>("of what?"));
    }

    @Test
    void tellerThatGoesIsMissed() {
        teller(run, 100);
        run.start("zoe", self -> count(self).subscribe("amy", "sheep", news::add, endings::add));
        run.advance(3);
        run.stop("amy");
        run.advance(0);
        assertThat(endings).containsExactly(new ConversationResult.Silent<>("'amy' has ended."));
    }

    @Test
    void inBadWeatherAllNewsComeOnceAndInOrder() {
        int complete = 0;
        for (int seed = 0; seed < 100; seed++) {
            var storm = new Run();
            storm.deliverBy(new Weather(new SplittableRandom(seed), 0.25, 0.2, Duration.ofMillis(900)));
            var heard = new ArrayList<Integer>();
            var ends = new ArrayList<ConversationResult<Integer>>();
            teller(storm, 40);
            storm.start("zoe", self -> count(self).subscribe("amy", "sheep", heard::add, ends::add));
            storm.advance(120);
            assertThat(heard)
                    .as("seed %d", seed)
                    .isEqualTo(IntStream.rangeClosed(1, heard.size()).boxed().toList());
            assertThat(ends).as("seed %d", seed).hasSize(1);
            complete += heard.size() == 40 ? 1 : 0;
        }
        assertThat(complete).isGreaterThan(80);
    }

    @Test
    void oneWhoIsTooFarBehindIsGivenUp() {
        run.deliverBy((message, listener) ->
                listener.equals("amy") || message.sender().equals("zoe") ? List.of(Duration.ZERO) : List.of());
        var unwanted = new ArrayList<String>();
        run.start(
                "amy",
                self -> count(self).answer(subscriber -> {
                    subscriber.whenUnwanted(() -> unwanted.add("given up"));
                    for (int i = 0; i < 2_000; i++) {
                        subscriber.inform(i);
                    }
                }));
        run.start("zoe", self -> count(self).subscribe("amy", "sheep", news::add, endings::add));
        run.advance(1);
        assertThat(unwanted).containsExactly("given up");
        assertThat(run.view("amy").status()).isEqualTo(Status.RUNNING);
    }
}
