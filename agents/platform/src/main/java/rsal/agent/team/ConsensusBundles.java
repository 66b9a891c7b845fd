package rsal.agent.team;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.TreeSet;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// The consensus-based bundle algorithm (CBBA): each member adds jobs to its bundle as long as it beats the best bid of
/// which it knows. Members exchange the best bids, and who made them. One that is outbid drops the job and all that
/// it added later.
///
/// Source: H.-L. Choi, L. Brunet and J. P. How, "Consensus-based decentralized auctions for robust task allocation"
/// (IEEE Transactions on Robotics 25, 2009): bundles by insertion, Table 1 for conflicts, time-discounted reward. Where
/// bids get worse as the bundle grows, the value is at least half of the best one.
///
/// Departures: versions of a member's bids stand for times, so that no clock is needed. A bid is never lower than
/// those before it in the bundle, which makes members agree for any bid rule (L. Johnson et al., "Allowing
/// non-submodular score functions in distributed task allocation", CDC 2012).
public final class ConsensusBundles implements AllocationType {
    static final Parameter<String> BID = Parameter.choice(
            "bid",
            BidRule.MINIMAX.word(),
            List.of(BidRule.MINIMAX.word(), BidRule.MINISUM.word(), BidRule.DISCOUNTED.word()),
            "What a robot bids: the path cost of its whole route with the job, what the job adds to it, or the value"
                    + " of the job, which falls until it is done.");
    static final Parameter<Double> DISCOUNT = Parameter.number(
            "discount", 0.97, 0.5, 1, "", "With discounted bids: what is left of the value of a job after a meter.");

    @Override
    public String key() {
        return "cbba";
    }

    @Override
    public String description() {
        return "The robots take bundles of jobs, and settle conflicts by consensus with their neighbors.";
    }

    @Override
    public List<Parameter<?>> parameters() {
        return List.of(BID, DISCOUNT);
    }

    @Override
    public boolean isAmongMembers() {
        return true;
    }

    @Override
    public Optional<Allocator> create(Arguments arguments, Auction auction) {
        return Optional.of(new Bundle(auction, BidRule.of(arguments.get(BID)), arguments.get(DISCOUNT)));
    }

    private static final class Bundle implements Allocator {
        private final Auction auction;
        private final String self;
        private final OwnRoute route;
        private final List<Integer> bundle = new ArrayList<>(); // in the order in which jobs were added
        private final List<Bid> best = new ArrayList<>(); // of each job, as far as it knows
        private final Map<String, Said> newest = new TreeMap<>(); // heard from the member itself
        private final Map<String, Integer> known = new TreeMap<>(); // versions, also by hearsay
        private final TreeSet<String> present;
        private final TreeSet<String> distant = new TreeSet<>(); // known by hearsay alone
        private int version;

        Bundle(Auction auction, BidRule rule, double discount) {
            this.auction = auction;
            this.self = auction.self();
            this.route = new OwnRoute(auction.estimate(), rule, discount);
            this.present = new TreeSet<>(auction.members());
            for (int job = 0; job < auction.jobs(); job++) {
                best.add(nobody(job));
            }
            build();
            version = 1;
        }

        private static Bid nobody(int job) {
            return new Bid(job, Bid.NOBODY, Double.POSITIVE_INFINITY);
        }

        /// Adds jobs whose best bids it can beat, first the one that it does best.
        private void build() {
            while (true) {
                OwnRoute.Insertion added = null;
                double floor = bundle.isEmpty()
                        ? Double.NEGATIVE_INFINITY
                        : best.get(bundle.getLast()).cost();
                for (int job = 0; job < auction.jobs(); job++) {
                    if (!bundle.contains(job)) {
                        OwnRoute.Insertion insertion = route.best(job);
                        boolean wins = bid(insertion, floor).beats(best.get(job));
                        if (wins && (added == null || insertion.bid() < added.bid())) {
                            added = insertion;
                        }
                    }
                }
                if (added == null) {
                    return;
                }
                best.set(added.job(), bid(added, floor));
                bundle.add(added.job());
                route.insert(added);
            }
        }

        private Bid bid(OwnRoute.Insertion insertion, double floor) {
            return new Bid(insertion.job(), self, Math.max(floor, insertion.bid()));
        }

        @Override
        public void hear(String from, Said said) {
            boolean old = said.version() < known.getOrDefault(from, 0);
            if (from.equals(self) || old || said.bids().size() != auction.jobs()) {
                return;
            }
            List<Bid> before = List.copyOf(best);
            for (int job = 0; job < auction.jobs(); job++) {
                best.set(job, resolved(best.get(job), ofPresent(said.bids().get(job)), from, said));
            }
            newest.put(from, said);
            note(from, said);
            release();
            build();
            if (!best.equals(before)) {
                version++;
            }
        }

        private Bid ofPresent(Bid bid) {
            return present.contains(bid.bidder()) ? bid : nobody(bid.job());
        }

        private void note(String from, Said said) {
            known.merge(from, said.version(), Math::max);
            said.known().forEach((member, seen) -> {
                if (!member.equals(self)) {
                    known.merge(member, seen, Math::max);
                }
            });
        }

        /// Table 1 of the paper: updates, resets or leaves what this member believes of a job.
        private Bid resolved(Bid mine, Bid theirs, String from, Said said) {
            String they = theirs.bidder();
            String we = mine.bidder();
            Bid reset = nobody(mine.job());
            if (they.equals(from)) {
                boolean update = we.equals(self)
                        ? theirs.beats(mine)
                        : we.equals(from) || we.equals(Bid.NOBODY) || isNewer(we, said) || theirs.beats(mine);
                return update ? theirs : mine;
            }
            if (they.equals(self)) {
                boolean wrong = we.equals(from) || (!we.equals(self) && !we.equals(Bid.NOBODY) && isNewer(we, said));
                return wrong ? reset : mine;
            }
            if (they.equals(Bid.NOBODY)) {
                boolean update = !we.equals(self) && (we.equals(from) || isNewer(we, said));
                return update ? theirs : mine;
            }
            boolean newer = isNewer(they, said);
            if (we.equals(self)) {
                return newer && theirs.beats(mine) ? theirs : mine;
            }
            if (we.equals(from)) {
                return newer ? theirs : reset;
            }
            if (we.equals(they) || we.equals(Bid.NOBODY)) {
                return newer ? theirs : mine;
            }
            boolean newerOfOurs = isNewer(we, said);
            if (newer && (newerOfOurs || theirs.beats(mine))) {
                return theirs;
            }
            return newerOfOurs && isOlder(they, said) ? reset : mine;
        }

        /// Whether the sender knows more of a member than this one does.
        private boolean isNewer(String member, Said said) {
            return !member.equals(self) && said.knownOf(member) > known.getOrDefault(member, 0);
        }

        private boolean isOlder(String member, Said said) {
            return said.knownOf(member) < known.getOrDefault(member, 0);
        }

        /// Drops the first job that it has lost, and all that it added later: their bids counted on it.
        private void release() {
            int lost = 0;
            while (lost < bundle.size() && best.get(bundle.get(lost)).bidder().equals(self)) {
                lost++;
            }
            for (Integer job : List.copyOf(bundle.subList(lost, bundle.size()))) {
                if (best.get(job).bidder().equals(self)) {
                    best.set(job, nobody(job));
                }
                bundle.remove(/* element */ job);
                route.remove(job);
            }
        }

        @Override
        public void leave(String member) {
            if (known.getOrDefault(member, 0) > 0) {
                distant.add(member);
                return;
            }
            if (member.equals(self) || !present.remove(member)) {
                return;
            }
            List<Bid> before = List.copyOf(best);
            best.replaceAll(bid -> bid.bidder().equals(member) ? nobody(bid.job()) : bid);
            build();
            if (!best.equals(before)) {
                version++;
            }
        }

        @Override
        public Said said() {
            return new Said(version, best, known);
        }

        @Override
        public List<Integer> route() {
            return route.jobs();
        }

        /// All that it hears say the same, or have left.
        @Override
        public boolean isSettled() {
            return present.stream()
                    .allMatch(member -> member.equals(self)
                            || (distant.contains(member) && !newest.containsKey(member))
                            || (newest.containsKey(member)
                                    && newest.get(member).bids().equals(best)));
        }
    }
}
