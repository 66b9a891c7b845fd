package rsal.bare;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Executor;

/// Contract nets as a Java programmer writes them who has no protocols: all that one hears is a task of its own. For
/// systems that have no contract net to compare ours with.
public final class BareContracts {
    private final Executor lane;
    private final List<Bidder> bidders;
    private final Runnable ended;
    private final List<Bidder> proposals = new ArrayList<>(); // the first one first

    private BareContracts(Executor lane, List<? extends Executor> bidders, Runnable ended) {
        this.lane = lane;
        this.bidders = bidders.stream().map(Bidder::new).toList();
        this.ended = ended;
    }

    /// @param manager runs what it is handed one after the other, later
    /// @param bidders each the same
    /// @see BareSystem.Platform#contract
    public static void begin(Executor manager, List<? extends Executor> bidders, Runnable ended) {
        var contracts = new BareContracts(manager, bidders, ended);
        manager.execute(contracts::call);
    }

    private void call() {
        proposals.clear();
        for (Bidder bidder : bidders) {
            bidder.lane.execute(() -> bidder.called(this));
        }
    }

    private void proposed(Bidder bidder) {
        proposals.add(bidder);
        if (proposals.size() == bidders.size()) {
            Bidder best = proposals.getFirst();
            best.lane.execute(() -> best.accepted(this));
            for (Bidder other : proposals.subList(1, proposals.size())) {
                other.lane.execute(other::refused);
            }
        }
    }

    private void informed() {
        ended.run();
        call();
    }

    private static final class Bidder {
        private final Executor lane;

        @SuppressWarnings("UnusedVariable") // to count is what it has to do with a refusal
        private int refusals;

        Bidder(Executor lane) {
            this.lane = lane;
        }

        void called(BareContracts manager) {
            manager.lane.execute(() -> manager.proposed(this));
        }

        void accepted(BareContracts manager) {
            manager.lane.execute(manager::informed);
        }

        void refused() {
            refusals++;
        }
    }
}
