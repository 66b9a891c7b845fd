package rsal.jade;

import static org.assertj.core.api.Assertions.assertThat;

import jade.core.AID;
import jade.lang.acl.ACLMessage;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import rsal.agent.AgentContext;
import rsal.agent.Topic;
import rsal.agent.protocol.ContractNet;
import rsal.agent.protocol.ContractNet.Call;
import rsal.agent.protocol.ContractNet.Contract;
import rsal.agent.protocol.ContractNet.Contractor;
import rsal.agent.protocol.ContractNet.Manager;
import rsal.agent.protocol.ContractNet.Proposal;
import rsal.agent.protocol.ContractNet.Round;
import rsal.agent.protocol.ContractNet.Verdict;
import rsal.agent.protocol.ContractNetInitiator;
import rsal.agent.protocol.ConversationResult;
import rsal.agent.protocol.RetryPolicy;

/// What JADE's window of who says what is told of a contract net: FIPA's (SC00029H), with all that may be said in it.
@Timeout(60)
class JadeSnifferTest {
    private static final Topic<String> WORDS = new Topic<>("words", String.class);
    private static final Duration EVER = Duration.ofMinutes(10);
    private static final RetryPolicy ENDLESS = new RetryPolicy(EVER, EVER); // so that nothing is said twice

    private final Map<String, Instant> deadlines = new TreeMap<>(); // that were heard, by agent
    private final List<String> begun = new ArrayList<>();

    @Test
    void aContractNetIsSeenWithAllItsPerformatives() {
        try (var run = new JadeRun()) {
            worker(run, "amy", call -> call.propose(1.0), contract -> contract.inform("dug"));
            worker(run, "bob", call -> call.propose(2.0), contract -> contract.fail("no spade"));
            worker(run, "cid", call -> call.propose(3.0), _ -> {});
            worker(run, "dan", call -> call.propose(4.0), _ -> {});
            worker(run, "eve", call -> call.refuse("busy"), _ -> {});
            run.start("fay", self -> {
                net(self); // knows of them, and answers none
                begun.add("fay");
            });
            run.start("boss", self -> {
                self.subscribe(WORDS, _ -> new Boss().begin(self));
                begun.add("boss");
            });
            run.until("they have begun", () -> begun.size() == 7);
            Witness sniffer = run.witness("witness").ready();
            sniffer.sniffs("amy", "bob", "boss", "cid", "dan", "eve", "fay");
            run.act(() -> run.platform().send("operator", "boss", WORDS, "go on"));

            List<ACLMessage> seen =
                    IntStream.range(0, 20).mapToObj(_ -> sniffer.overhears()).toList();

            assertThat(seen)
                    .extracting(JadeSnifferTest::words)
                    .containsExactlyInAnyOrder(
                            "boss to amy: cfp dig",
                            "boss to bob: cfp dig",
                            "boss to cid: cfp dig",
                            "boss to dan: cfp dig",
                            "boss to eve: cfp dig",
                            "boss to fay: cfp dig",
                            "amy to boss: propose 1.0",
                            "bob to boss: propose 2.0",
                            "cid to boss: propose 3.0",
                            "dan to boss: propose 4.0",
                            "eve to boss: refuse busy",
                            "fay to boss: not-understood 'fay' does not answer 'work'.",
                            "boss to amy: accept-proposal dig",
                            "boss to bob: accept-proposal dig",
                            "boss to cid: accept-proposal dig",
                            "boss to dan: reject-proposal Another bid was accepted, or none.",
                            "amy to boss: inform dug",
                            "bob to boss: failure no spade",
                            "boss to cid: cancel",
                            "cid to boss: inform cancelled");
            assertThat(seen).allSatisfy(message -> {
                assertThat(message.getProtocol()).isEqualTo("fipa-contract-net");
                assertThat(message.getConversationId())
                        .startsWith("boss:work:")
                        .isEqualTo(seen.getFirst().getConversationId());
                assertThat(message.getOntology()).isEqualTo("rsal");
                assertThat(message.getUserDefinedParameter("topic")).isEqualTo("work"); // JADE reads no "X-"
                if (message.getPerformative() == ACLMessage.CFP) {
                    assertThat(message.getReplyByDate().toInstant())
                            .isEqualTo(Instant.ofEpochMilli(deadlines.get("amy").toEpochMilli()));
                } else {
                    assertThat(message.getReplyByDate()).isNull();
                }
            });
        }
    }

    /// `amy to boss: propose 1.0`
    private static String words(ACLMessage message) {
        return "%s to %s: %s %s"
                .formatted(
                        message.getSender().getLocalName(),
                        ((AID) message.getAllReceiver().next()).getLocalName(),
                        ACLMessage.getPerformative(message.getPerformative()).toLowerCase(Locale.ROOT),
                        Objects.requireNonNullElse(message.getContent(), ""))
                .strip();
    }

    private static ContractNet<String, Double, String> net(AgentContext self) {
        return new ContractNet<>(self, "work", String.class, Double.class, String.class);
    }

    private void worker(
            JadeRun run, String name, Consumer<Call<String, Double>> answer, Consumer<Contract<String, String>> work) {
        run.start(name, self -> {
            net(self).answer(new Contractor<>() {
                @Override
                public void called(Call<String, Double> call) {
                    deadlines.put(name, call.replyBy());
                    answer.accept(call);
                }

                @Override
                public void accepted(Contract<String, String> contract) {
                    work.accept(contract);
                }
            });
            begun.add(name);
        });
    }

    /// Wants the task of the three cheapest, and when two have ended no more of the third.
    private static final class Boss implements Manager<String, Double, String> {
        private ContractNetInitiator<String, Double, String> net; // once it has called
        private int ended;

        void begin(AgentContext self) {
            net = net(self).call(List.of("amy", "bob", "cid", "dan", "eve", "fay"), "dig", EVER, ENDLESS, this);
        }

        @Override
        public Verdict<String> decide(Round<Double> round) {
            return new Verdict.Award<>(Set.of("amy", "bob", "cid"));
        }

        @Override
        public void ended(Proposal<Double> accepted, ConversationResult<String> how) {
            ended++;
            if (ended == 2) {
                net.cancel("cid");
            }
        }
    }
}
