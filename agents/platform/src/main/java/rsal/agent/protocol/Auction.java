package rsal.agent.protocol;

import java.time.Duration;
import java.util.Collection;
import java.util.Objects;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import rsal.agent.AgentContext;

/// Sells something to the one who pays most, in rounds at prices that the auctioneer calls. In an English auction the
/// price rises until nobody wants it any more, and the last who did pays the price before (FIPA XC00031F). In a Dutch
/// one it falls until somebody does (FIPA XC00032F). Who does not want a price says nothing; so each round takes its
/// time, and the last is longer, until all are known to have heard the price. When several want a price, the first who
/// is heard counts.
///
/// What is sold may as well be a task, and prices be what its doing is worth: minus its cost.
///
/// FIPA lets the auctioneer ask the winner for the payment at the end. Here all are told who has won, and what follows
/// is a conversation of its own. Nor is an offer rejected that comes when its price stands no more: the next price, or
/// the end, has answered it.
///
/// @param <L> lot
public final class Auction<L> {
    private final AgentContext self;
    private final ConversationManager conversations;
    private final Class<L> lot;
    private final boolean rising;

    public static <L> Auction<L> english(AgentContext self, String name, Class<L> lot) {
        return new Auction<>(self, name, ProtocolStateMachine.ENGLISH_AUCTION, lot, true);
    }

    public static <L> Auction<L> dutch(AgentContext self, String name, Class<L> lot) {
        return new Auction<>(self, name, ProtocolStateMachine.DUTCH_AUCTION, lot, false);
    }

    private Auction(AgentContext self, String name, ProtocolStateMachine grammar, Class<L> lot, boolean rising) {
        this.self = self;
        this.lot = lot;
        this.rising = rising;
        this.conversations = new ConversationManager(self, name, grammar, lot, Double.class, Sale.class);
    }

    /// Sells something.
    ///
    /// @param to names of those who may bid
    /// @param round how long each price stands
    /// @throws IllegalArgumentException when prices rise in a Dutch auction or fall in an English one
    public Conversation sell(Collection<String> to, L what, Prices prices, Duration round, Seller seller) {
        if (rising != prices.step > 0) {
            throw new IllegalArgumentException("Prices of %s auction must %s, not change by '%s'."
                    .formatted(rising ? "an English" : "a Dutch", rising ? "rise" : "fall", prices.step));
        }
        var selling = new Auctioneer(self.scheduler(), conversations, rising, prices, round, seller);
        selling.begin(to, what);
        return selling;
    }

    /// From now on bids for what others sell.
    ///
    /// @throws IllegalStateException when this was called before
    public void answer(Bidder<L> bidder) {
        conversations.open(dialogue -> new Bids(dialogue, bidder));
    }

    /// @param first price called
    /// @param step from one price to the next; more than 0 in English auctions, less in Dutch ones
    /// @param reserve it is not sold for less
    public record Prices(double first, double step, double reserve) {
        public Prices {
            if (!Double.isFinite(first) || !Double.isFinite(step) || !Double.isFinite(reserve) || step == 0) {
                throw new IllegalArgumentException(
                        "Prices must be finite and change, not '%s', '%s', '%s'.".formatted(first, step, reserve));
            }
        }
    }

    /// The result.
    ///
    /// @param winner name; empty when nobody paid enough
    /// @param price the last that somebody wanted, or that was called when nobody did
    public record Sale(Optional<String> winner, double price) {}

    /// Told once, on the agent's lane; never when it was cancelled.
    @FunctionalInterface
    public interface Seller {
        void ended(Sale sale);
    }

    /// Called on the agent's lane.
    public interface Bidder<L> {
        /// Whether it would have it at this price.
        boolean pays(L lot, double price);

        /// The same, for bidders that need time: as long as the price stands, it may say that it would.
        ///
        /// @param pays to be run if it would; does nothing once another price was called, or it is over
        default void asked(L lot, double price, Runnable pays) {
            if (pays(lot, price)) {
                pays.run();
            }
        }

        /// It is over; this agent may be the winner.
        default void ended(L lot, Sale sale) {}

        /// The auctioneer has gone or cancelled, or one of the two does not understand the other.
        default void lost(L lot, String why) {}
    }

    private final class Bids extends Answering {
        private final Bidder<L> bidder;
        private @Nullable L what;
        private @Nullable Double called; // the price that stands

        Bids(Dialogue dialogue, Bidder<L> bidder) {
            super(dialogue);
            this.bidder = bidder;
        }

        @Override
        public void heard(Act act) {
            switch (act.performative()) {
                case CFP -> {
                    Double price = (Double) act.content();
                    called = price;
                    bidder.asked(lot(), price, () -> offer(price));
                }
                case INFORM -> {
                    if (act.content() instanceof Sale sale) {
                        called = null;
                        bidder.ended(lot(), sale);
                    } else {
                        what = lot.cast(act.content());
                    }
                }
                case NOT_UNDERSTOOD -> lost(ProtocolOutcome.words(act));
                default -> {} // whether its price was the first is told by the next
            }
        }

        private void offer(Double price) {
            if (price.equals(called)) {
                say(Performative.PROPOSE, price);
            }
        }

        @Override
        public void lost(String why) {
            called = null;
            if (what != null) {
                bidder.lost(what, why);
            }
            super.lost(why);
        }

        private L lot() {
            return Objects.requireNonNull(what); // it is announced first
        }
    }
}
