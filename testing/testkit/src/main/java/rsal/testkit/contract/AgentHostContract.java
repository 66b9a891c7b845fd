package rsal.testkit.contract;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Function;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import rsal.agent.Agent;
import rsal.agent.AgentContext;
import rsal.agent.AgentType;
import rsal.agent.ChannelModel;
import rsal.agent.Directory;
import rsal.agent.Message;
import rsal.agent.ServiceDescription;
import rsal.agent.Topic;
import rsal.agent.bdi.Mind;
import rsal.agent.bdi.Mind.GoalState;
import rsal.agent.bdi.Mind.GoalView;
import rsal.agent.platform.AgentPlatform.Status;
import rsal.agent.protocol.Auction;
import rsal.agent.protocol.Conversation;
import rsal.agent.protocol.ConversationResult;
import rsal.agent.protocol.Propose;
import rsal.agent.protocol.Request;
import rsal.agent.protocol.Subscribe;
import rsal.device.LaserScanner;
import rsal.device.Subscription;
import rsal.robot.Robot;
import rsal.settings.Arguments;
import rsal.settings.Parameter;
import rsal.testkit.Rounds;
import rsal.testkit.fake.FakeSystem;
import rsal.time.Task;

/// What every agent host owes to agents and to the run: they start, hear, wait, talk and end alike, each on its lane,
/// one at a time, and when all is over nothing of the host is left. Tested in simulated time where the host follows
/// that, else in real time, in which only orders count, not instants.
///
/// Longer than 500 lines, since it is a list: a test for each thing that is owed.
public abstract class AgentHostContract extends ContractNetContract {
    private static final Parameter<String> GREETING = Parameter.text("words", "hello", "What it says.");
    private static final Topic<Integer> NUMBERS = new Topic<>("numbers", Integer.class);
    private static final int MANY = Rounds.of(250, 1000);
    private static final List<String> BIDDERS = List.of("amy", "bob", "eve");

    /// Whether the multi-agent system lets go of a thread by itself, but later than a test waits.
    protected boolean endsLater(Thread thread) {
        return false;
    }

    @Test
    void hasAKeyAndADescription() {
        assertThat(provider().key()).matches("[a-z][a-z0-9-]*");
        assertThat(provider().description()).matches("[A-Z].*\\.");
    }

    @Test
    void agentsGetTheirArguments() {
        var type = new AgentType() {
            @Override
            public String key() {
                return "greeter";
            }

            @Override
            public String description() {
                return "Says what it is to say.";
            }

            @Override
            public List<Parameter<?>> parameters() {
                return List.of(GREETING);
            }

            @Override
            public Agent create(Arguments arguments) {
                return self -> log.add(self.name() + " (" + self.role() + "): " + arguments.get(GREETING));
            }
        };
        try (var run = run()) {
            run.start("amy", type, Arguments.defaults(type.parameters()));
            run.until("it has begun", () -> isLogged(1));
            run.start("bob", type, Arguments.of(type.parameters(), Map.of("words", "good morning")));
            run.until("the other has begun", () -> isLogged(2));
        }
        assertThat(log).containsExactly("amy (tested): hello", "bob (tested): good morning");
    }

    @Test
    void tasksRunInTheOrderInWhichTheyAreDue() {
        try (var run = run()) {
            run.start("amy", self -> {
                self.scheduler().after(Duration.ofMillis(200), () -> log.add("late"));
                self.scheduler().after(Duration.ofMillis(50), () -> log.add("early"));
                self.scheduler()
                        .after(Duration.ofMillis(20), () -> log.add("never"))
                        .cancel();
                self.scheduler().execute(() -> log.add("at once"));
                log.add("begun");
            });
            run.until("all have run", () -> log.contains("late"));
        }
        assertThat(log).containsExactly("begun", "at once", "early", "late");
    }

    @Test
    void beatsGoOnUntilTheyAreCancelled() {
        try (var run = run()) {
            run.start("amy", self -> {
                var beats = new AtomicInteger();
                var task = new ArrayList<Task>();
                task.add(self.scheduler().every(Duration.ofMillis(10), () -> {
                    log.add("beat");
                    if (beats.incrementAndGet() == 5) {
                        task.getFirst().cancel();
                    }
                }));
            });
            run.until("it has beaten", () -> isLogged(5));
            run.pass(100);
        }
        assertThat(log).hasSize(5);
    }

    @Test
    void aThreadOfAnAgentsOwnTakesTurnsInRealTime() {
        var agents = new ArrayList<AgentContext>();
        try (var run = run()) {
            run.start("amy", agents::add);
            run.untilAllHaveBegun();
            AgentContext amy = agents.getFirst();
            assertThat(amy.scheduler().run()).isEqualTo(run.scheduler().run());
            if (provider().followsSchedulerTime()) {
                assertThatThrownBy(() -> amy.scheduler().exclusively(() -> {}))
                        .isInstanceOf(UnsupportedOperationException.class);
            } else {
                amy.scheduler().exclusively(() -> log.add("turn " + amy.random().nextInt(1)));
                amy.scheduler().exclusively(() -> {
                    throw new IllegalStateException("a screw is loose");
                });
                assertThat(log).containsExactly("turn 0");
                assertThat(run.status("amy")).isEqualTo(Status.FAILED);
            }
        }
    }

    @Test
    void whatIsComputedElsewhereComesBackOnTheLane() {
        try (var run = run()) {
            run.untilAllHaveBegun();
            run.start(
                    "amy",
                    self -> self.scheduler()
                            .compute(() -> 6 * 7)
                            .thenAccept(answer -> self.scheduler()
                                    .execute(() ->
                                            log.add(answer + " " + self.random().nextInt(1)))));
            run.until("it has come", () -> isLogged(1));
        }
        assertThat(log).containsExactly("42 0");
    }

    @Test
    void oneHearsAnotherInTheOrderInWhichItSpeaks() {
        var heard = new HashMap<String, List<Integer>>();
        List<String> listeners = List.of("zoe", "amy", "bob");
        try (var run = run()) {
            for (String name : listeners) {
                var all = new ArrayList<Integer>();
                heard.put(name, all);
                run.start(name, self -> self.subscribe(NUMBERS, m -> all.add(m.content())));
            }
            run.untilAllHaveBegun();
            run.start("eve", self -> {
                self.subscribe(NUMBERS, _ -> log.add("heard itself"));
                self.scheduler()
                        .after(
                                Duration.ofMillis(300),
                                () -> IntStream.range(0, 200).forEach(i -> self.publish(NUMBERS, i)));
            });
            run.until("all have heard all", () -> heard.values().stream().allMatch(all -> all.size() == 200));
        }
        assertThat(log).isEmpty();
        heard.values().forEach(all -> assertThat(all).isSorted());
    }

    @Test
    void whatIsForOneReachesThatOneAlone() {
        try (var run = run()) {
            for (String name : List.of("amy", "bob")) {
                run.start(name, self -> self.subscribe(WORDS, m -> log.add(name + ": " + m.content())));
            }
            run.untilAllHaveBegun();
            run.start(
                    "eve",
                    self -> self.scheduler().after(Duration.ofMillis(200), () -> {
                        self.send("bob", WORDS, "psst");
                        self.send("nobody", WORDS, "hello?");
                        self.publish(WORDS, "all");
                    }));
            run.until("they have heard", () -> isLogged(3));
            run.pass(100);
        }
        assertThat(log).containsExactlyInAnyOrder("bob: psst", "bob: all", "amy: all");
        assertThat(log.indexOf("bob: psst")).isLessThan(log.indexOf("bob: all"));
    }

    @Test
    void whatIsForAllAndWhatIsForOneArriveInOneOrder() {
        var heard = new ArrayList<Integer>();
        try (var run = run()) {
            run.start("bob", self -> self.subscribe(NUMBERS, m -> heard.add(m.content())));
            run.untilAllHaveBegun();
            run.start(
                    "eve",
                    self -> self.scheduler().after(Duration.ofMillis(200), () -> {
                        for (int i = 0; i < 100; i++) {
                            self.publish(NUMBERS, 2 * i);
                            self.send("bob", NUMBERS, 2 * i + 1);
                        }
                    }));
            run.until("it has heard all", () -> heard.size() == 200);
        }
        assertThat(heard).isSorted();
    }

    @Test
    void aPersonIsHeard() {
        try (var run = run()) {
            run.start("amy", self -> self.subscribe(WORDS, m -> log.add(m.sender() + ": " + m.content())));
            run.untilAllHaveBegun();
            run.act(() -> run.platform().publish("operator", WORDS, "to all"));
            run.act(() -> run.platform().send("operator", "amy", WORDS, "to you"));
            run.until("it has heard", () -> isLogged(2));
        }
        assertThat(log).containsExactly("operator: to all", "operator: to you");
    }

    @Test
    void oneThatListensNoMoreHearsNothing() {
        try (var run = run()) {
            run.start("amy", self -> {
                var words = new ArrayList<Subscription>();
                words.add(self.subscribe(WORDS, m -> {
                    log.add(m.content());
                    if (m.content().equals("enough")) {
                        words.getFirst().cancel();
                    }
                }));
            });
            run.untilAllHaveBegun();
            List.of("before", "enough")
                    .forEach(words -> run.act(() -> run.platform().publish("operator", WORDS, words)));
            run.until("it has heard", () -> isLogged(2));
            run.act(() -> run.platform().publish("operator", WORDS, "after"));
            run.pass(200);
        }
        assertThat(log).containsExactly("before", "enough");
    }

    @Test
    void whatIsLostIsNotHeard() {
        try (var run = run()) {
            run.start("amy", self -> self.subscribe(WORDS, m -> log.add(m.content())));
            run.untilAllHaveBegun();
            run.deliverBy(
                    (message, _) -> message.content().equals("lost") ? List.of() : List.of(Duration.ofMillis(50)));
            run.act(() -> run.platform().publish("operator", WORDS, "lost"));
            run.act(() -> run.platform().publish("operator", WORDS, "late"));
            run.until("it has heard", () -> isLogged(1));
        }
        assertThat(log).containsExactly("late");
    }

    /// As mailboxes are kept.
    @Test
    void whatReachesAnAgentIsReportedOnce() {
        var mail = new ArrayList<String>();
        try (var run = run()) {
            run.start("amy", self -> {
                self.subscribe(WORDS, m -> log.add(m.content()));
                self.subscribe(WORDS, m -> log.add(m.content()));
            });
            run.start("bob", self -> self.subscribe(WORDS, m -> log.add(m.content())));
            run.start(
                    "eve",
                    self -> self.subscribe(NUMBERS, _ -> {
                        List.of("to all", "lost").forEach(words -> self.publish(WORDS, words));
                        self.send("bob", WORDS, "to bob");
                        self.send("nobody", WORDS, "hello?");
                    }));
            run.untilAllHaveBegun();
            run.deliverBy(new ChannelModel() {
                @Override
                public List<Duration> copies(Message<?> message, String listener) {
                    if (message.topic().equals(NUMBERS)) {
                        return AT_ONCE;
                    }
                    return message.content().equals("lost")
                            ? List.of()
                            : List.of(Duration.ZERO, Duration.ofMillis(20)); // it comes twice
                }

                @Override
                public void heard(Message<?> message, String listener) {
                    mail.add("%s: %s, %s".formatted(listener, message.sender(), message.content()));
                }
            });
            run.act(() -> run.platform().send("operator", "eve", NUMBERS, 1));
            run.until("all have heard all", () -> isLogged(2 * (2 + 1 + 1)));
        }
        assertThat(mail)
                .containsExactlyInAnyOrder(
                        "eve: operator, 1", "amy: eve, to all", "bob: eve, to all", "bob: eve, to bob")
                .containsSubsequence("bob: eve, to all", "bob: eve, to bob");
    }

    @Test
    void oneThatThrowsEndsAlone() {
        try (var run = run()) {
            run.start("amy", self -> {
                self.directory().onDeparture(went -> log.add(went.agent().name() + " went: " + went.reason()));
                self.scheduler().every(Duration.ofMillis(20), () -> log.add("amy lives"));
            });
            run.start("bob", self -> {
                self.scheduler().every(Duration.ofMillis(20), () -> log.add("bob lives"));
                self.scheduler().after(Duration.ofMillis(110), () -> {
                    throw new IllegalStateException("a slip");
                });
            });
            run.until("the others know", () -> log.contains("bob went: a slip"));
            int before = run.ask(log::size);
            run.until("amy goes on", () -> isLogged(before + 3));
            assertThat(run.ask(() -> List.copyOf(log)).subList(before, before + 3))
                    .containsOnly("amy lives");
            assertThat(run.status("amy")).isEqualTo(Status.RUNNING);
            assertThat(run.status("bob")).isEqualTo(Status.FAILED);
        }
    }

    @Test
    void nothingOfAStoppedAgentRuns() {
        try (var run = run()) {
            run.start("amy", new Agent() {
                @Override
                public void start(AgentContext self) {
                    self.subscribe(WORDS, _ -> log.add("heard"));
                    self.scheduler().every(Duration.ofMillis(50), () -> log.add("beat"));
                }

                @Override
                public void stop(AgentContext self) {
                    log.add("stopped");
                }
            });
            run.until("it beats", () -> isLogged(1));
            run.stop("amy");
            run.act(() -> run.platform().publish("operator", WORDS, "hi"));
            run.pass(300);
            assertThat(log.getLast()).isEqualTo("stopped");
            assertThat(log.subList(0, log.size() - 1)).containsOnly("beat");
            assertThat(run.status("amy")).isEqualTo(Status.ENDED);
        }
    }

    @Test
    void lastWordsAreHeard() {
        try (var run = run()) {
            run.start("amy", self -> self.subscribe(WORDS, m -> log.add(m.content())));
            run.start("bob", new Agent() {
                @Override
                public void start(AgentContext self) {}

                @Override
                public void stop(AgentContext self) {
                    self.publish(WORDS, "farewell");
                    self.send("amy", WORDS, "amy");
                }
            });
            run.untilAllHaveBegun();
            run.stop("bob");
            run.until("they are", () -> isLogged(2));
        }
        assertThat(log).containsExactly("farewell", "amy");
    }

    @Test
    void oneMayStartAgainUnderItsName() {
        try (var run = run()) {
            run.start("amy", _ -> log.add("first"));
            run.until("it has begun", () -> isLogged(1));
            run.stop("amy");
            run.start("amy", self -> {
                log.add("second");
                self.subscribe(WORDS, m -> log.add(m.content()));
            });
            run.until("it has begun again", () -> isLogged(2));
            run.pass(100);
            run.act(() -> run.platform().publish("operator", WORDS, "hi"));
            run.until("it hears", () -> isLogged(3));
        }
        assertThat(log).containsExactly("first", "second", "hi");
    }

    @Test
    void closingStopsAllTheNewestFirst() {
        var run = run();
        run.start("amy", self -> {
            self.atEnd(() -> log.add("amy"));
            log.add("begun");
        });
        run.start("bob", self -> {
            self.atEnd(() -> log.add("bob"));
            log.add("begun");
        });
        run.until("both have begun", () -> isLogged(2));
        run.close();
        assertThat(log).containsExactly("begun", "begun", "bob", "amy");
    }

    @Test
    void oneAsksAnother() {
        try (var run = run()) {
            run.start(
                    "bob",
                    self -> service(self).answer(asked -> {
                        if (asked.what().equals("lie")) {
                            asked.refuse("never");
                        } else {
                            asked.agree();
                            self.scheduler().after(Duration.ofMillis(100), () -> asked.inform(asked.what() + ", done"));
                        }
                    }));
            run.untilAllHaveBegun();
            run.start(
                    "amy",
                    self -> self.scheduler().after(Duration.ofMillis(200), () -> {
                        service(self).ask("bob", "carry", how -> log.add(how.toString()));
                        service(self).ask("bob", "lie", how -> log.add(how.toString()));
                    }));
            run.until("both have ended", () -> isLogged(2));
        }
        assertThat(log)
                .containsExactlyInAnyOrder(
                        new ConversationResult.Informed<>("carry, done").toString(),
                        new ConversationResult.Refused<>("never").toString());
    }

    private final Map<String, Request<String, String>> services = new HashMap<>(); // one for each agent

    private Request<String, String> service(AgentContext self) {
        return services.computeIfAbsent(self.name(), _ -> new Request<>(self, "help", String.class, String.class));
    }

    @Test
    void whoAsksLearnsThatTheOtherHasGone() {
        try (var run = run()) {
            run.start(
                    "bob",
                    self -> service(self).answer(asked -> {
                        asked.agree();
                        log.add("agreed");
                    }));
            run.untilAllHaveBegun();
            run.start(
                    "amy",
                    self -> self.scheduler()
                            .after(
                                    Duration.ofMillis(200),
                                    () -> service(self).ask("bob", "carry", how -> log.add(how.toString()))));
            run.until("it was asked", () -> isLogged(1));
            run.stop("bob");
            run.until("who asked knows", () -> isLogged(2));
        }
        assertThat(log).containsExactly("agreed", new ConversationResult.Silent<>("'bob' has ended.").toString());
    }

    @Test
    void oneProposesToAnother() {
        try (var run = run()) {
            run.start(
                    "bob",
                    self -> new Propose<>(self, "deal", String.class)
                            .answer(offer -> offer.what().equals("half")
                                    ? Propose.Verdict.accept()
                                    : Propose.Verdict.reject("too little")));
            run.untilAllHaveBegun();
            run.start("amy", self -> {
                var deal = new Propose<>(self, "deal", String.class);
                self.scheduler().after(Duration.ofMillis(200), () -> {
                    deal.propose(
                            "bob",
                            "half",
                            how -> log.add("half " + how.getClass().getSimpleName()));
                    deal.propose(
                            "bob",
                            "tenth",
                            how -> log.add("tenth " + how.getClass().getSimpleName()));
                });
            });
            run.until("both have ended", () -> isLogged(2));
        }
        assertThat(log).containsExactlyInAnyOrder("half Informed", "tenth Refused");
    }

    @Test
    void oneSubscribesToNewsOfAnother() {
        try (var run = run()) {
            run.start(
                    "bob",
                    self -> new Subscribe<>(self, "news", String.class, Integer.class).answer(reader -> {
                        var number = new AtomicInteger();
                        reader.agree();
                        var issues = self.scheduler()
                                .every(Duration.ofMillis(20), () -> reader.inform(number.incrementAndGet()));
                        reader.whenUnwanted(() -> {
                            issues.cancel();
                            log.add("unwanted");
                        });
                    }));
            run.untilAllHaveBegun();
            run.start("amy", self -> {
                var news = new Subscribe<>(self, "news", String.class, Integer.class);
                self.scheduler().after(Duration.ofMillis(200), () -> {
                    var reading = new ArrayList<Conversation>();
                    reading.add(news.subscribe(
                            "bob",
                            "sports",
                            number -> {
                                log.add("number " + number);
                                if (number == 5) {
                                    reading.getFirst().cancel();
                                }
                            },
                            _ -> {}));
                });
            });
            run.until("it wants no more", () -> log.contains("unwanted"));
        }
        assertThat(log).startsWith("number 1", "number 2", "number 3", "number 4", "number 5");
    }

    @Test
    void whoPaysMostGetsIt() {
        assumeThatWaitingIsShort();
        try (var run = run()) {
            bidders(run, AgentHostContract::english);
            run.untilAllHaveBegun();
            run.start(
                    "seller",
                    self -> self.scheduler()
                            .after(
                                    Duration.ofMillis(300),
                                    () -> sell(english(self), new Auction.Prices(5, 10, 5), Duration.ofMillis(500))));
            run.until("all know", () -> isLogged(1 + BIDDERS.size()));
            run.pass(100);
        }
        assertSoldToTheRichest();
    }

    @Test
    void aDutchAuctionEndsWithTheFirstWhoWantsIt() {
        assumeThatWaitingIsShort();
        try (var run = run()) {
            bidders(run, AgentHostContract::dutch);
            run.untilAllHaveBegun();
            var enough = Duration.ofSeconds(2); // for who must be woken on a busy machine
            run.start("seller", self -> sell(dutch(self), new Auction.Prices(35, -10, 5), enough));
            run.until("all know", () -> isLogged(1 + BIDDERS.size()));
            run.pass(100);
        }
        assertSoldToTheRichest();
    }

    private static Auction<String> english(AgentContext self) {
        return Auction.english(self, "sale", String.class);
    }

    private static Auction<String> dutch(AgentContext self) {
        return Auction.dutch(self, "sale", String.class);
    }

    /// Each pays ten more than the one before, the first ten.
    private void bidders(HostRun run, Function<AgentContext, Auction<String>> auction) {
        for (int i = 0; i < BIDDERS.size(); i++) {
            String name = BIDDERS.get(i);
            int purse = 10 * (i + 1);
            run.start(
                    name,
                    self -> auction.apply(self).answer(new Auction.Bidder<>() {
                        @Override
                        public boolean pays(String lot, double price) {
                            return price <= purse;
                        }

                        @Override
                        public void ended(String lot, Auction.Sale sale) {
                            log.add("%s hears: %s to %s".formatted(name, lot, words(sale)));
                        }

                        @Override
                        public void lost(String lot, String why) {
                            log.add("%s has lost the seller: %s".formatted(name, why));
                        }
                    }));
        }
    }

    private void sell(Auction<String> auction, Auction.Prices prices, Duration round) {
        auction.sell(BIDDERS, "vase", prices, round, sale -> log.add("sold to " + words(sale)));
    }

    private static String words(Auction.Sale sale) {
        return sale.winner().orElse("nobody") + " for " + sale.price();
    }

    /// And all are told so, once.
    private void assertSoldToTheRichest() {
        assertThat(log)
                .containsExactlyInAnyOrder(
                        "sold to eve for 25.0",
                        "amy hears: vase to eve for 25.0",
                        "bob hears: vase to eve for 25.0",
                        "eve hears: vase to eve for 25.0");
    }

    @Test
    void oneIsFoundByWhatItOffers() {
        try (var run = run()) {
            run.start("bob", self -> {
                var offer = self.offer(new ServiceDescription("gripper", Map.of("reach", "0.3 m")));
                self.offer(ServiceDescription.of("lift"));
                self.subscribe(WORDS, _ -> offer.cancel());
            });
            run.untilAllHaveBegun();
            run.start("amy", self -> {
                self.directory().onChange(change -> {
                    if (change instanceof Directory.Change.Withdrew withdrew) {
                        log.add("withdrew " + withdrew.capability().name());
                    }
                });
                self.scheduler().after(Duration.ofMillis(200), () -> {
                    log.add(self.directory().offering("gripper").getFirst().name());
                    self.send("bob", WORDS, "no more");
                });
            });
            run.until("it is no more", () -> isLogged(2));
            run.act(() -> assertThat(run.platform().directory().capabilities("bob"))
                    .containsExactly(ServiceDescription.of("lift")));
        }
        assertThat(log).containsExactly("bob", "withdrew gripper");
    }

    @Test
    void itsMindCanBeLookedInto() {
        try (var run = run()) {
            run.start("amy", self -> {
                var mind = new Mind(self);
                var deep = mind.belief("deep", false);
                mind.goal("dig")
                        .priority(() -> 2)
                        .until(deep::get)
                        .plan("by spade", digging -> digging.fail("no spade"))
                        .plan("by hand", _ -> {});
                mind.goal("rest").priority(() -> 1).plan("lie down", _ -> {});
                self.subscribe(WORDS, _ -> deep.set(true));
                mind.begin();
            });
            List<String> ways = List.of("by spade", "by hand");
            List<String> rest = List.of("lie down");
            String failure = "by spade: no spade";
            untilItShows(
                    run,
                    new Mind.View(
                            Map.of("deep", "false"),
                            List.of(
                                    new GoalView("dig", GoalState.PURSUED, 2, ways, List.of("dig: by hand"), failure),
                                    new GoalView("rest", GoalState.WAITING, 1, rest, List.of(), ""))));
            run.act(() -> run.platform().publish("operator", WORDS, "deep enough"));
            untilItShows(
                    run,
                    new Mind.View(
                            Map.of("deep", "true"),
                            List.of(
                                    new GoalView("dig", GoalState.REACHED, 2, ways, List.of(), failure),
                                    new GoalView("rest", GoalState.PURSUED, 1, rest, List.of("rest: lie down"), ""))));
            run.stop("amy");
            assertThat(run.ask(() -> run.platform().look("amy", Mind.View.class)))
                    .isEmpty();
        }
    }

    private static void untilItShows(HostRun run, Mind.View mind) {
        run.until(
                "it shows " + mind,
                () -> run.platform().look("amy", Mind.View.class).equals(Optional.of(mind)));
    }

    @Test
    void whoCantBeLookedIntoTakesNoHarm() {
        try (var run = run()) {
            run.start("amy", self -> self.reveal(Integer.class, () -> 42));
            run.start(
                    "bob",
                    self -> self.reveal(Integer.class, () -> {
                        throw new IllegalStateException("a secret");
                    }));
            run.untilAllHaveBegun();
            run.act(() -> {
                assertThat(run.platform().look("amy", Integer.class)).contains(42);
                assertThat(run.platform().look("amy", Mind.View.class)).isEmpty();
                assertThat(run.platform().look("nobody", Mind.View.class)).isEmpty();
                assertThatThrownBy(() -> run.platform().look("bob", Integer.class))
                        .isInstanceOf(IllegalArgumentException.class)
                        .hasMessage("Agent 'bob' can't be inspected: a secret");
            });
            assertThat(run.status("bob")).isEqualTo(Status.RUNNING);
        }
    }

    @Test
    void devicesCallAgentsOnTheirLane() {
        try (var run = run()) {
            var world = run.ask(() -> FakeSystem.pioneers(run.scheduler(), RobotBench.WORLD, RobotBench.START));
            Robot robot = world.robots().getFirst();
            run.untilAllHaveBegun();
            run.start(
                    "amy",
                    self -> {
                        self.subscribe(self.robot().orElseThrow().require(LaserScanner.class), _ -> {
                            self.random().nextInt(); // else it would be refused that
                            log.add("seen");
                        });
                    },
                    robot);
            run.act(world::discover);
            run.until("it has seen", () -> isLogged(5));
            run.act(world::close);
            assertThat(run.status("amy")).isEqualTo(Status.RUNNING);
        }
    }

    @Test
    void agentsAreNeverAtWorkTogether() {
        var atWork = new AtomicInteger();
        var together = new AtomicInteger();
        var heard = new int[1]; // no lock: it is written in turn
        int each = Rounds.of(25, 100);
        try (var run = run()) {
            for (int i = 0; i < 20; i++) {
                run.start("agent-" + i, self -> {
                    self.subscribe(NUMBERS, _ -> {
                        if (atWork.incrementAndGet() > 1) {
                            together.incrementAndGet();
                        }
                        heard[0]++;
                        atWork.decrementAndGet();
                    });
                    self.scheduler()
                            .after(
                                    Duration.ofMillis(500),
                                    () -> IntStream.range(0, each).forEach(k -> self.publish(NUMBERS, k)));
                });
            }
            run.untilCounted("all have heard all", () -> heard[0], 20 * 19 * each);
        }
        assertThat(together).hasValue(0);
    }

    @Test
    void aThousandTalk() {
        var heard = new TreeSet<String>();
        try (var run = run()) {
            run.start("boss", self -> self.subscribe(WORDS, m -> heard.add(m.sender())));
            run.untilAllHaveBegun();
            for (int i = 0; i < MANY; i++) {
                run.start("agent-" + i, self -> self.publish(WORDS, "here"));
            }
            run.untilCounted("it has heard all", heard::size, MANY);
        }
    }

    @Test
    void opensNoPortAndLeavesNoThread() {
        Set<Thread> before = Thread.getAllStackTraces().keySet();
        Set<String> portsBefore = Ports.listening();
        try (var run = run()) {
            for (int i = 0; i < 20; i++) {
                run.start("agent-" + i, self -> {
                    self.subscribe(WORDS, m -> log.add(m.content()));
                    self.scheduler().every(Duration.ofMillis(50), () -> self.publish(WORDS, "hi"));
                });
            }
            run.until("they talk", () -> isLogged(100));
            assertThat(Ports.listening()).isSubsetOf(portsBefore);
        }
        assertThat(threadsLeft(before)).isEmpty();
        assertThat(Ports.listening()).isSubsetOf(portsBefore);
    }

    /// Those that are still there after a while.
    private List<String> threadsLeft(Set<Thread> before) {
        Optional<List<String>> left = Optional.empty();
        for (int look = 0; look < 100 && left.filter(List::isEmpty).isEmpty(); look++) {
            List<Thread> more = Thread.getAllStackTraces().keySet().stream()
                    .filter(thread -> !before.contains(thread) && thread.isAlive() && !endsLater(thread))
                    .toList();
            for (Thread thread : more.stream().limit(1).toList()) {
                try {
                    thread.join(Duration.ofMillis(100));
                } catch (InterruptedException e) {
                    throw new AssertionError(e);
                }
            }
            left = Optional.of(more.stream().map(Thread::getName).toList());
        }
        return left.orElseThrow();
    }
}
