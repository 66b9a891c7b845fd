package rsal.agent.team;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import rsal.agent.AgentContext;
import rsal.agent.team.Allocator.Said;
import rsal.time.Task;

/// A member's part in auctions: carries the bids of its [Allocator]. Bids are said when they change and repeated until
/// all agree, so that lost messages do no more than delay. Members of which nothing is heard are left out; who has not
/// agreed in time goes by what it knows, and the agent with the jobs gives each only once. On the agent's lane.
final class AuctionRoom {
    /// How long the agent with the jobs waits for the results.
    static final Duration TIME = Duration.ofSeconds(5);

    private static final Duration LISTEN = Duration.ofMillis(1500); // to one of which nothing is heard
    private static final Duration REPEAT = Duration.ofMillis(250);
    private static final Duration MARGIN = Duration.ofSeconds(1); // for the results to arrive

    private final AgentContext self;
    private final Map<String, Auction> auctions = new TreeMap<>(); // the newest of each team
    private final Map<String, Map<String, AuctionBids>> heard = new TreeMap<>(); // the newest, by team and sender

    AuctionRoom(AgentContext self) {
        this.self = self;
    }

    void begin() {
        self.subscribe(AuctionBids.TOPIC, message -> hear(message.sender(), message.content()));
    }

    /// Takes part.
    ///
    /// @param replyBy when the result must be there
    /// @param onResult told once: the costs of the next job alone, or empty when this member has won nothing
    void enter(AuctionTerms terms, Estimate estimate, Instant replyBy, Consumer<Optional<Estimate>> onResult) {
        Estimate own = terms.allowed(self.name(), estimate);
        Optional<Allocator> allocator = terms.allocation()
                .as(AllocationType.class)
                .create(terms.allocation().arguments(), new AllocationType.Auction(self.name(), terms.members(), own));
        Auction auction = new Auction(terms, allocator.orElse(null), own, onResult);
        replace(auction);
        auction.begin(replyBy);
    }

    /// Lets the others know that it takes no part.
    void decline(AuctionTerms terms) {
        Auction auction = new Auction(terms, null, new Estimate(false, List.of(), List.of()), _ -> {});
        replace(auction);
        auction.say();
    }

    private void replace(Auction auction) {
        Auction old = auctions.put(auction.terms.team(), auction);
        if (old != null) {
            old.end();
        }
    }

    private void hear(String sender, AuctionBids bids) {
        heard.computeIfAbsent(bids.team(), _ -> new TreeMap<>()).put(sender, bids);
        Auction auction = auctions.get(bids.team());
        if (auction != null && auction.terms.number() == bids.auction()) {
            auction.hear(sender, bids);
        }
    }

    private final class Auction {
        private final AuctionTerms terms;
        private final @Nullable Allocator allocator; // null while it takes no part
        private final Estimate estimate;
        private final Consumer<Optional<Estimate>> onResult;
        private final TreeMap<String, Boolean> sounds = new TreeMap<>(); // of whom it has heard
        private @Nullable Task beat;
        private @Nullable Task listening;
        private @Nullable Task closing;
        private int saidVersion;
        private boolean due;
        private boolean over;

        Auction(
                AuctionTerms terms,
                @Nullable Allocator allocator,
                Estimate estimate,
                Consumer<Optional<Estimate>> onResult) {
            this.terms = terms;
            this.allocator = allocator;
            this.estimate = estimate;
            this.onResult = onResult;
        }

        void begin(Instant replyBy) {
            Instant now = self.scheduler().instant();
            beat = self.scheduler().every(REPEAT, this::beat);
            listening = self.scheduler().after(LISTEN, this::leaveOutSilent);
            Duration left = Duration.between(now, replyBy.minus(MARGIN));
            closing = self.scheduler().after(left.isNegative() ? Duration.ZERO : left, this::close);
            heard.getOrDefault(terms.team(), Map.of()).forEach((sender, bids) -> {
                if (bids.auction() == terms.number()) {
                    take(sender, bids);
                }
            });
            sayIfNew();
            look();
        }

        void hear(String sender, AuctionBids bids) {
            if (!terms.members().contains(sender)) {
                return;
            }
            take(sender, bids);
            sayIfNew();
            if (bids.takesPart() && bids.said().knownOf(self.name()) < Math.max(1, saidVersion)) {
                saySoon(); // it has missed something
            }
            look();
        }

        private void take(String sender, AuctionBids bids) {
            sounds.put(sender, true);
            if (allocator != null) {
                if (bids.takesPart()) {
                    allocator.hear(sender, bids.said());
                } else {
                    allocator.leave(sender);
                }
            }
        }

        private void beat() {
            if (!over) {
                say();
            }
        }

        private void sayIfNew() {
            if (allocator != null && allocator.said().version() != saidVersion) {
                saySoon();
            }
        }

        /// After what is running now, once.
        private void saySoon() {
            if (!due) {
                due = true;
                self.scheduler().execute(() -> {
                    due = false;
                    if (auctions.get(terms.team()) == this) {
                        say();
                    }
                });
            }
        }

        void say() {
            if (terms.members().size() < 2) {
                return;
            }
            Said said = allocator == null ? new Said(1, List.of(), Map.of()) : allocator.said();
            saidVersion = said.version();
            self.publish(AuctionBids.TOPIC, new AuctionBids(terms.team(), terms.number(), allocator != null, said));
        }

        private void leaveOutSilent() {
            if (allocator != null) {
                terms.members().stream()
                        .filter(member -> !member.equals(self.name()) && !sounds.containsKey(member))
                        .forEach(allocator::leave);
                sayIfNew();
                look();
            }
        }

        private void look() {
            if (allocator == null || allocator.isSettled()) {
                close();
            }
        }

        private void close() {
            if (over) {
                return;
            }
            stop();
            List<Integer> route = allocator == null ? List.of() : allocator.route();
            onResult.accept(route.isEmpty() ? Optional.empty() : Optional.of(nextOf(route)));
        }

        private Estimate nextOf(List<Integer> route) {
            int next = JobRoutes.next(estimate, route);
            var first = new ArrayList<Double>();
            for (int job = 0; job < estimate.first().size(); job++) {
                first.add(job == next ? estimate.first().get(job) : Double.POSITIVE_INFINITY);
            }
            return new Estimate(estimate.free(), first, List.of());
        }

        private void stop() {
            over = true;
            for (Task task : new Task[] {beat, listening, closing}) {
                if (task != null) {
                    task.cancel();
                }
            }
        }

        /// Another auction of its team has begun.
        void end() {
            stop();
        }
    }
}
