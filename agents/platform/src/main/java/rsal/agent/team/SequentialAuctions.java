package rsal.agent.team;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// Sequential single-item auctions (SSI): in each round every member bids for the one open job that fits best into its
/// route, and the lowest of these bids wins. There is no auctioneer: every member hears all bids and finds the same
/// winner.
///
/// Source: M. G. Lagoudakis et al., "Auction-based multi-robot routing" (RSS 2005). Where paths obey the triangle
/// inequality, the sum of all routes is at most twice the least one with `minisum`, and the longest route at most
/// twice the number of members times the least one with `minimax`.
///
/// Departure: a bid is repeated until all have heard it, and a message holds all bids of its sender, so that a lost
/// message delays a round only. A member that refuses or is not heard is left out.
public final class SequentialAuctions implements AllocationType {
    static final Parameter<String> BID = Parameter.choice(
            "bid",
            BidRule.MINIMAX.word(),
            List.of(BidRule.MINIMAX.word(), BidRule.MINISUM.word()),
            "What a robot bids: the path cost of its whole route with the job, for a short longest route, or what the"
                    + " job adds to it, for a short sum of all routes.");

    @Override
    public String key() {
        return "ssi";
    }

    @Override
    public String description() {
        return "The robots hold one auction for each job, one after the other, without an auctioneer.";
    }

    @Override
    public List<Parameter<?>> parameters() {
        return List.of(BID);
    }

    @Override
    public boolean isAmongMembers() {
        return true;
    }

    @Override
    public Optional<Allocator> create(Arguments arguments, Auction auction) {
        return Optional.of(new Bidder(auction, BidRule.of(arguments.get(BID))));
    }

    private static final class Bidder implements Allocator {
        private final Auction auction;
        private final OwnRoute route;
        private final TreeSet<Integer> open = new TreeSet<>();
        private final TreeSet<String> present;
        private final List<Bid> own = new ArrayList<>(); // one for each round
        private final Map<String, List<Bid>> others = new TreeMap<>();
        private OwnRoute.@Nullable Insertion planned; // of the newest own bid
        private boolean over;

        Bidder(Auction auction, BidRule rule) {
            this.auction = auction;
            this.route = new OwnRoute(auction.estimate(), rule, 1);
            this.present = new TreeSet<>(auction.members());
            for (int job = 0; job < auction.jobs(); job++) {
                open.add(job);
            }
            bid();
            close();
        }

        /// For the job that fits best. Without one that it can do it says so, once and for all.
        private void bid() {
            OwnRoute.Insertion best = null;
            for (int job : open) {
                OwnRoute.Insertion insertion = route.best(job);
                if (best == null || insertion.bid() < best.bid()) {
                    best = insertion;
                }
            }
            planned = best;
            own.add(
                    best == null
                            ? new Bid(-1, auction.self(), Double.POSITIVE_INFINITY)
                            : new Bid(best.job(), auction.self(), best.bid()));
        }

        /// Finds the winners of all rounds of which all bids are known.
        private void close() {
            while (!over) {
                int round = own.size() - 1;
                Bid lowest = own.get(round);
                for (String member : present) {
                    if (member.equals(auction.self())) {
                        continue;
                    }
                    Bid bid = bidOf(member, round);
                    if (bid == null) {
                        return; // not heard yet
                    }
                    if (bid.beats(lowest)) {
                        lowest = bid;
                    }
                }
                if (lowest.cost() == Double.POSITIVE_INFINITY) {
                    over = true;
                    return;
                }
                open.remove(lowest.job());
                if (lowest.bidder().equals(auction.self()) && planned != null) {
                    route.insert(planned);
                }
                over = open.isEmpty();
                if (!over) {
                    bid();
                }
            }
        }

        /// One that can do nothing in a round can do nothing later.
        private @Nullable Bid bidOf(String member, int round) {
            List<Bid> bids = others.getOrDefault(member, List.of());
            if (round < bids.size()) {
                return bids.get(round);
            }
            boolean out = !bids.isEmpty() && bids.getLast().cost() == Double.POSITIVE_INFINITY;
            return out ? bids.getLast() : null;
        }

        @Override
        public Said said() {
            var known = new LinkedHashMap<String, Integer>();
            others.forEach((member, bids) -> known.put(member, bids.size()));
            return new Said(own.size(), own, known);
        }

        @Override
        public void hear(String from, Said said) {
            boolean sound =
                    said.bids().stream().allMatch(bid -> bid.bidder().equals(from) && bid.job() < auction.jobs());
            if (sound
                    && said.bids().size() > others.getOrDefault(from, List.of()).size()) {
                others.put(from, said.bids());
                close();
            }
        }

        @Override
        public void leave(String member) {
            if (!member.equals(auction.self()) && present.remove(member)) {
                close();
            }
        }

        @Override
        public List<Integer> route() {
            return route.jobs();
        }

        @Override
        public boolean isSettled() {
            return over;
        }
    }
}
