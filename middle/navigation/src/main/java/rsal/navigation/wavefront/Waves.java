package rsal.navigation.wavefront;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;

/// The waves of a map: one each for the goals that were asked for more than once, as far as it had to spread, and
/// some to lend. Goals asked for the first time, as of those who follow something that moves, are not worth a wave
/// that lasts. When there is no room for one more, a goal gets the wave of another that it was asked for
/// [#ASKED_SINCE] times since, so that no wave goes to and fro between many goals that are all in use (as LRU-K has
/// it: E. O'Neil, P. O'Neil, G. Weikum, SIGMOD 1993). When the map changes a little they are handed on to those of the
/// next one, each to be mended when it is used; those that nobody asked for on the last two maps are not. Safe for
/// several threads.
final class Waves {
    private static final int MOST_KEPT = 16;
    private static final int CELLS_KEPT = 16_000_000; // of all waves together; 64 MB
    private static final int ASKED_SINCE = 3;
    private static final int GOALS_REMEMBERED = 256;

    private final CostMap map;
    private final @Nullable CostChanges last; // how the map came about
    private final List<Kept> kept = new ArrayList<>();
    private final Map<Integer, Asked> waiting = new LinkedHashMap<>(); // goals without a wave, oldest first
    private final ArrayDeque<Wave> lent = new ArrayDeque<>();
    private final long askedAtFirst; // what was asked by then when this map came
    private final long askedBefore; // the same of the map before
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

        Asked copy() {
            var copy = new Asked();
            copy.times.addAll(times);
            return copy;
        }

        boolean isAgain() {
            return times.size() > 1;
        }

        boolean isOftenSince(long time) {
            return times.size() == ASKED_SINCE && times.getFirst() > time;
        }
    }

    /// The wave of a goal.
    private static final class Kept {
        private final Lasting lasting;
        private int goal;
        private long asked;

        private Kept(Lasting lasting, int goal, long asked) {
            this.lasting = lasting;
            this.goal = goal;
            this.asked = asked;
        }
    }

    /// A wave that is kept. Those that look at it or let it spread hold its lock: that of the map before may still be
    /// asked by somebody.
    private static final class Lasting {
        private @Nullable Wave wave; // none while it is mended, so that none is left half mended
        private int source; // where it comes from, a cell of its map; −1 while it has not started

        /// @param last how the map came about, if it has changed
        synchronized <R> R use(CostMap map, @Nullable CostChanges last, int goalCell, Function<Wave, R> use) {
            Wave now = over(map, last, goalCell);
            if (source != goalCell) {
                now.clear();
                now.start(goalCell);
                source = goalCell;
            }
            return use.apply(now);
        }

        private Wave over(CostMap map, @Nullable CostChanges last, int goalCell) {
            Wave old = wave;
            if (old != null && old.map() == map) {
                return old;
            }
            wave = null;
            Optional<Wave> mended = old == null || source < 0 ? Optional.empty() : mended(old, map, last, goalCell);
            source = mended.isPresent() ? goalCell : -1;
            Wave now = mended.orElseGet(() -> new Wave(map));
            wave = now;
            return now;
        }

        private Optional<Wave> mended(Wave old, CostMap map, @Nullable CostChanges last, int goalCell) {
            Optional<CostChanges> changes =
                    last != null && last.from() == old.map() ? Optional.of(last) : CostChanges.between(old.map(), map);
            return changes.filter(some -> some.overlay().moved(source) == goalCell)
                    .flatMap(old::over);
        }
    }

    Waves(CostMap map) {
        this(map, null, 0, 0);
    }

    private Waves(CostMap map, @Nullable CostChanges last, long asked, long askedBefore) {
        this.map = map;
        this.last = last;
        this.asked = asked;
        this.askedAtFirst = asked;
        this.askedBefore = askedBefore;
    }

    /// Those over another map, to which the waves are handed on if it is much the same. What goals were asked for
    /// counts on.
    synchronized Waves over(CostMap other) {
        Optional<CostChanges> few =
                kept.isEmpty() && waiting.isEmpty() ? Optional.empty() : CostChanges.between(map, other);
        Waves next = new Waves(other, few.orElse(null), asked, askedAtFirst);
        few.ifPresent(changes -> handOn(changes, next));
        return next;
    }

    private void handOn(CostChanges changes, Waves next) {
        kept.sort(Comparator.comparingLong((Kept one) -> one.asked).reversed());
        for (Kept one : kept) {
            int goal = changes.overlay().moved(one.goal);
            if (one.asked > askedBefore && next.hasRoom() && goal >= 0 && next.map.isOpen(goal)) {
                next.kept.add(new Kept(one.lasting, goal, one.asked));
            }
        }
        kept.clear();
        waiting.forEach((cell, times) -> {
            int goal = changes.overlay().moved(cell);
            if (goal >= 0) {
                next.waiting.put(goal, times.copy());
            }
        });
    }

    synchronized int kept() {
        return kept.size();
    }

    /// Does something with the wave of a goal that is kept; empty when it isn't yet.
    <R> Optional<R> from(int goalCell, Function<Wave, R> use) {
        return kept(goalCell).map(one -> one.use(map, last, goalCell, use));
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

    private synchronized Optional<Lasting> kept(int goalCell) {
        asked++;
        Optional<Kept> wanted =
                kept.stream().filter(one -> one.goal == goalCell).findFirst().or(() -> another(goalCell));
        wanted.ifPresent(one -> one.asked = asked);
        return wanted.map(one -> one.lasting);
    }

    /// A wave for a goal that has none, once it was asked for often enough.
    private Optional<Kept> another(int goalCell) {
        Asked times = waiting.computeIfAbsent(goalCell, _ -> new Asked());
        times.at(asked);
        if (waiting.size() > GOALS_REMEMBERED) {
            waiting.remove(waiting.keySet().iterator().next());
        }
        Optional<Kept> found = times.isAgain() ? room(goalCell, times) : Optional.empty();
        found.ifPresent(_ -> waiting.remove(goalCell));
        return found;
    }

    /// A new wave while there is room, else that which was not asked for the longest, if it may be had.
    private Optional<Kept> room(int goalCell, Asked times) {
        if (!hasRoom() && !kept.isEmpty()) {
            Optional<Kept> given = kept.stream()
                    .min(Comparator.comparingLong(one -> one.asked))
                    .filter(one -> times.isOftenSince(one.asked));
            given.ifPresent(one -> one.goal = goalCell);
            return given;
        }
        var made = new Kept(new Lasting(), goalCell, asked);
        kept.add(made);
        return Optional.of(made);
    }

    private boolean hasRoom() {
        return kept.size() < MOST_KEPT && (kept.size() + 1L) * map.ground().length <= CELLS_KEPT;
    }

    private synchronized Wave taken() {
        return lent.isEmpty() ? new Wave(map) : lent.pop();
    }

    private synchronized void giveBack(Wave wave) {
        lent.push(wave);
    }
}
