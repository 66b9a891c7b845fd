package rsal.foxglove;

import java.util.ArrayList;
import java.util.List;
import rsal.recording.Backlog.Entry;

/// The newest events of a run, for clients that come later. They are numbered from 0. For one thread.
final class RecentEvents {
    /// That are kept.
    static final int MOST = 10_000;

    private final List<Entry> kept = new ArrayList<>();
    private long forgotten;

    void add(Entry event) {
        if (kept.size() == 2 * MOST) { // not one by one, which would move all of them each time
            kept.subList(0, MOST).clear();
            forgotten += MOST;
        }
        kept.add(event);
    }

    /// The number of the oldest that is told; that of the next to come, when there is none.
    long first() {
        return Math.max(forgotten, next() - MOST);
    }

    /// The number of the next to come.
    long next() {
        return forgotten + kept.size();
    }

    /// @param number from [#first] to before [#next]
    Entry event(long number) {
        return kept.get((int) (number - forgotten));
    }
}
