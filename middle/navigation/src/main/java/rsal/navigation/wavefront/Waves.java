package rsal.navigation.wavefront;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;

/// The waves of a map: one each for the goals that were asked for more than once, as far as it had to spread, and
/// some to lend. Goals asked for the first time, as of those who follow something that moves, are not worth a wave
/// that lasts. When there is no room for one more, a goal gets the wave of another that it was asked for
/// [#ASKED_SINCE] times since, so that no wave goes to and fro between many goals that are all in use (as LRU-K has
/// it: E. O'Neil, P. O'Neil, G. Weikum, SIGMOD 1993). Safe for several threads.
final class Waves {
    private static final int MOST_KEPT = 16;
    private static final int CELLS_KEPT = 16_000_000; // of all waves together; 64 MB
    private static final int ASKED_SINCE = 3;
    private static final int GOALS_REMEMBERED = 256;

    private final CostMap map;
    private final List<Kept> kept = new ArrayList<>();
    private final Map<Integer, Asked> waiting = new LinkedHashMap<>(); // goals without a wave, oldest first
    private final ArrayDeque<Wave> lent = new ArrayDeque<>();
    private long asked;

    /// When a goal was asked for: the last times, as many as count.
    private static final class Asked {
        private final ArrayDeque<Long> times = new ArrayDeque<>(ASKED_SINCE);

        void at(long time) {
            if (times.size() == ASKED_SINCE) {
                times.removeFirst();
            }
            times.addLast(time);
        }

        boolean isAgain() {
            return times.size() > 1;
        }

        boolean isOftenSince(long time) {
            return times.size() == ASKED_SINCE && times.getFirst() > time;
        }
    }

    /// A wave from a goal. Whoever looks at the wave or lets it spread holds its lock.
    static final class Kept {
        private final Wave wave;
        private int goal = -1; // whose it is; guarded by its Waves
        private int source = -1; // where the wave comes from; guarded by this
        private long asked; // guarded by its Waves

        private Kept(Wave wave) {
            this.wave = wave;
        }

        /// Lets the wave come from the goal, if it doesn't.
        private Wave from(int goalCell) {
            if (source != goalCell) {
                wave.clear();
                wave.start(goalCell);
                source = goalCell;
            }
            return wave;
        }
    }

    Waves(CostMap map) {
        this.map = map;
    }

    /// Does something with the wave of a goal that is kept; empty when it isn't yet.
    <R> Optional<R> from(int goalCell, Function<Wave, R> use) {
        Optional<Kept> found = kept(goalCell);
        return found.map(one -> {
            synchronized (one) {
                return use.apply(one.from(goalCell));
            }
        });
    }

    /// Does something with a wave that nobody else uses, is cleared and has not started.
    <R> R borrow(Function<Wave, R> use) {
        Wave wave = taken();
        try {
            return use.apply(wave);
        } finally {
            wave.clear();
            giveBack(wave);
        }
    }

    private synchronized Optional<Kept> kept(int goalCell) {
        asked++;
        Optional<Kept> wanted =
                kept.stream().filter(one -> one.goal == goalCell).findFirst().or(() -> another(goalCell));
        wanted.ifPresent(one -> one.asked = asked);
        return wanted;
    }

    /// A wave for a goal that has none, once it was asked for often enough.
    private Optional<Kept> another(int goalCell) {
        Asked times = waiting.computeIfAbsent(goalCell, _ -> new Asked());
        times.at(asked);
        if (waiting.size() > GOALS_REMEMBERED) {
            waiting.remove(waiting.keySet().iterator().next());
        }
        Optional<Kept> found = times.isAgain() ? room(times) : Optional.empty();
        found.ifPresent(one -> {
            one.goal = goalCell;
            waiting.remove(goalCell);
        });
        return found;
    }

    /// A new wave while there is room, else that which was not asked for the longest, if it may be had.
    private Optional<Kept> room(Asked times) {
        boolean full = kept.size() >= MOST_KEPT || (kept.size() + 1L) * map.ground().length > CELLS_KEPT;
        if (full && !kept.isEmpty()) {
            return kept.stream()
                    .min(Comparator.comparingLong(one -> one.asked))
                    .filter(one -> times.isOftenSince(one.asked));
        }
        var made = new Kept(new Wave(map));
        kept.add(made);
        return Optional.of(made);
    }

    private synchronized Wave taken() {
        return lent.isEmpty() ? new Wave(map) : lent.pop();
    }

    private synchronized void giveBack(Wave wave) {
        lent.push(wave);
    }
}
