package rsal.agent.protocol;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.TreeMap;
import java.util.concurrent.atomic.AtomicReference;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.agent.AgentContext;
import rsal.agent.platform.AgentPlatform.Status;
import rsal.agent.platform.Run;
import rsal.agent.protocol.ContractNet.Call;
import rsal.agent.protocol.ContractNet.Contract;
import rsal.agent.protocol.ContractNet.Contractor;
import rsal.agent.protocol.ContractNet.Manager;
import rsal.agent.protocol.ContractNet.Proposal;
import rsal.agent.protocol.ContractNet.Round;
import rsal.agent.protocol.ContractNet.Verdict;

class ContractNetTest {
    private static final Duration SECOND = Duration.ofSeconds(1);

    private final Run run = new Run();
    private final List<String> log = new ArrayList<>();
    private final List<Round<Double>> rounds = new ArrayList<>();

    private static ContractNet<String, Double, String> net(AgentContext self) {
        return new ContractNet<>(self, "carry", String.class, Double.class, String.class);
    }

    /// Bids always the same, and does it within some time.
    private Contractor<String, Double, String> worker(AgentContext self, double bid, double seconds) {
        return new Contractor<>() {
            @Override
            public void called(Call<String, Double> call) {
                if (bid < 0) {
                    call.refuse("busy");
                } else {
                    call.propose(bid);
                }
            }

            @Override
            public void accepted(Contract<String, String> contract) {
                log.add(self.name() + " does " + contract.task());
                contract.whenUnwanted(() -> log.add(self.name() + " stops"));
                self.scheduler().after(Duration.ofMillis(Math.round(seconds * 1000)), () -> contract.inform("done"));
            }

            @Override
            public void rejected(Call<String, Double> call, String why) {
                log.add(self.name() + " is rejected");
            }
        };
    }

    private void worker(String name, double bid, double seconds) {
        run.start(name, self -> net(self).answer(worker(self, bid, seconds)));
    }

    /// Takes the least bid.
    private Manager<String, Double, String> thrifty() {
        return new Manager<>() {
            @Override
            public Verdict<String> decide(Round<Double> round) {
                rounds.add(round);
                return round.proposals().stream()
                        .min(Comparator.comparingDouble(Proposal::bid))
                        .map(Verdict::<String>award)
                        .orElseGet(Verdict::none);
            }

            @Override
            public void ended(Proposal<Double> accepted, ConversationResult<String> how) {
                log.add("%s: %s".formatted(accepted.from(), how));
            }
        };
    }

    private void manager(String... to) {
        run.start("zoe", self -> net(self).call(List.of(to), "a box", SECOND, thrifty()));
    }

    @Test
    void leastBidGetsTheTask() {
        List<String> said = run.transcript();
        worker("amy", 3, 0);
        worker("bob", 2, 0);
        worker("eve", -1, 0);
        manager("eve", "bob", "amy");
        run.advance(0);
        assertThat(said)
                .containsExactly(
                        "zoe -> amy: cfp: a box",
                        "zoe -> bob: cfp: a box",
                        "zoe -> eve: cfp: a box",
                        "amy -> zoe: propose: 3.0",
                        "bob -> zoe: propose: 2.0",
                        "eve -> zoe: refuse: busy",
                        "zoe -> amy: reject-proposal: Another bid was accepted, or none.",
                        "zoe -> bob: accept-proposal: a box",
                        "bob -> zoe: inform: done");
        assertThat(log)
                .containsExactly(
                        "amy is rejected", "bob does a box", "bob: " + new ConversationResult.Informed<>("done"));
        assertThat(rounds.getFirst().refusals()).isEqualTo(Map.of("eve", "busy"));
    }

    @Test
    void roundEndsWithoutThoseWhoSayNothing() {
        worker("amy", 3, 0);
        run.start(
                "bob",
                self -> net(self).answer(new Contractor<String, Double, String>() {
                    @Override
                    public void called(Call<String, Double> call) {
                        self.scheduler().after(Duration.ofSeconds(2), () -> call.propose(1.0));
                    }

                    @Override
                    public void accepted(Contract<String, String> contract) {
                        log.add("bob does it");
                    }

                    @Override
                    public void rejected(Call<String, Double> call, String why) {
                        log.add("bob: " + why);
                    }
                }));
        manager("amy", "bob", "nobody");
        run.advance(0.9);
        assertThat(rounds).isEmpty();
        run.advance(5);
        assertThat(rounds).hasSize(1);
        assertThat(rounds.getFirst().silent()).isEqualTo(Set.of("bob", "nobody"));
        assertThat(log)
                .containsExactly(
                        "amy does a box", "amy: " + new ConversationResult.Informed<>("done"), "bob: It is too late.");
    }

    @Test
    void nobodyCalledIsARoundWithoutBids() {
        manager();
        run.advance(0);
        assertThat(rounds).containsExactly(new Round<>(1, List.of(), Map.of(), Set.of()));
    }

    @Test
    void severalMayGetIt() {
        for (String name : List.of("amy", "bob", "eve")) {
            worker(name, 1, 0);
        }
        run.start(
                "zoe",
                self -> net(self)
                        .call(List.of("amy", "bob", "eve"), "a box", SECOND, new Manager<String, Double, String>() {
                            @Override
                            public Verdict<String> decide(Round<Double> round) {
                                return new Verdict.Award<>(Set.of("amy", "eve"));
                            }
                        }));
        run.advance(0);
        assertThat(log).containsExactlyInAnyOrder("amy does a box", "bob is rejected", "eve does a box");
    }

    @Test
    void severalMayGetAShareEachAndOneOfThemMayBeStopped() {
        List.of("amy", "bob", "eve").forEach(name -> worker(name, 1, 60));
        run.start("zoe", self -> {
            var tender = net(self).call(List.of("amy", "bob", "eve"), "boxes", SECOND, new Manager<>() {
                @Override
                public Verdict<String> decide(Round<Double> round) {
                    return new Verdict.Share<>(Map.of("amy", "box 1", "eve", "box 2"));
                }

                @Override
                public void ended(Proposal<Double> accepted, ConversationResult<String> how) {
                    log.add("%s: %s".formatted(accepted.from(), how));
                }
            });
            self.scheduler().after(Duration.ofSeconds(5), () -> tender.cancel("amy"));
            self.scheduler().after(Duration.ofSeconds(6), () -> tender.cancel("bob")); // has nothing
        });
        run.advance(100);
        assertThat(log)
                .containsExactly(
                        "amy does box 1",
                        "bob is rejected",
                        "eve does box 2",
                        "amy: " + new ConversationResult.Cancelled<>(),
                        "amy stops",
                        "eve: " + new ConversationResult.Informed<>("done"));
    }

    @Test
    void managerLearnsWhenTheWorkerDies() {
        worker("amy", 3, 60);
        manager("amy");
        run.advance(10);
        run.stop("amy");
        run.advance(0);
        assertThat(log)
                .containsExactly("amy does a box", "amy: " + new ConversationResult.Silent<>("'amy' has ended."));
    }

    @Test
    void managerLearnsWhenTheWorkerIsSilencedWithinItsPatience() {
        var silenced = new AtomicReference<>("");
        run.deliverBy((message, listener) -> message.sender().equals(silenced.get()) || listener.equals(silenced.get())
                ? List.of()
                : List.of(Duration.ZERO));
        worker("amy", 3, 60);
        manager("amy");
        run.advance(10);
        silenced.set("amy");
        run.advance(4);
        assertThat(log).hasSize(1);
        run.advance(2.1);
        assertThat(log).hasSize(2).last().asString().contains("Silent");
    }

    @Test
    void workerStopsWhenItIsCancelled() {
        worker("amy", 3, 60);
        run.start("zoe", self -> {
            Conversation call = net(self).call(List.of("amy"), "a box", SECOND, thrifty());
            self.scheduler().after(Duration.ofSeconds(5), call::cancel);
        });
        run.advance(100);
        assertThat(log).containsExactly("amy does a box", "amy: " + new ConversationResult.Cancelled<>(), "amy stops");
    }

    @Test
    void managerWhoAcceptsWhatNobodyBidIsEndedByName() {
        worker("amy", 3, 0);
        run.start(
                "zoe",
                self -> net(self).call(List.of("amy"), "a box", SECOND, _ -> new Verdict.Award<>(Set.of("bob"))));
        run.advance(0);
        assertThat(run.view("zoe").status()).isEqualTo(Status.FAILED);
        assertThat(run.view("zoe").state()).contains("'zoe'").contains("[bob]");
        assertThat(run.view("amy").status()).isEqualTo(Status.RUNNING);
        assertThat(log).containsExactly("amy is rejected");
    }

    @Test
    void managerMayCallAgainWhenItIsIterated() {
        var heard = new ArrayList<Integer>();
        for (String name : List.of("amy", "bob")) {
            run.start(
                    name,
                    self -> ContractNet.iterated(self, "haggle", Integer.class, Integer.class, String.class)
                            .answer(new Contractor<>() {
                                @Override
                                public void called(Call<Integer, Integer> call) {
                                    heard.add(call.task());
                                    if (name.equals("amy") && call.task() < 8) {
                                        call.refuse("too little");
                                    } else {
                                        call.propose(call.task());
                                    }
                                }

                                @Override
                                public void accepted(Contract<Integer, String> contract) {
                                    contract.inform(name + " for " + contract.task());
                                }
                            }));
        }
        var results = new ArrayList<ConversationResult<String>>();
        run.start(
                "zoe",
                self -> ContractNet.iterated(self, "haggle", Integer.class, Integer.class, String.class)
                        .call(List.of("amy", "bob"), 10, SECOND, new Manager<>() {
                            @Override
                            public Verdict<Integer> decide(Round<Integer> round) {
                                return round.proposals().size() > 1
                                        ? Verdict.again(10 - 2 * round.number())
                                        : Verdict.award(round.proposals().getFirst());
                            }

                            @Override
                            public void ended(Proposal<Integer> accepted, ConversationResult<String> how) {
                                results.add(how);
                            }
                        }));
        run.advance(0);
        assertThat(heard).containsExactly(10, 10, 8, 8, 6, 6);
        assertThat(results).containsExactly(new ConversationResult.Informed<>("bob for 6"));
    }

    @Test
    void managerMayNotCallAgainWhenItIsNot() {
        worker("amy", 3, 0);
        run.start("zoe", self -> net(self).call(List.of("amy"), "a box", SECOND, _ -> Verdict.again("a bag")));
        run.advance(0);
        assertThat(run.view("zoe").state()).contains("'cfp'").contains("fipa-contract-net");
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.1, 0.2, 0.4})
    void inBadWeatherEachTaskIsDoneByOneAtMostAndEndsOnce(double loss) {
        int done = 0;
        for (int seed = 0; seed < 200; seed++) {
            var storm = new Run();
            storm.deliverBy(new Weather(new SplittableRandom(seed), loss, 0.2, Duration.ofMillis(200)));
            var accepted = new TreeMap<String, Integer>();
            for (String name : List.of("amy", "bob", "eve")) {
                storm.start(
                        name,
                        self -> net(self).answer(new Contractor<>() {
                            @Override
                            public void called(Call<String, Double> call) {
                                call.propose(self.random().nextDouble());
                            }

                            @Override
                            public void accepted(Contract<String, String> contract) {
                                accepted.merge(name, 1, Integer::sum);
                                self.scheduler().after(Duration.ofSeconds(20), () -> contract.inform(name));
                            }
                        }));
            }
            var ends = new ArrayList<ConversationResult<String>>();
            var decisions = new ArrayList<Round<Double>>();
            storm.start(
                    "zoe",
                    self -> net(self)
                            .call(List.of("amy", "bob", "eve"), "a box", Duration.ofSeconds(3), new Manager<>() {
                                @Override
                                public Verdict<String> decide(Round<Double> round) {
                                    decisions.add(round);
                                    return round.proposals().isEmpty()
                                            ? Verdict.none()
                                            : Verdict.award(round.proposals().getFirst());
                                }

                                @Override
                                public void ended(Proposal<Double> winner, ConversationResult<String> how) {
                                    ends.add(how);
                                }
                            }));
            storm.advance(120);
            assertThat(decisions).as("seed %d", seed).hasSize(1);
            assertThat(accepted.values())
                    .as("seed %d", seed)
                    .hasSizeLessThanOrEqualTo(1)
                    .allMatch(n -> n == 1);
            assertThat(ends)
                    .as("seed %d", seed)
                    .hasSize(decisions.getFirst().proposals().isEmpty() ? 0 : 1);
            for (ConversationResult<String> end : ends) {
                if (end instanceof ConversationResult.Informed<String>(String by)) {
                    assertThat(accepted).containsOnlyKeys(by);
                    done++;
                } else {
                    assertThat(end).as("seed %d", seed).isInstanceOf(ConversationResult.Silent.class);
                }
            }
        }
        assertThat(done).isGreaterThan(loss < 0.3 ? 190 : 120);
    }
}
