package rsal.agents;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import rsal.agent.AgentContext;
import rsal.agent.Directory;
import rsal.agent.message.CollectGoal;
import rsal.agent.message.Collected;
import rsal.agent.protocol.ContractNet;
import rsal.agent.protocol.ContractNet.Proposal;
import rsal.agent.protocol.ContractNet.Round;
import rsal.agent.protocol.ContractNet.Verdict;
import rsal.agent.protocol.Ending;
import rsal.agent.protocol.Request;
import rsal.agents.Collecting.Bid;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// Has things collected by robots that can, and by another when one fails or falls silent. Either all are called and
/// the one that bids least gets it (contract net), one thing at a time, so that each bid counts what went before; or
/// they are asked one after the other and the first that is free gets it (request). What nobody wants waits.
final class Hiring {
    static final Parameter ALLOTMENT = Parameter.choice(
            "allotment",
            "bid",
            List.of("bid", "first"),
            "Who gets to collect a thing: who bids the shortest way, or the first that is free.");

    private static final Duration REPLY = Duration.ofSeconds(2);
    private static final Duration RETRY = Duration.ofSeconds(2);
    private static final Duration REPEAT = Duration.ofSeconds(4); // two of them may get lost within Finds.MEMORY
    private static final Duration AVOID = Duration.ofSeconds(30); // one that fell silent
    private static final int TRIES = 3;

    private final AgentContext self;
    private final boolean bids;
    private final Request<CollectGoal, Collected> requests;
    private final ContractNet<CollectGoal, Bid, Collected> calls;
    private final List<Order> orders = new ArrayList<>();
    private final Map<String, Instant> silentUntil = new HashMap<>();
    private boolean calling;

    private static final class Order {
        private final CollectGoal goal;
        private boolean waiting = true;
        private int failures;

        Order(CollectGoal goal) {
            this.goal = goal;
        }
    }

    Hiring(AgentContext self, Arguments arguments) {
        this.self = self;
        this.bids = arguments.text(ALLOTMENT.name()).equals("bid");
        this.requests = Collecting.requests(self);
        this.calls = Collecting.calls(self);
    }

    void begin() {
        self.scheduler().every(RETRY, this::allot);
        self.scheduler().every(REPEAT, () -> orders.forEach(order -> self.publish(CollectGoal.TOPIC, order.goal)));
    }

    void add(CollectGoal goal) {
        orders.add(new Order(goal));
        allot();
    }

    boolean isUnderWay(CollectGoal goal) {
        return orders.stream().anyMatch(order -> order.goal.isSame(goal));
    }

    private void allot() {
        self.show("things", orders.isEmpty() ? "none" : orders.size() + " to be collected");
        List<Order> waiting = orders.stream().filter(order -> order.waiting).toList();
        List<String> collectors = collectors();
        if (collectors.isEmpty() || waiting.isEmpty()) {
            return;
        }
        if (!bids) {
            for (Order order : waiting) {
                order.waiting = false;
                ask(order, collectors);
            }
        } else if (!calling) {
            calling = true;
            Order order = waiting.getFirst();
            orders.remove(order); // its turn is after the others' if nobody wants it
            orders.add(order);
            call(order, collectors);
        }
    }

    private List<String> collectors() {
        Instant now = self.scheduler().instant();
        return self.directory().offering(Collecting.CAPABILITY.name()).stream()
                .map(Directory.Entry::name)
                .filter(name -> !now.isBefore(silentUntil.getOrDefault(name, Instant.MIN)))
                .toList();
    }

    private void ask(Order order, List<String> collectors) {
        if (collectors.isEmpty()) {
            order.waiting = true;
            return;
        }
        String first = collectors.getFirst();
        requests.ask(first, order.goal, ending -> {
            if (ending instanceof Ending.Refused<Collected>) {
                ask(order, collectors.subList(1, collectors.size()));
            } else {
                ended(order, first, ending);
                allot();
            }
        });
    }

    private void call(Order order, List<String> collectors) {
        calls.call(collectors, order.goal, REPLY, new ContractNet.Manager<CollectGoal, Bid, Collected>() {
            @Override
            public Verdict<CollectGoal> decide(Round<Bid> round) {
                calling = false;
                Optional<Proposal<Bid>> best = round.proposals().stream()
                        .filter(proposal -> Double.isFinite(proposal.bid().cost()))
                        .min(Comparator.comparingDouble(
                                proposal -> proposal.bid().cost())); // of equals the first
                order.waiting = best.isEmpty();
                if (best.isPresent()) {
                    self.scheduler().execute(Hiring.this::allot); // others wait
                }
                return best.<Verdict<CollectGoal>>map(Verdict::award).orElseGet(Verdict::none);
            }

            @Override
            public void ended(Proposal<Bid> accepted, Ending<Collected> how) {
                Hiring.this.ended(order, accepted.from(), how);
                allot();
            }
        });
    }

    private void ended(Order order, String collector, Ending<Collected> how) {
        switch (how) {
            case Ending.Informed<Collected> _ -> orders.remove(order);
            case Ending.Silent<Collected> _ -> {
                silentUntil.put(collector, self.scheduler().instant().plus(AVOID));
                order.waiting = true;
            }
            case Ending.Refused<Collected> _, Ending.Cancelled<Collected> _ -> order.waiting = true;
            case Ending.Failed<Collected> _, Ending.NotUnderstood<Collected> _ -> {
                order.failures++;
                order.waiting = true;
                if (order.failures == TRIES) {
                    orders.remove(order); // if it is there after all, it will be found again
                }
            }
        }
    }
}
