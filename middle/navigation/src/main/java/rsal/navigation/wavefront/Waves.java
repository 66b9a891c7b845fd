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
/// next one, each to be mended when it is used. Safe for several threads.
final class Waves {
    private static final int MOST_KEPT = 16;
    private static final int CELLS_KEPT = 16_000_000; // of all waves together; 64 MB
    private static final int ASKED_SINCE = 3;
    private static final int GOALS_REMEMBERED = 256;

    private final CostMap map;
    private final @Nullable Changes last; // how the map came about
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

    /// A wave that is kept. Whoever looks at it or lets it spread holds its lock: that of the map before may still be
    /// asked by somebody.
    private static final class Lasting {
        private Wave wave;
        private int source = -1; // where it comes from, a cell of its map

        private Lasting(CostMap map) {
            this.wave = new Wave(map);
        }

        /// @param last how the map came about, if it has changed
        synchronized <R> R use(CostMap map, @Nullable Changes last, int goalCell, Function<Wave, R> use) {
            if (wave.map() != map) {
                Optional<Changes> changes = last != null && last.from() == wave.map()
                        ? Optional.of(last)
                        : Changes.between(wave.map(), map);
                moveTo(map, changes, goalCell);
            }
            if (source != goalCell) {
                wave.clear();
                wave.start(goalCell);
                source = goalCell;
            }
            return use.apply(wave);
        }

        private void moveTo(CostMap map, Optional<Changes> changes, int goalCell) {
            Optional<Wave> moved = changes.filter(some -> source >= 0 && some.moved(source) == goalCell)
                    .map(wave::over);
            source = moved.isPresent() ? goalCell : -1;
            wave = moved.orElseGet(() -> new Wave(map));
        }
    }

    Waves(CostMap map) {
        this(map, null);
    }

    private Waves(CostMap map, @Nullable Changes last) {
        this.map = map;
        this.last = last;
    }

    /// Does something with the wave of a goal that is kept; empty when it isn't yet.
    <R> Optional<R> from(int goalCell, Function<Wave, R> use) {
        return kept(goalCell).map(one -> one.use(map, last, goalCell, use));
    }

    /// Those over a map that has become another, which is open where they come from. What they were asked for counts
    /// on.
    synchronized Waves over(Changes changes) {
        var next = new Waves(changes.to(), changes);
        next.asked = asked;
        for (Kept one : kept) {
            int goal = changes.moved(one.goal);
            if (goal >= 0 && next.map.isOpen(goal)) {
                next.kept.add(new Kept(one.lasting, goal, one.asked));
            }
        }
        waiting.forEach((cell, times) -> {
            int goal = changes.moved(cell);
            if (goal >= 0) {
                next.waiting.put(goal, times.copy());
            }
        });
        kept.clear();
        return next;
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
        boolean full = kept.size() >= MOST_KEPT || (kept.size() + 1L) * map.ground().length > CELLS_KEPT;
        if (full && !kept.isEmpty()) {
            Optional<Kept> given = kept.stream()
                    .min(Comparator.comparingLong(one -> one.asked))
                    .filter(one -> times.isOftenSince(one.asked));
            given.ifPresent(one -> one.goal = goalCell);
            return given;
        }
        var made = new Kept(new Lasting(map), goalCell, asked);
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
