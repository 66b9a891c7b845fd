package rsal.agent.team;

import java.util.List;
import java.util.Map;

/// One member's part in an auction. It hears what the others say, in any order and with gaps, and says what they
/// should know. Without time and randomness: the same messages give the same result. Called on its agent's lane.
public interface Allocator {
    /// What the others should know now.
    Said said();

    /// What another said. Old news and repetitions do nothing.
    ///
    /// @param from one of the other members
    void hear(String from, Said said);

    /// A member takes no part: it refuses, or nobody hears of it.
    void leave(String member);

    /// What this member has won so far: numbers of jobs, in the order in which it would do them.
    List<Integer> route();

    /// Whether nothing will change, as far as this member can know.
    boolean isSettled();

    /// What a member says.
    ///
    /// @param version grows with every change of the sender's bids, from 1
    /// @param bids by the rules of the allocation
    /// @param known the version of each other member of which the sender knows, by name
    record Said(int version, List<Bid> bids, Map<String, Integer> known) {
        public Said {
            bids = List.copyOf(bids);
            known = Map.copyOf(known);
        }

        int knownOf(String member) {
            return known.getOrDefault(member, 0);
        }
    }

    /// A bid for a job.
    ///
    /// @param job its number in the auction
    /// @param bidder name of a member; empty for nobody
    /// @param cost the lower, the better; +∞ for what nobody can do
    record Bid(int job, String bidder, double cost) {
        public static final String NOBODY = "";

        public Bid {
            if (Double.isNaN(cost)) {
                throw new IllegalArgumentException("A bid for job %d needs a cost, not 'NaN'.".formatted(job));
            }
        }

        /// Whether this one wins. Of equal costs the first name of the alphabet wins.
        boolean beats(Bid other) {
            if (bidder.equals(NOBODY) || cost == Double.POSITIVE_INFINITY) {
                return false;
            }
            return other.bidder.equals(NOBODY)
                    || cost < other.cost
                    || (cost == other.cost && bidder.compareTo(other.bidder) < 0);
        }
    }
}
