package rsal.agent.platform;

import static org.assertj.core.api.Assertions.assertThat;
import static rsal.agent.platform.Run.WORDS;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import rsal.agent.ChannelModel;
import rsal.agent.Interest;
import rsal.agent.Message;
import rsal.device.Subscription;

class ChannelModelTest {
    private final Run run = new Run();
    private final List<String> log = new ArrayList<>();

    private void startSpeaker(String name, String... words) {
        run.start(
                name,
                self -> self.scheduler().after(Duration.ofSeconds(1), () -> {
                    for (String each : words) {
                        self.publish(WORDS, each);
                    }
                }));
    }

    private void startListener(String name) {
        run.startListener(name, words -> log.add(name + " heard " + words + " at " + run.scheduler.elapsed()));
    }

    @Test
    void decidesForEachListenerWhetherAndWhenAMessageArrives() {
        startListener("amy");
        startListener("zoe");
        startListener("joe");
        startSpeaker("bob", "hi");
        run.platform.deliverBy((_, listener) -> switch (listener) {
            case "amy" -> List.of();
            case "zoe" -> List.of(Duration.ofSeconds(2));
            default -> List.of(Duration.ZERO, Duration.ofSeconds(1));
        });
        run.advance(5);
        assertThat(log)
                .containsExactly("joe heard bob: hi at PT1S", "joe heard bob: hi at PT2S", "zoe heard bob: hi at PT3S");
    }

    @Test
    void isAskedOnceForAllListenersOfAnAgent() {
        var asked = new ArrayList<String>();
        run.start("amy", self -> {
            self.subscribe(WORDS, m -> log.add("one: " + m.content()));
            self.subscribe(WORDS, m -> log.add("two: " + m.content()));
        });
        startSpeaker("bob", "hi", "hi");
        run.platform.deliverBy((message, listener) -> {
            asked.add(message.sender() + " to " + listener);
            return asked.size() == 1 ? List.of() : ChannelModel.AT_ONCE;
        });
        run.advance(2);
        assertThat(asked).containsExactly("bob to amy", "bob to amy"); // two messages, though they are equal
        assertThat(log).containsExactly("one: hi", "two: hi");
    }

    @Test
    void isAskedAgainWhenACopyArrivesLate() {
        startListener("amy");
        startListener("zoe");
        startSpeaker("bob", "hi");
        run.platform.deliverBy(new ChannelModel() {
            @Override
            public List<Duration> copies(Message<?> message, String listener) {
                return List.of(Duration.ofSeconds(1));
            }

            @Override
            public boolean reaches(Message<?> message, String listener) {
                log.add("asked at " + run.scheduler.elapsed());
                return listener.equals("zoe");
            }
        });
        run.advance(3);
        assertThat(log).containsExactly("asked at PT2S", "asked at PT2S", "zoe heard bob: hi at PT2S");
    }

    @Test
    void whatComesLateIsNotHeardByOneThatHasEnded() {
        startListener("amy");
        startSpeaker("bob", "hi");
        run.platform.deliverBy((_, _) -> List.of(Duration.ofSeconds(2)));
        run.advance(2);
        run.platform.stop("amy");
        run.advance(2);
        assertThat(log).isEmpty();
    }

    @Test
    void peopleHearWhatIsSaidAnyway() {
        var said = new ArrayList<Object>();
        run.platform.onMessage(message -> said.add(message.content()));
        startListener("amy");
        startSpeaker("bob", "hi");
        run.platform.deliverBy((_, _) -> List.of());
        run.advance(2);
        assertThat(said).containsExactly("hi");
        assertThat(log).isEmpty();
    }

    @Test
    void isReportedOnceWhenAnAgentHearsAtOnceWithSeveralEars() {
        run.start("amy", self -> {
            self.subscribe(WORDS, _ -> {});
            self.subscribe(WORDS, _ -> {});
        });
        startSpeaker("bob", "hi", "hi");
        run.platform.deliverBy(new ChannelModel() {
            @Override
            public List<Duration> copies(Message<?> message, String listener) {
                return AT_ONCE;
            }

            @Override
            public void heard(Message<?> message, String listener) {
                log.add(listener + " hears " + message.content());
            }
        });
        run.advance(2);
        assertThat(log).containsExactly("amy hears hi", "amy hears hi"); // two messages, though they are equal
    }

    @Test
    void whoeverIsStoppedByOneWhoHeardBeforeHearsNoMore() {
        run.startListener("amy", _ -> run.platform.stop("zoe"));
        startListener("zoe");
        startListener("joe");
        startSpeaker("bob", "hi");
        run.advance(2);
        assertThat(log).containsExactly("joe heard bob: hi at PT1S");
    }

    @Test
    void anEarThatTheOneBeforeItClosesHearsNoMore() {
        run.start("amy", self -> {
            var second = new ArrayList<Subscription>();
            self.subscribe(WORDS, m -> {
                log.add("one: " + m.content());
                second.forEach(Subscription::cancel);
            });
            second.add(self.subscribe(WORDS, m -> log.add("two: " + m.content())));
        });
        startListener("zoe");
        startSpeaker("bob", "hi");
        run.advance(2);
        assertThat(log).containsExactly("one: hi", "zoe heard bob: hi at PT1S");
    }

    @Test
    void thoseAfterOneThatFailsHearAllTheSame() {
        run.startListener("amy", _ -> {
            throw new IllegalStateException("too loud");
        });
        startListener("zoe");
        startSpeaker("bob", "hi");
        run.advance(2);
        assertThat(log).containsExactly("zoe heard bob: hi at PT1S");
        assertThat(run.view("amy").status()).isEqualTo(AgentPlatform.Status.FAILED);
    }

    @Test
    void thoseWhoHearAtOnceHearInTheOrderInWhichTheySubscribedHoweverManyCopiesThereAre() {
        startListener("amy");
        startListener("zoe");
        startListener("joe");
        startSpeaker("bob", "hi");
        run.platform.deliverBy((_, listener) ->
                listener.equals("zoe") ? List.of(Duration.ZERO, Duration.ofSeconds(1)) : ChannelModel.AT_ONCE);
        run.advance(3);
        assertThat(log)
                .containsExactly(
                        "amy heard bob: hi at PT1S",
                        "zoe heard bob: hi at PT1S",
                        "joe heard bob: hi at PT1S",
                        "zoe heard bob: hi at PT2S");
    }

    @Test
    void isReportedOnceWhenAnAgentHears() {
        run.start("amy", self -> {
            self.subscribe(WORDS, _ -> {});
            self.subscribe(WORDS, _ -> {});
            self.subscribe(WORDS, Interest.<String>in("psst"::equals), _ -> {});
        });
        startListener("zoe");
        startListener("joe");
        startSpeaker("bob", "hi", "ho");
        run.platform.deliverBy(new ChannelModel() {
            @Override
            public List<Duration> copies(Message<?> message, String listener) {
                return switch (listener) {
                    case "amy" -> List.of(Duration.ofSeconds(3), Duration.ofSeconds(1));
                    case "zoe" -> AT_ONCE;
                    default -> List.of();
                };
            }

            @Override
            public void heard(Message<?> message, String listener) {
                log.add("%s: %s, %s".formatted(listener, message.content(), run.scheduler.elapsed()));
            }
        });
        run.advance(5);
        assertThat(log)
                .containsExactly(
                        "zoe: hi, PT1S",
                        "zoe heard bob: hi at PT1S",
                        "zoe: ho, PT1S",
                        "zoe heard bob: ho at PT1S",
                        "amy: hi, PT2S",
                        "amy: ho, PT2S");
    }

    @Test
    void isReportedOnceWhenAllCopiesCameInVain() {
        run.start("amy", self -> {
            self.subscribe(WORDS, _ -> {});
            self.subscribe(WORDS, _ -> {});
        });
        startListener("zoe");
        startSpeaker("bob", "hi");
        run.platform.deliverBy(new ChannelModel() {
            @Override
            public List<Duration> copies(Message<?> message, String listener) {
                return List.of(Duration.ofSeconds(2), Duration.ofSeconds(1));
            }

            @Override
            public boolean reaches(Message<?> message, String listener) {
                return listener.equals("zoe") && run.scheduler.elapsed().compareTo(Duration.ofSeconds(3)) < 0;
            }

            @Override
            public void unheard(Message<?> message, String listener) {
                log.add("%s did not hear %s, %s".formatted(listener, message.content(), run.scheduler.elapsed()));
            }
        });
        run.advance(5);
        assertThat(log).containsExactly("zoe heard bob: hi at PT2S", "amy did not hear hi, PT3S");
    }

    @Test
    void isNotInformedOfOneThatHasEndedMeanwhile() {
        startListener("amy");
        startSpeaker("bob", "hi");
        run.platform.deliverBy(new ChannelModel() {
            @Override
            public List<Duration> copies(Message<?> message, String listener) {
                run.platform.stop("amy");
                return AT_ONCE;
            }

            @Override
            public void heard(Message<?> message, String listener) {
                log.add(listener);
            }
        });
        run.advance(2);
        assertThat(log).isEmpty();
    }
}
