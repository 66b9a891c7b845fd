package rsal.agent.protocol;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.agent.AgentContext;
import rsal.agent.Topic;
import rsal.agent.platform.AgentPlatform.Status;
import rsal.agent.platform.Run;
import rsal.agent.protocol.Request.Asked;

class RequestTest {
    private final Run run = new Run();
    private final List<ConversationResult<Integer>> endings = new ArrayList<>();

    private static Request<Integer, Integer> doubling(AgentContext self) {
        return new Request<>(self, "double", Integer.class, Integer.class);
    }

    private void servant(Consumer<Asked<Integer, Integer>> answer) {
        run.start("amy", self -> doubling(self).answer(answer));
    }

    private void asker(int question) {
        run.start("zoe", self -> doubling(self).ask("amy", question, endings::add));
    }

    @Test
    void whatIsQuickIsAnsweredAtOnce() {
        List<String> said = run.transcript();
        servant(asked -> asked.inform(2 * asked.what()));
        asker(21);
        run.advance(10);
        assertThat(endings).containsExactly(new ConversationResult.Informed<>(42));
        assertThat(said).containsExactly("zoe -> amy: request: 21", "amy -> zoe: inform: 42");
    }

    @Test
    void whatTakesLongIsAgreedToAndAskedAfter() {
        servant(asked -> {
            asked.agree();
            run.scheduler.after(Duration.ofSeconds(60), () -> asked.inform(2 * asked.what()));
        });
        asker(21);
        run.advance(59);
        assertThat(endings).isEmpty();
        run.advance(2);
        assertThat(endings).containsExactly(new ConversationResult.Informed<>(42));
    }

    @Test
    void oneMayRefuseOrFail() {
        servant(asked -> {
            if (asked.what() < 0) {
                asked.refuse("less than nothing");
            } else {
                asked.agree();
                asked.fail("too hard");
            }
        });
        asker(-1);
        run.start("bob", self -> doubling(self).ask("amy", 1, endings::add));
        run.advance(0);
        assertThat(endings)
                .containsExactly(
                        new ConversationResult.Refused<>("less than nothing"),
                        new ConversationResult.Failed<>("too hard"));
    }

    @Test
    void oneWhoIsNotThereIsSilent() {
        asker(1);
        run.advance(4.9);
        assertThat(endings).isEmpty();
        run.advance(1.2);
        assertThat(endings).hasSize(1).first().isInstanceOf(ConversationResult.Silent.class);
    }

    @Test
    void oneWhoNeverAnswersIsSilent() {
        servant(_ -> {});
        asker(1);
        run.advance(7);
        assertThat(endings).hasSize(1).first().isInstanceOf(ConversationResult.Silent.class);
    }

    @Test
    void oneWhoServesNothingOfThatKindSaysSo() {
        run.start("amy", RequestTest::doubling);
        asker(1);
        run.advance(0);
        assertThat(endings).containsExactly(new ConversationResult.NotUnderstood<>("'amy' does not answer 'double'."));
    }

    @Test
    void oneAskedForSomethingElseDoesNotUnderstand() {
        servant(asked -> asked.inform(1));
        run.start(
                "zoe",
                self -> new Request<>(self, "double", String.class, Integer.class).ask("amy", "three", endings::add));
        run.advance(0);
        assertThat(endings).hasSize(1).first().isInstanceOf(ConversationResult.NotUnderstood.class);
        assertThat(run.view("amy").status()).isEqualTo(Status.RUNNING);
    }

    @Test
    void oneWhoThrowsEndsAloneAndTheAskerLearnsItAtOnce() {
        servant(_ -> {
            throw new IllegalStateException("I broke.");
        });
        asker(1);
        run.advance(0);
        assertThat(endings).containsExactly(new ConversationResult.Silent<>("'amy' has ended."));
        assertThat(run.view("zoe").status()).isEqualTo(Status.RUNNING);
    }

    @Test
    void oneWhoAnswersTwiceIsEndedByName() {
        servant(asked -> {
            asked.inform(1);
            asked.inform(2);
        });
        asker(1);
        run.advance(0);
        assertThat(endings).containsExactly(new ConversationResult.Informed<>(1));
        assertThat(run.view("amy").status()).isEqualTo(Status.FAILED);
        assertThat(run.view("amy").state())
                .contains("'amy'")
                .contains("'inform'")
                .contains("'zoe'");
        assertThat(run.view("zoe").status()).isEqualTo(Status.RUNNING);
    }

    @Test
    void whatIsCancelledIsGivenUp() {
        var given = new ArrayList<String>();
        servant(asked -> {
            asked.agree();
            asked.whenUnwanted(() -> given.add("up"));
            run.scheduler.after(Duration.ofSeconds(2), () -> asked.inform(1));
        });
        run.start("zoe", self -> {
            Conversation asking = doubling(self).ask("amy", 1, endings::add);
            self.scheduler().after(Duration.ofSeconds(1), asking::cancel);
            self.scheduler().after(Duration.ofSeconds(5), asking::cancel);
        });
        List<String> said = run.transcript();
        run.advance(20);
        assertThat(given).containsExactly("up");
        assertThat(endings).containsExactly(new ConversationResult.Cancelled<>());
        assertThat(said).endsWith("zoe -> amy: cancel", "amy -> zoe: inform: cancelled");
        assertThat(run.view("zoe").status()).isEqualTo(Status.RUNNING);
        assertThat(run.view("amy").status()).isEqualTo(Status.RUNNING);
    }

    @Test
    void oneWhoseAskerHasGoneIsNotWantedAnyMore() {
        var given = new ArrayList<String>();
        servant(asked -> {
            asked.agree();
            asked.whenUnwanted(() -> given.add("up"));
        });
        asker(1);
        run.advance(1);
        run.stop("zoe");
        run.advance(0);
        assertThat(given).containsExactly("up");
    }

    @Test
    void oneMayAskItself() {
        run.start("amy", self -> {
            Request<Integer, Integer> request = doubling(self);
            request.answer(asked -> asked.inform(2 * asked.what()));
            request.ask("amy", 4, endings::add);
        });
        run.advance(0);
        assertThat(endings).containsExactly(new ConversationResult.Informed<>(8));
    }

    @Test
    void oneThatComesBackUnderItsNameBeginsNewConversations() {
        servant(asked -> asked.inform(2 * asked.what()));
        asker(1);
        run.advance(1);
        run.stop("zoe");
        asker(2);
        run.advance(1);
        assertThat(endings).containsExactly(new ConversationResult.Informed<>(2), new ConversationResult.Informed<>(4));
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.1, 0.3, 0.5})
    void inBadWeatherEachQuestionIsHeardOnceAndEndsOnce(double loss) {
        int informed = 0;
        for (int seed = 0; seed < 200; seed++) {
            var storm = new Run();
            storm.deliverBy(new Weather(new SplittableRandom(seed), loss, 0.2, Duration.ofMillis(400)));
            var heard = new ArrayList<Integer>();
            var ends = new ArrayList<ConversationResult<Integer>>();
            int working = seed % 5;
            storm.start(
                    "amy",
                    self -> doubling(self).answer(asked -> {
                        heard.add(asked.what());
                        asked.agree();
                        self.scheduler().after(Duration.ofSeconds(working), () -> asked.inform(2 * asked.what()));
                    }));
            int question = seed;
            storm.start("zoe", self -> doubling(self).ask("amy", question, ends::add));
            storm.advance(120);
            assertThat(ends).as("seed %d", seed).hasSize(1);
            assertThat(heard).as("seed %d", seed).hasSizeLessThanOrEqualTo(1);
            switch (ends.getFirst()) {
                case ConversationResult.Informed<Integer>(Integer result) -> {
                    assertThat(result).isEqualTo(2 * seed);
                    informed++;
                }
                case ConversationResult.Silent<Integer> _ -> {}
                default -> assertThat(ends).as("seed %d", seed).isEmpty();
            }
        }
        assertThat(informed).isGreaterThan(loss < 0.4 ? 190 : 140);
    }

    @Test
    void randomActsHarmNobody() {
        List<Performative> acts = List.of(Performative.values());
        for (int seed = 0; seed < 500; seed++) {
            var random = new SplittableRandom(seed);
            var fuzzed = new Run();
            fuzzed.start(
                    "amy",
                    self -> doubling(self).answer(asked -> {
                        switch (random.nextInt(4)) {
                            case 0 -> asked.inform(1);
                            case 1 -> asked.refuse("no");
                            case 2 -> asked.agree();
                            default -> {}
                        }
                    }));
            var id = new AtomicReference<>("x");
            fuzzed.start(
                    "zoe",
                    self -> id.set(doubling(self).ask("amy", 1, endings::add).id()));
            fuzzed.advance(0);
            for (int i = 0; i < 50; i++) {
                String sender = random.nextBoolean() ? "amy" : "zoe";
                fuzzed.send(
                        sender,
                        random.nextBoolean() ? "amy" : "zoe",
                        new Topic<>("double", Act.class),
                        new Act(
                                acts.get(random.nextInt(acts.size())),
                                "fipa-request",
                                random.nextInt(3) > 0 ? id.get() : "other" + random.nextInt(3),
                                random.nextBoolean() ? Side.INITIATOR : Side.PARTICIPANT,
                                random.nextInt(-1, 6),
                                random.nextInt(-1, 6),
                                Optional.empty(),
                                random.nextBoolean() ? (Object) 1 : "text"));
                fuzzed.advance(0.1);
            }
            fuzzed.advance(30);
            assertThat(fuzzed.view("amy").status())
                    .as("seed %d: %s", seed, fuzzed.view("amy").state())
                    .isEqualTo(Status.RUNNING);
            assertThat(fuzzed.view("zoe").status())
                    .as("seed %d: %s", seed, fuzzed.view("zoe").state())
                    .isEqualTo(Status.RUNNING);
        }
    }
}
