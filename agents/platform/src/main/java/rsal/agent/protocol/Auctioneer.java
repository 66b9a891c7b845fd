package rsal.agent.protocol;

import java.time.Duration;
import java.util.Collection;
import java.util.Objects;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import rsal.agent.protocol.Auction.Prices;
import rsal.agent.protocol.Auction.Sale;
import rsal.agent.protocol.Auction.Seller;
import rsal.time.Scheduler;
import rsal.time.Task;

/// The auctioneer's side of an auction: one lot, from the first price to the last.
final class Auctioneer implements Conversation {
    private static final RetryPolicy PATIENCE = RetryPolicy.DEFAULT;

    private final Scheduler scheduler;
    private final ConversationManager conversations;
    private final String id;
    private final boolean rising;
    private final Prices prices;
    private final Duration round;
    private final Seller seller;
    private final SortedMap<String, Dialogue> bidders = new TreeMap<>();
    private @Nullable Task roundEnd;
    private Optional<String> leader = Optional.empty();
    private int step;
    private boolean wanted; // at this price
    private boolean over;

    Auctioneer(
            Scheduler scheduler,
            ConversationManager conversations,
            boolean rising,
            Prices prices,
            Duration round,
            Seller seller) {
        this.scheduler = scheduler;
        this.conversations = conversations;
        this.id = conversations.newConversation();
        this.rising = rising;
        this.prices = prices;
        this.round = round;
        this.seller = seller;
    }

    void begin(Collection<String> to, Object lot) {
        for (String name : new TreeSet<>(to)) {
            Dialogue dialogue = conversations.begin(id, name, PATIENCE, new BidListener(name));
            bidders.put(name, dialogue);
            dialogue.say(Performative.INFORM, lot);
        }
        call();
    }

    private double price() {
        return prices.first() + step * prices.step();
    }

    private void call() {
        wanted = false;
        publishAll(Performative.CFP, price());
        roundEnd = scheduler.after(round, this::endRound);
    }

    private void endRound() {
        boolean found = wanted && !rising;
        boolean exhausted = !wanted && (rising || price() + prices.step() < prices.reserve());
        if (exhausted && bidders.values().stream().anyMatch(bidder -> !bidder.isOver() && !bidder.isHeard())) {
            roundEnd = scheduler.after(PATIENCE.repeat(), this::endRound); // some may not have heard this price
        } else if (found || exhausted) {
            end();
        } else {
            step++;
            call();
        }
    }

    private void end() {
        stop();
        double last = rising && leader.isPresent() ? price() - prices.step() : price();
        var sale = new Sale(leader.filter(_ -> last >= prices.reserve()), last);
        bidders.values().forEach(Dialogue::linger);
        publishAll(Performative.INFORM, sale);
        seller.ended(sale);
    }

    private void stop() {
        over = true;
        if (roundEnd != null) {
            roundEnd.cancel();
        }
    }

    private void publishAll(Performative performative, Object content) {
        bidders.values().stream()
                .filter(bidder -> !bidder.isOver())
                .forEach(bidder -> bidder.say(performative, content));
    }

    @Override
    public String id() {
        return id;
    }

    @Override
    public void cancel() {
        if (!over) {
            stop();
            publishAll(Performative.CANCEL, "");
        }
    }

    private final class BidListener implements Dialogue.Listener {
        private final String name;

        BidListener(String name) {
            this.name = name;
        }

        @Override
        public void heard(Act act) {
            switch (act.performative()) {
                case PROPOSE -> offered((Double) act.content());
                case NOT_UNDERSTOOD -> lost(ProtocolOutcome.words(act));
                default -> {} // the grammar lets nothing else through
            }
        }

        private void offered(double offered) {
            if (over || offered != price()) {
                return; // the next price, or the end, has answered it
            }
            Dialogue dialogue = Objects.requireNonNull(bidders.get(name));
            if (wanted) {
                dialogue.say(Performative.REJECT_PROPOSAL, offered);
                return;
            }
            wanted = true;
            leader = Optional.of(name);
            dialogue.say(Performative.ACCEPT_PROPOSAL, offered);
            if (!rising) {
                end();
            }
        }

        @Override
        public void lost(String why) {
            if (leader.filter(name::equals).isPresent()) {
                leader = Optional.empty(); // the next price finds another, or nobody
            }
        }
    }
}
