package rsal.agent.platform;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static rsal.agent.platform.Run.WORDS;

import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Named;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rsal.agent.Agent;
import rsal.agent.AgentContext;
import rsal.agent.Directory;
import rsal.agent.Directory.Change;
import rsal.agent.ServiceDescription;
import rsal.agent.Topic;
import rsal.agent.platform.AgentPlatform.Status;
import rsal.data.Twist2d;
import rsal.device.Subscription;
import rsal.time.Phase;

class AgentPlatformTest {
    private final Run run = new Run();
    private final List<String> log = new ArrayList<>();

    @Test
    void allHearInTheOrderInWhichTheySubscribedButTheOneWhoSpoke() {
        run.startListener("zoe", words -> log.add("zoe heard " + words));
        run.start("bob", self -> {
            self.subscribe(WORDS, _ -> log.add("bob heard himself"));
            self.scheduler().after(Duration.ofSeconds(1), () -> self.publish(WORDS, "hi"));
        });
        run.startListener("amy", words -> log.add("amy heard " + words));
        run.advance(2);
        assertThat(log).containsExactly("zoe heard bob: hi", "amy heard bob: hi");
    }

    @Test
    void onlyTheOneItIsSentToHears() {
        for (String name : List.of("zoe", "amy")) {
            run.startListener(name, words -> log.add(name + " heard " + words));
        }
        run.start("bob", self -> {
            self.subscribe(Run.WORDS, message -> log.add("bob heard himself: " + message.content()));
            self.send("amy", Run.WORDS, "psst");
            self.send("bob", Run.WORDS, "think");
            self.send("nobody", Run.WORDS, "hello?");
        });
        run.advance(0);
        assertThat(log).containsExactly("amy heard bob: psst", "bob heard himself: think");
    }

    @Test
    void nothingIsSentToNobody() {
        run.start("bob", self -> self.send("", Run.WORDS, "psst"));
        run.advance(0);
        assertThat(run.view("bob").state()).contains("psst").contains("nobody");
    }

    @Test
    void oneThatListensNoMoreIsNotSentTo() {
        run.start("amy", self -> {
            Subscription ears = self.subscribe(Run.WORDS, message -> log.add(message.content()));
            self.scheduler().after(Duration.ofMillis(100), ears::cancel);
        });
        run.start("bob", self -> {
            self.send("amy", Run.WORDS, "one");
            self.scheduler().after(Duration.ofMillis(200), () -> self.send("amy", Run.WORDS, "two"));
        });
        run.advance(1);
        assertThat(log).containsExactly("one");
    }

    @Test
    void whatIsSaidIsHeardAtTheSameInstantAfterWhatIsRunning() {
        run.start(
                "amy",
                self -> self.subscribe(WORDS, m -> {
                    log.add("heard at " + run.scheduler.elapsed());
                    assertThat(m.time()).isEqualTo(self.scheduler().instant());
                }));
        run.start(
                "bob",
                self -> self.scheduler().after(Duration.ofSeconds(1), () -> {
                    self.publish(WORDS, "hi");
                    log.add("said");
                }));
        run.advance(2);
        assertThat(log).containsExactly("said", "heard at PT1S");
        assertThat(run.view("amy").status()).isEqualTo(Status.RUNNING);
    }

    @Test
    void answersComeAfterWhatWasSaidBefore() {
        run.start(
                "echo",
                self -> self.subscribe(WORDS, m -> {
                    if (!m.content().startsWith("re:")) {
                        self.publish(WORDS, "re:" + m.content());
                    }
                }));
        run.startListener("amy", log::add);
        run.start(
                "bob",
                self -> self.scheduler().after(Duration.ofSeconds(1), () -> {
                    self.publish(WORDS, "1");
                    self.publish(WORDS, "2");
                }));
        run.advance(2);
        assertThat(log).containsExactly("bob: 1", "bob: 2", "echo: re:1", "echo: re:2");
    }

    @Test
    void agentsStartedTogetherHearEachOthersFirstWords() {
        run.start("amy", self -> {
            self.publish(WORDS, "hello");
            self.subscribe(WORDS, m -> log.add("amy heard " + m.sender()));
        });
        run.start("bob", self -> {
            self.publish(WORDS, "hello");
            self.subscribe(WORDS, m -> log.add("bob heard " + m.sender()));
        });
        run.advance(0);
        assertThat(log).containsExactly("bob heard amy", "amy heard bob");
    }

    @Test
    void agentThatThrowsEndsAloneAndTheOthersLearnWhy() {
        run.startListener("amy", log::add);
        run.start(
                "watcher",
                self -> self.directory().onChange(change -> {
                    if (change instanceof Change.Went(Directory.Entry agent, String reason)) {
                        log.add(agent.name() + " went: " + reason);
                    }
                }));
        run.start("bob", self -> {
            self.scheduler().every(Duration.ofSeconds(1), () -> log.add("bob ticks"));
            self.scheduler().after(Duration.ofMillis(1500), () -> {
                throw new IllegalStateException("a slip of bob's");
            });
        });
        run.advance(3);
        run.platform.publish("operator", WORDS, "still there?");
        run.advance(1);
        assertThat(log).containsExactly("bob ticks", "bob went: a slip of bob's", "operator: still there?");
        assertThat(run.view("bob").status()).isEqualTo(Status.FAILED);
        assertThat(run.view("bob").state()).isEqualTo("a slip of bob's");
        assertThat(run.platform.directory().agents())
                .extracting(Directory.Entry::name)
                .containsExactly("amy", "watcher");
    }

    @Test
    void agentMayThrowAnywhere() {
        run.start("in-start", _ -> {
            throw new IllegalStateException("in start");
        });
        run.start(
                "in-listener",
                self -> self.subscribe(WORDS, _ -> {
                    throw new IllegalStateException("in listener");
                }));
        run.start(
                "in-task",
                self -> self.scheduler().execute(() -> {
                    throw new IllegalStateException("in task");
                }));
        run.start("endless", self -> self.scheduler().execute(this::endless));
        run.start("in-linking", _ -> {
            throw new NoClassDefFoundError("rsal/Missing");
        });
        run.start("in-stop", new Agent() {
            @Override
            public void start(AgentContext self) {}

            @Override
            public void stop(AgentContext self) {
                throw new IllegalStateException("in stop");
            }
        });
        run.platform.publish("operator", WORDS, "hi");
        run.advance(1);
        run.platform.stop("in-stop");
        assertThat(run.platform.views()).extracting(AgentPlatform.View::status).containsOnly(Status.FAILED);
        assertThat(run.platform.views())
                .extracting(AgentPlatform.View::state)
                .containsExactly("in start", "in listener", "in task", "StackOverflowError", "rsal/Missing", "in stop");
    }

    @SuppressWarnings("InfiniteRecursion") // on purpose
    private void endless() {
        endless();
    }

    @Test
    void agentThatThrowsStopsItsRobot() {
        var fake = new BaseRobot();
        run.start(
                "bob",
                self -> self.scheduler().after(Duration.ofSeconds(1), () -> {
                    throw new IllegalStateException("a slip of bob's");
                }),
                fake.robot);
        run.advance(0.5);
        assertThat(fake.base.commands).isEmpty();
        run.advance(1);
        assertThat(fake.base.commands).containsExactly(Twist2d.STOP);
    }

    @Test
    void readingsAreHeardWhenItIsTheAgentsTurn() {
        var fake = new BaseRobot();
        run.start("amy", self -> self.subscribe(fake.base, reading -> log.add("amy heard at " + reading.time())));
        run.scheduler.after(Duration.ofSeconds(1), Phase.WORLD, () -> fake.base.rollTo(1, run.scheduler.instant()));
        run.scheduler.after(Duration.ofSeconds(1), Phase.DEVICES, () -> log.add("devices"));
        run.scheduler.after(Duration.ofSeconds(1), Phase.OBSERVE, () -> log.add("observers"));
        run.advance(2);
        assertThat(log).containsExactly("devices", "amy heard at 1970-01-01T00:00:01Z", "observers");
    }

    @Test
    void listenerOfADeviceThatThrowsEndsItsAgentAndIsCalledNoMore() {
        var fake = new BaseRobot();
        run.start(
                "amy",
                self -> self.subscribe(fake.base, _ -> {
                    log.add("heard");
                    throw new IllegalStateException("a slip of amy's");
                }),
                fake.robot);
        run.advance(0);
        fake.base.rollTo(1, run.scheduler.instant());
        fake.base.rollTo(2, run.scheduler.instant());
        run.advance(0);
        assertThat(log).containsExactly("heard");
        assertThat(run.view("amy").status()).isEqualTo(Status.FAILED);
    }

    @Test
    void nothingOfAnEndedAgentGoesOn() {
        run.start("amy", self -> {
            self.subscribe(WORDS, _ -> log.add("heard"));
            self.directory().onChange(_ -> log.add("changed"));
            self.scheduler().every(Duration.ofSeconds(1), () -> log.add("beat"));
            self.scheduler().after(Duration.ofSeconds(2), () -> log.add("late"));
            self.atEnd(() -> log.add("let go of the first"));
            self.atEnd(() -> {
                log.add("let go of the second");
                self.publish(WORDS, "too late");
            });
        });
        run.startListener("bob", log::add);
        run.advance(0);
        run.platform.publish("operator", WORDS, "this is due when she ends");
        log.clear();
        run.platform.stop("amy");
        run.advance(5);
        assertThat(log)
                .containsExactly("let go of the second", "let go of the first", "operator: this is due when she ends");
    }

    @Test
    void lastWordsAreHeard() {
        run.startListener("amy", log::add);
        run.start("bob", new Agent() {
            @Override
            public void start(AgentContext self) {}

            @Override
            public void stop(AgentContext self) {
                self.publish(WORDS, "bye");
            }
        });
        run.advance(1);
        run.platform.stop("bob");
        run.advance(1);
        assertThat(log).containsExactly("bob: bye");
    }

    @Test
    void lastWordsAreSaidOnceThoughTheyEndTheRun() {
        run.platform.onMessage(m -> {
            log.add(m.sender() + ": " + m.content());
            run.platform.close();
        });
        run.start("bob", new Agent() {
            @Override
            public void start(AgentContext self) {}

            @Override
            public void stop(AgentContext self) {
                self.publish(WORDS, "bye");
            }
        });
        run.advance(1);
        run.platform.stop("bob");
        assertThat(log).containsExactly("bob: bye");
        assertThat(run.view("bob").status()).isEqualTo(Status.ENDED);
    }

    @Test
    void cancelledSubscriptionHearsNotEvenWhatIsDue() {
        run.start("amy", self -> {
            var words = self.subscribe(WORDS, _ -> log.add("heard"));
            self.scheduler().after(Duration.ofSeconds(1), words::cancel);
        });
        run.start("bob", self -> self.scheduler().after(Duration.ofSeconds(1), () -> self.publish(WORDS, "hi")));
        run.start("eve", self -> self.scheduler().after(Duration.ofMillis(500), () -> self.publish(WORDS, "hi")));
        run.advance(2);
        assertThat(log).containsExactly("heard");
    }

    /// All that belongs on the agent's lane, by name; each as a call that another thread tries.
    private static Stream<Named<Consumer<AgentContext>>> callsOfItsLane() {
        Map<String, Consumer<AgentContext>> calls = new LinkedHashMap<>();
        calls.put("robot", AgentContext::robot);
        calls.put("random", AgentContext::random);
        calls.put("publish", self -> self.publish(WORDS, "hi"));
        calls.put("send", self -> self.send("amy", WORDS, "hi"));
        calls.put("subscribe", self -> self.subscribe(WORDS, _ -> {}));
        calls.put("subscribe to a device", self -> self.subscribe(new BaseRobot().base, _ -> {}));
        calls.put("offer", self -> self.offer(ServiceDescription.of("gripper")));
        calls.put("directory", AgentContext::directory);
        calls.put("blackboard", AgentContext::blackboard);
        calls.put("simulation", AgentContext::simulation);
        calls.put("state", self -> self.state("idle"));
        calls.put("show", self -> self.show("mood", "good"));
        calls.put("reveal", self -> self.reveal(String.class, () -> "all"));
        calls.put("atEnd", self -> self.atEnd(() -> {}));
        calls.put("after", self -> self.scheduler().after(Duration.ZERO, () -> {}));
        calls.put("every", self -> self.scheduler().every(Duration.ofSeconds(1), () -> {}));
        calls.put("within", self -> self.scheduler().within(Duration.ZERO, new CompletableFuture<String>()));
        calls.put("compute", self -> self.scheduler().compute(() -> "done"));
        return calls.entrySet().stream().map(call -> Named.of(call.getKey(), call.getValue()));
    }

    @ParameterizedTest
    @MethodSource("callsOfItsLane")
    void callFromAnotherThreadIsRefusedAndEndsTheAgent(Consumer<AgentContext> call) {
        var thrown = new CompletableFuture<String>();
        run.startListener("amy", log::add);
        run.start(
                "bob",
                self -> self.scheduler()
                        .after(
                                Duration.ofSeconds(1),
                                () -> elsewhere(() -> {
                                    try {
                                        call.accept(self);
                                        thrown.complete("nothing");
                                    } catch (IllegalStateException e) {
                                        thrown.complete(e.getMessage());
                                    }
                                })));
        run.advance(2);
        assertThat(thrown.join()).contains("'bob'", "self.scheduler().execute(");
        run.advance(1); // what another thread hands in runs at the beginning of an advance
        assertThat(run.view("bob").status()).isEqualTo(Status.FAILED);
        assertThat(run.view("bob").state()).isEqualTo(thrown.join());
        assertThat(run.view("amy").status()).isEqualTo(Status.RUNNING);
        assertThat(log).isEmpty();
    }

    @Test
    void anotherThreadMayAskTheTimeAndHandOver() {
        run.startListener("amy", log::add);
        run.start(
                "bob",
                self -> self.scheduler()
                        .after(
                                Duration.ofSeconds(1),
                                () -> elsewhere(() -> {
                                    String words = self.name() + " the " + self.role() + " at "
                                            + self.scheduler().instant();
                                    self.scheduler().execute(() -> self.publish(WORDS, words));
                                })));
        run.advance(2);
        run.advance(1);
        assertThat(log).containsExactly("bob: bob the tested at 1970-01-01T00:00:01Z");
    }

    /// A run may pause on one thread and go on on another.
    @Test
    void laneIsWhereTheAgentRunsNow() {
        run.startListener("amy", log::add);
        run.start("bob", self -> self.scheduler().every(Duration.ofSeconds(1), () -> self.publish(WORDS, "beat")));
        run.advance(1.5);
        elsewhere(() -> run.advance(1));
        assertThat(log).containsExactly("bob: beat", "bob: beat");
    }

    private static void elsewhere(Runnable task) {
        try {
            Thread.ofPlatform().start(task).join();
        } catch (InterruptedException e) {
            throw new AssertionError("Nobody interrupts it.", e);
        }
    }

    @Test
    void twoThatAnswerEachOtherForEverAreEndedByName() {
        for (String name : List.of("ping", "pong")) {
            run.start(name, self -> self.subscribe(WORDS, _ -> self.publish(WORDS, "again")));
        }
        run.startListener("amy", _ -> {});
        run.platform.publish("operator", WORDS, "go");
        run.advance(1);
        assertThat(run.view("ping").status()).isEqualTo(Status.FAILED);
        assertThat(run.view("ping").state()).contains("'ping'").contains(String.valueOf(AgentRuntime.LIMIT));
        assertThat(run.view("ping").sent()).isBetween(AgentRuntime.LIMIT / 2L, (long) AgentRuntime.LIMIT);
        assertThat(run.view("amy").status()).isEqualTo(Status.RUNNING);
    }

    /// Says something to another a number of times at once.
    private void sayOften(String name, String to, int times) {
        run.start(name, self -> {
            self.subscribe(WORDS, _ -> {});
            self.scheduler().after(Duration.ofSeconds(1), () -> {
                for (int i = 0; i < times; i++) {
                    self.send(to, WORDS, "?");
                }
            });
        });
    }

    /// Says something a number of times to whoever says something to it.
    private void answer(String name, int times) {
        run.start(
                name,
                self -> self.subscribe(WORDS, question -> {
                    for (int i = 0; i < times; i++) {
                        self.send(question.sender(), WORDS, "!");
                    }
                }));
    }

    @Test
    void answersCountForTheOneWhoAsked() {
        answer("amy", 2);
        sayOften("bob", "amy", AgentRuntime.LIMIT / 2);
        sayOften("eve", "amy", AgentRuntime.LIMIT / 2);
        sayOften("zoe", "amy", AgentRuntime.LIMIT / 4);
        run.advance(2);
        assertThat(run.view("amy").status()).isEqualTo(Status.RUNNING);
        assertThat(run.view("zoe").status()).isEqualTo(Status.RUNNING);
        for (String name : List.of("bob", "eve")) {
            assertThat(run.view(name).status()).isEqualTo(Status.FAILED);
            assertThat(run.view(name).state()).contains("'%s'".formatted(name), "replies");
        }
    }

    @Test
    void manyMayAskOneTogetherMoreThanItMaySay() {
        int times = AgentRuntime.LIMIT / 12;
        answer("amy", 2);
        for (int i = 0; i < 12; i++) {
            sayOften("asker-" + i, "amy", times);
        }
        run.advance(2);
        assertThat(run.platform.views()).extracting(AgentPlatform.View::status).containsOnly(Status.RUNNING);
        assertThat(run.view("amy").sent()).isEqualTo(24L * times);
    }

    @Test
    void whoAnswersMoreThanAnybodyAskedForIsEndedItself() {
        answer("amy", 2 * AgentRuntime.LIMIT);
        sayOften("bob", "amy", 1);
        run.advance(2);
        assertThat(run.view("amy").status()).isEqualTo(Status.FAILED);
        assertThat(run.view("bob").status()).isEqualTo(Status.RUNNING);
    }

    @Test
    void ofTwoThatAnswerEachOtherTheOneWhoBeganIsEnded() {
        answer("pong", 1);
        answer("ping", 1);
        run.start("zoe", self -> {});
        run.platform.send("pong", "ping", WORDS, "?"); // in its name: not counted
        run.advance(1);
        assertThat(run.view("ping").status()).isEqualTo(Status.FAILED);
        assertThat(run.view("pong").status()).isEqualTo(Status.RUNNING);
    }

    @Test
    void oneThatSchedulesItselfForEverAtOneInstantIsEnded() {
        run.start("busy", new Agent() {
            @Override
            public void start(AgentContext self) {
                self.scheduler().execute(() -> start(self));
            }
        });
        run.start("busy-too", new Agent() {
            @Override
            public void start(AgentContext self) {
                self.scheduler().after(Duration.ZERO, () -> start(self));
            }
        });
        run.advance(1);
        assertThat(run.platform.views()).extracting(AgentPlatform.View::status).containsOnly(Status.FAILED);
    }

    @Test
    void oneThatTalksMuchForLongIsLeftInPeace() {
        run.start(
                "poet",
                self -> self.scheduler().every(Duration.ofMillis(100), () -> {
                    for (int i = 0; i < AgentRuntime.LIMIT - 1; i++) {
                        self.publish(WORDS, "a line");
                    }
                }));
        run.advance(2);
        assertThat(run.view("poet").status()).isEqualTo(Status.RUNNING);
        assertThat(run.view("poet").sent()).isEqualTo(20L * (AgentRuntime.LIMIT - 1));
    }

    @Test
    void namesAreUniqueAmongThoseWhoRun() {
        run.startListener("amy", _ -> {});
        assertThatThrownBy(() -> run.startListener("amy", _ -> {}))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("'amy'");
        run.platform.stop("amy");
        run.startListener("amy", log::add);
        run.advance(0);
        run.platform.publish("operator", WORDS, "hi");
        run.advance(0);
        assertThat(log).containsExactly("operator: hi");
        assertThat(run.platform.views()).hasSize(1);
    }

    @Test
    void stoppingAnUnknownAgentSaysWhoIsThere() {
        run.startListener("amy", _ -> {});
        assertThatThrownBy(() -> run.platform.stop("any"))
                .hasMessageContaining("'any'")
                .hasMessageContaining("amy");
    }

    @Test
    @SuppressWarnings({"unchecked", "rawtypes"}) // on purpose
    void messagesOfAnotherTypeAreRefused() {
        run.startListener("eve", log::add);
        run.start("amy", self -> self.publish((Topic) WORDS, 42));
        run.start("bob", self -> self.subscribe(new Topic<>("words", Integer.class), _ -> {}));
        run.advance(1);
        assertThat(run.view("amy").state()).contains("'words'", "String", "'42'");
        assertThat(run.view("bob").status()).isEqualTo(Status.FAILED);
        assertThat(run.view("bob").state()).contains("'words'", "Integer", "String", "since 'eve'");
        assertThat(log).isEmpty();
    }

    @Test
    void whoSpeaksOnATopicWithoutANameOrATypeEnds() {
        run.start("amy", self -> self.publish(new Topic<>(null, String.class), "hi"));
        run.start("bob", self -> self.subscribe(new Topic<>("words", null), _ -> {}));
        run.advance(1);
        assertThat(run.view("amy").state()).isEqualTo("A topic must have a name.");
        assertThat(run.view("bob").status()).isEqualTo(Status.FAILED);
    }

    @Test
    void peopleSeeAllThatIsSaidAndEveryChange() {
        run.platform.onMessage(m -> log.add(m.sender() + ": " + m.content()));
        run.platform.onChange(view -> log.add(view.agent().name() + " " + view.status() + " " + view.state()));
        run.start("amy", self -> {
            self.state("looking");
            self.state("looking");
            self.publish(WORDS, "hi");
            self.show("sees", "nothing");
            self.show("sees", "a wall");
        });
        run.advance(0);
        assertThat(run.view("amy").beliefs()).containsOnly(java.util.Map.entry("sees", "a wall"));
        run.platform.stop("amy");
        assertThat(log).containsExactly("amy RUNNING ", "amy RUNNING looking", "amy: hi", "amy ENDED looking");
    }

    @Test
    void directoryKnowsWhoIsThereAndHasWhatRole() {
        run.startListener("amy", _ -> {});
        run.startListener("bob", _ -> {});
        assertThat(run.platform.directory().ofRole("tested"))
                .extracting(Directory.Entry::name)
                .containsExactly("amy", "bob");
        run.platform.stop("amy");
        assertThat(run.platform.directory().find("amy")).isEmpty();
        assertThat(run.platform.directory().find("bob")).isPresent();
    }

    @Test
    void thoseWhoOnlyCareWhoGoesAreInformedAfterItsLastWords() {
        run.start("zoe", self -> {
            self.directory().onDeparture(went -> log.add(went.agent().name() + " went"));
            self.subscribe(WORDS, message -> log.add(message.content()));
        });
        run.start("amy", new Agent() {
            @Override
            public void start(AgentContext self) {
                self.offer(ServiceDescription.of("talk"));
            }

            @Override
            public void stop(AgentContext self) {
                self.publish(WORDS, "farewell");
            }
        });
        run.advance(0);
        run.platform.stop("amy");
        run.advance(0);
        assertThat(log).containsExactly("farewell", "amy went");
    }

    @Test
    void closingStopsAll() {
        for (String name : List.of("amy", "bob")) {
            run.start(name, self -> self.atEnd(() -> log.add(name)));
        }
        run.advance(1);
        run.platform.close();
        run.platform.close();
        assertThat(log).containsExactly("bob", "amy");
        assertThat(run.platform.views()).extracting(AgentPlatform.View::status).containsOnly(Status.ENDED);
    }

    @Test
    void thousandAgentsAllHearEachOther() {
        var heard = new int[1000];
        for (int i = 0; i < heard.length; i++) {
            int me = i;
            run.start("agent-" + i, self -> {
                self.subscribe(WORDS, _ -> heard[me]++);
                self.publish(WORDS, "hello");
            });
        }
        run.advance(0);
        assertThat(heard).containsOnly(999);
    }

    @Test
    void sameSeedsGiveTheSameTalk() {
        assertThat(talk()).isEqualTo(talk()).hasSizeGreaterThan(100);
    }

    private static List<String> talk() {
        var run = new Run();
        var said = new ArrayList<String>();
        run.platform.onMessage(m -> said.add(m.time() + " " + m.sender() + " " + m.content()));
        IntStream.range(0, 10)
                .forEach(i -> run.start("agent-" + i, self -> {
                    Runnable speak = () ->
                            self.publish(WORDS, Double.toString(self.random().nextDouble()));
                    self.scheduler().every(Duration.ofMillis(100 + self.random().nextInt(900)), speak);
                    self.subscribe(WORDS, m -> {
                        if (self.random().nextInt(20) == 0) {
                            self.publish(WORDS, m.sender());
                        }
                    });
                }));
        run.advance(20);
        return said;
    }

    @Test
    void contextIsWhatTheSpecSays() {
        run.start("amy", self -> {
            assertThat(self.name()).isEqualTo("amy");
            assertThat(self.role()).isEqualTo("tested");
            assertThat(self.robot()).isEmpty();
            assertThat(self.simulation()).isEqualTo(Optional.empty());
            self.state("all right");
        });
        run.advance(0);
        assertThat(run.view("amy").state()).isEqualTo("all right");
    }
}
