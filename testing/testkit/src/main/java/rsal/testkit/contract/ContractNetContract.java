package rsal.testkit.contract;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.BiConsumer;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import rsal.agent.AgentContext;
import rsal.agent.AgentHostProvider;
import rsal.agent.Topic;
import rsal.agent.platform.AgentPlatform.Status;
import rsal.agent.protocol.ContractNet;
import rsal.agent.protocol.ContractNet.Call;
import rsal.agent.protocol.ContractNet.Contract;
import rsal.agent.protocol.ContractNet.Contractor;
import rsal.agent.protocol.ContractNet.Manager;
import rsal.agent.protocol.ContractNet.Proposal;
import rsal.agent.protocol.ContractNet.Round;
import rsal.agent.protocol.ContractNet.Verdict;
import rsal.agent.protocol.Conversation;
import rsal.agent.protocol.ConversationResult;
import rsal.agent.protocol.RetryPolicy;
import rsal.testkit.LongTest;

/// How contract nets end, well and otherwise, the same on every host: what an agent does next is set off by what it has
/// heard, not by a time, so that no thread can come too early.
public abstract class ContractNetContract {
    static final Topic<String> WORDS = new Topic<>("words", String.class);

    /// Longer than any test, for rounds that end by what is said.
    private static final Duration EVER = Duration.ofMinutes(10);

    /// Enough for all who answer at once, also on a machine that has much else to do.
    private static final Duration LIMIT = Duration.ofSeconds(3);

    private static final RetryPolicy ENDLESS = new RetryPolicy(Duration.ofSeconds(1), EVER);

    /// Written by agents, in turn.
    final List<String> log = new ArrayList<>();

    /// What managers had to decide upon, in turn.
    private final List<Round<Double>> rounds = new ArrayList<>();

    /// The host under test.
    protected abstract AgentHostProvider provider();

    /// How it is set up, where that is not by its fallbacks.
    protected Map<String, Object> settings() {
        return Map.of();
    }

    final HostRun run() {
        return new HostRun(provider(), settings());
    }

    /// For tests in which seconds pass: where the host lives on real time, only `./rsal test --all` waits for them.
    final void assumeThatWaitingIsShort() {
        assumeTrue(
                provider().followsSchedulerTime() || Boolean.getBoolean(LongTest.PROPERTY),
                "waits in real time: runs by ./rsal test --all");
    }

    final boolean isLogged(int lines) {
        return log.size() >= lines;
    }

    @Test
    void theCheapestGetsTheTask() {
        try (var run = run()) {
            Set<String> workers =
                    IntStream.rangeClosed(1, 20).mapToObj(i -> "worker-" + i).collect(Collectors.toSet());
            workers.forEach(name -> worker(
                    run,
                    name,
                    bids(100 - Integer.parseInt(name.replace("worker-", ""))),
                    (_, contract) -> contract.inform("dug")));
            run.untilAllHaveBegun();
            run.start("boss", self -> call(self, workers, EVER, ENDLESS, new Boss(ContractNetContract::cheapest)));
            run.until("all know", () -> isLogged(21));
        }
        assertThat(rounds).singleElement().satisfies(round -> {
            assertThat(round.proposals()).hasSize(20);
            assertThat(round.refusals()).isEmpty();
            assertThat(round.silent()).isEmpty();
        });
        assertThat(log)
                .contains("worker-20 digs", "worker-20: Informed[result=dug]")
                .filteredOn(line -> line.endsWith(" is rejected: Another bid was accepted, or none."))
                .hasSize(19);
    }

    @Test
    void whoDoesNotAnswerInTimeComesTooLate() {
        assumeThatWaitingIsShort();
        try (var run = run()) {
            worker(run, "amy", bids(3), (_, contract) -> contract.inform("dug"));
            worker(
                    run,
                    "bob",
                    (self, call) -> self.subscribe(WORDS, _ -> call.propose(1.0)),
                    (_, contract) -> contract.inform("dug"));
            run.untilAllHaveBegun();
            run.start("boss", self -> {
                var boss = new Boss(round -> {
                    self.send("bob", WORDS, "It is decided.");
                    return cheapest(round);
                });
                call(self, Set.of("amy", "bob", "nobody"), LIMIT, ENDLESS, boss);
            });
            run.until("all know", () -> isLogged(3));
        }
        assertThat(rounds)
                .containsExactly(
                        new Round<>(1, List.of(new Proposal<>("amy", 3.0)), Map.of(), Set.of("bob", "nobody")));
        assertThat(log)
                .containsExactlyInAnyOrder("amy digs", "amy: Informed[result=dug]", "bob is rejected: It is too late.");
    }

    @Test
    void whoRefusesOrLeavesIsNotWaitedFor() {
        try (var run = run()) {
            worker(run, "amy", bids(3), (_, contract) -> contract.inform("dug"));
            worker(
                    run,
                    "bob",
                    (self, call) -> {
                        call.propose(1.0);
                        self.send("boss", WORDS, "bob has bid");
                    },
                    (_, _) -> {});
            worker(run, "dan", (_, _) -> log.add("dan thinks"), (_, _) -> {});
            worker(run, "eve", (_, call) -> call.refuse("busy"), (_, _) -> {});
            run.untilAllHaveBegun();
            run.start("boss", self -> {
                self.subscribe(WORDS, m -> log.add(m.content()));
                call(self, Set.of("amy", "bob", "dan", "eve"), EVER, ENDLESS, new Boss(ContractNetContract::cheapest));
            });
            run.until("both have heard the call", () -> isLogged(2));
            run.stop("bob");
            run.stop("dan");
            run.until("it is done", () -> isLogged(4));
        }
        assertThat(rounds)
                .containsExactly(new Round<>(
                        1,
                        List.of(new Proposal<>("amy", 3.0)),
                        Map.of("bob", "'bob' has ended.", "dan", "'dan' has ended.", "eve", "busy"),
                        Set.of()));
        assertThat(log).containsExactlyInAnyOrder("bob has bid", "dan thinks", "amy digs", "amy: Informed[result=dug]");
    }

    @Test
    void eachTaskEndsForItself() {
        try (var run = run()) {
            worker(run, "amy", bids(1), (_, contract) -> contract.inform("dug"));
            worker(run, "bob", bids(2), (_, contract) -> contract.fail("no spade"));
            worker(run, "dan", bids(3), (_, _) -> {
                throw new IllegalStateException("a slip");
            });
            worker(run, "eve", bids(4), (_, _) -> {});
            run.untilAllHaveBegun();
            run.start(
                    "boss",
                    self -> call(
                            self,
                            Set.of("amy", "bob", "dan", "eve"),
                            EVER,
                            ENDLESS,
                            new Boss(ContractNetContract::all)));
            run.until("the others have ended", () -> isLogged(7));
            run.stop("eve");
            run.until("all have ended", () -> isLogged(8));
            assertThat(run.status("boss")).isEqualTo(Status.RUNNING);
            assertThat(run.status("dan")).isEqualTo(Status.FAILED);
        }
        assertThat(log)
                .containsExactlyInAnyOrder(
                        "amy digs",
                        "bob digs",
                        "dan digs",
                        "eve digs",
                        "amy: Informed[result=dug]",
                        "bob: Failed[why=no spade]",
                        "dan: Silent[why='dan' has ended.]",
                        "eve: Silent[why='eve' has ended.]");
        assertThat(log.getLast()).startsWith("eve: ");
    }

    @Test
    void whoIsNotHeardAnyMoreIsGivenUp() {
        assumeThatWaitingIsShort();
        try (var run = run()) {
            worker(run, "amy", bids(3), (_, _) -> {});
            run.untilAllHaveBegun();
            run.start(
                    "boss",
                    self -> call(
                            self,
                            Set.of("amy"),
                            EVER,
                            new RetryPolicy(Duration.ofMillis(500), LIMIT),
                            new Boss(ContractNetContract::cheapest)));
            run.until("it digs", () -> isLogged(1));
            run.deliverBy((message, _) -> message.sender().equals("amy") ? List.of() : List.of(Duration.ZERO));
            run.until("it is given up", () -> isLogged(2));
        }
        assertThat(log.getFirst()).isEqualTo("amy digs");
        assertThat(log.getLast()).startsWith("amy: Silent[why=Nothing was heard of 'amy' for ");
    }

    /// Bob's result crosses the news that nobody waits for it.
    @Test
    void whoWorksStopsWhenItIsCancelled() {
        try (var run = run()) {
            worker(
                    run,
                    "amy",
                    bids(3),
                    (self, contract) -> contract.whenUnwanted(() -> {
                        log.add("amy stops");
                        contract.inform("dug"); // as nobody hears
                        self.send("boss", WORDS, "amy has stopped");
                    }));
            worker(run, "bob", bids(4), (self, contract) -> {
                self.send("boss", WORDS, "bob begins");
                contract.inform("dug");
            });
            run.untilAllHaveBegun();
            run.start("boss", self -> {
                Conversation net = call(self, Set.of("amy", "bob"), EVER, ENDLESS, new Boss(ContractNetContract::all));
                self.subscribe(WORDS, heard -> {
                    if (heard.sender().equals("bob")) {
                        net.cancel();
                    } else {
                        log.add(heard.content());
                    }
                });
            });
            run.until("it has stopped", () -> log.contains("amy has stopped"));
        }
        assertThat(log)
                .containsExactlyInAnyOrder(
                        "amy digs", "bob digs", "amy: Cancelled[]", "bob: Cancelled[]", "amy stops", "amy has stopped");
    }

    @Test
    void whatIsCancelledBeforeItIsDecidedIsNothingForAnybody() {
        try (var run = run()) {
            worker(
                    run,
                    "amy",
                    (self, call) -> {
                        call.propose(3.0);
                        self.send("boss", WORDS, "amy has bid");
                    },
                    (_, _) -> {});
            worker(
                    run,
                    "bob",
                    (self, call) -> {
                        self.subscribe(WORDS, _ -> {
                            call.propose(1.0); // as nobody hears
                            log.add("bob has bid");
                        });
                        self.send("boss", WORDS, "bob thinks");
                    },
                    (_, _) -> {});
            run.untilAllHaveBegun();
            run.start("boss", self -> {
                Conversation net =
                        call(self, Set.of("amy", "bob"), EVER, ENDLESS, new Boss(ContractNetContract::cheapest));
                var called = new AtomicInteger();
                self.subscribe(WORDS, _ -> {
                    if (called.incrementAndGet() == 2) {
                        net.cancel();
                        self.send("bob", WORDS, "It is over.");
                    }
                });
            });
            run.until("both know", () -> isLogged(2));
            assertThat(run.status("bob")).isEqualTo(Status.RUNNING);
        }
        assertThat(rounds).isEmpty();
        assertThat(log).containsExactlyInAnyOrder("amy is rejected: 'boss' has cancelled it.", "bob has bid");
    }

    @Test
    void whoWorksStopsWhenTheManagerHasGone() {
        try (var run = run()) {
            worker(
                    run,
                    "amy",
                    bids(3),
                    (_, contract) -> contract.whenUnwanted(() -> {
                        contract.fail("The boss has gone."); // as nobody hears
                        log.add("amy stops");
                    }));
            run.untilAllHaveBegun();
            run.start(
                    "boss", self -> call(self, Set.of("amy"), EVER, ENDLESS, new Boss(ContractNetContract::cheapest)));
            run.until("it digs", () -> isLogged(1));
            run.stop("boss");
            run.until("it stops", () -> isLogged(2));
            assertThat(run.status("amy")).isEqualTo(Status.RUNNING);
        }
        assertThat(log).containsExactly("amy digs", "amy stops");
    }

    @Test
    void whoHagglesCallsAgain() {
        try (var run = run()) {
            haggler(run, "amy", 8);
            haggler(run, "bob", 0);
            run.untilAllHaveBegun();
            run.start(
                    "boss",
                    self -> haggling(self).call(Set.of("amy", "bob"), 10, EVER, new Manager<>() {
                        @Override
                        public Verdict<Integer> decide(Round<Integer> round) {
                            log.add("round %d: %d bids, refused: %s"
                                    .formatted(round.number(), round.proposals().size(), round.refusals()));
                            return round.proposals().size() > 1
                                    ? Verdict.again(10 - 2 * round.number())
                                    : Verdict.award(round.proposals().getFirst());
                        }

                        @Override
                        public void ended(Proposal<Integer> accepted, ConversationResult<String> how) {
                            log.add("%s: %s".formatted(accepted.from(), how));
                        }
                    }));
            run.until("it is done", () -> isLogged(4));
        }
        assertThat(log)
                .containsExactly(
                        "round 1: 2 bids, refused: {}",
                        "round 2: 2 bids, refused: {}",
                        "round 3: 1 bids, refused: {amy=too little}",
                        "bob: Informed[result=for 6]");
    }

    private static ContractNet<Integer, Integer, String> haggling(AgentContext self) {
        return ContractNet.iterated(self, "haggle", Integer.class, Integer.class, String.class);
    }

    /// @param least for which it works
    private static void haggler(HostRun run, String name, int least) {
        run.start(
                name,
                self -> haggling(self).answer(new Contractor<>() {
                    @Override
                    public void called(Call<Integer, Integer> call) {
                        if (call.task() < least) {
                            call.refuse("too little");
                        } else {
                            call.propose(call.task());
                        }
                    }

                    @Override
                    public void accepted(Contract<Integer, String> contract) {
                        contract.inform("for " + contract.task());
                    }
                }));
    }

    private static ContractNet<String, Double, String> net(AgentContext self) {
        return new ContractNet<>(self, "work", String.class, Double.class, String.class);
    }

    private static Conversation call(
            AgentContext self, Set<String> to, Duration replyWithin, RetryPolicy patience, Boss boss) {
        return net(self).call(to, "dig", replyWithin, patience, boss);
    }

    private void worker(
            HostRun run,
            String name,
            BiConsumer<AgentContext, Call<String, Double>> answer,
            BiConsumer<AgentContext, Contract<String, String>> work) {
        run.start(name, self -> net(self).answer(new Worker(self, answer, work)));
    }

    private static BiConsumer<AgentContext, Call<String, Double>> bids(double bid) {
        return (_, call) -> call.propose(bid);
    }

    private static Verdict<String> cheapest(Round<Double> round) {
        return round.proposals().stream()
                .min(Comparator.comparingDouble(Proposal::bid))
                .map(Verdict::<String>award)
                .orElseGet(Verdict::none);
    }

    private static Verdict<String> all(Round<Double> round) {
        return new Verdict.Award<>(
                round.proposals().stream().map(Proposal::from).collect(Collectors.toSet()));
    }

    private final class Worker implements Contractor<String, Double, String> {
        private final AgentContext self;
        private final BiConsumer<AgentContext, Call<String, Double>> answer;
        private final BiConsumer<AgentContext, Contract<String, String>> work;

        Worker(
                AgentContext self,
                BiConsumer<AgentContext, Call<String, Double>> answer,
                BiConsumer<AgentContext, Contract<String, String>> work) {
            this.self = self;
            this.answer = answer;
            this.work = work;
        }

        @Override
        public void called(Call<String, Double> call) {
            answer.accept(self, call);
        }

        @Override
        public void accepted(Contract<String, String> contract) {
            log.add(self.name() + " digs");
            work.accept(self, contract);
        }

        @Override
        public void rejected(Call<String, Double> call, String why) {
            log.add(self.name() + " is rejected: " + why);
        }
    }

    private final class Boss implements Manager<String, Double, String> {
        private final Function<Round<Double>, Verdict<String>> rule;

        Boss(Function<Round<Double>, Verdict<String>> rule) {
            this.rule = rule;
        }

        @Override
        public Verdict<String> decide(Round<Double> round) {
            rounds.add(round);
            return rule.apply(round);
        }

        @Override
        public void ended(Proposal<Double> accepted, ConversationResult<String> how) {
            log.add("%s: %s".formatted(accepted.from(), how));
        }
    }
}
