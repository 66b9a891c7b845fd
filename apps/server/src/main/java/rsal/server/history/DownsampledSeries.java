package rsal.server.history;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;

/// What was by when, oldest first, within a number of bytes: when it has more, what is nearer to the one before than
/// the spacing is let go; where that is none, only half as many are kept, from then on, too. So it reaches back to the
/// beginning, ever more coarsely. For one thread.
final class DownsampledSeries<T> {
    private final long most;
    private final Size<T> size;
    private List<Entry<T>> entries = new ArrayList<>();
    private Duration spacing;
    private long bytes;

    /// @param time since the run's start
    record Entry<T>(Duration time, T value) {}

    /// How many bytes a value takes beyond the one before it, of which it may share parts.
    @FunctionalInterface
    interface Size<T> {
        /// @param before null for none
        long beyond(@Nullable T before, T value);
    }

    /// @param most bytes that it keeps, but for the first and the newest
    /// @param spacing between two that are kept, at least, until there are too many
    DownsampledSeries(long most, Duration spacing, Size<T> size) {
        this.most = most;
        this.spacing = spacing;
        this.size = size;
    }

    /// Whether something of then would be kept.
    boolean isDue(Duration time) {
        return entries.isEmpty() || time.minus(entries.getLast().time()).compareTo(spacing) >= 0;
    }

    /// Whether something of just then is the newest that is kept.
    boolean endsAt(Duration time) {
        return !entries.isEmpty() && entries.getLast().time().equals(time);
    }

    /// Keeps it, in place of the newest when that is of the same time, also when it is not [due][#isDue]. It must
    /// not be older.
    ///
    /// @param value of which nothing changes
    void keep(Duration time, T value) {
        if (endsAt(time)) {
            Entry<T> replaced = entries.removeLast();
            bytes -= size.beyond(last(), replaced.value());
        }
        add(new Entry<>(time, value));
        while (bytes > most && entries.size() > 2) {
            int before = entries.size();
            thin();
            if (entries.size() == before) {
                spacing = spacing.multipliedBy(2);
            }
        }
    }

    private void add(Entry<T> entry) {
        bytes += size.beyond(last(), entry.value());
        entries.add(entry);
    }

    private @Nullable T last() {
        return entries.isEmpty() ? null : entries.getLast().value();
    }

    /// Lets go what is nearer than the spacing to the one before; not the first, so that it reaches back to there, and
    /// not the newest.
    private void thin() {
        List<Entry<T>> before = entries;
        entries = new ArrayList<>(before.size());
        bytes = 0;
        for (int i = 0; i < before.size(); i++) {
            if (isDue(before.get(i).time()) || i == before.size() - 1) {
                add(before.get(i));
            }
        }
    }

    /// All that are kept, as they are until the next is.
    List<Entry<T>> all() {
        return Collections.unmodifiableList(entries);
    }

    /// The newest by then; the first when all came later.
    Optional<Entry<T>> at(Duration time) {
        return entries.isEmpty() ? Optional.empty() : Optional.of(entries.get(newest(time)));
    }

    /// Index of the newest by then; of the first when there is none.
    int newest(Duration time) {
        int low = 0;
        int high = entries.size() - 1;
        while (low < high) {
            int middle = (low + high + 1) / 2;
            if (entries.get(middle).time().compareTo(time) <= 0) {
                low = middle;
            } else {
                high = middle - 1;
            }
        }
        return low;
    }

    /// What they were by then, each but where it is the same as before.
    <U> List<Entry<U>> until(Duration time, Function<T, Optional<U>> part) {
        var parts = new ArrayList<Entry<U>>();
        for (Entry<T> entry : entries) {
            if (entry.time().compareTo(time) > 0) {
                break;
            }
            Optional<U> one = part.apply(entry.value());
            if (one.isPresent() && (parts.isEmpty() || !parts.getLast().value().equals(one.get()))) {
                parts.add(new Entry<>(entry.time(), one.get()));
            }
        }
        return parts;
    }

    /// Of all together, about.
    long bytes() {
        return bytes;
    }
}
