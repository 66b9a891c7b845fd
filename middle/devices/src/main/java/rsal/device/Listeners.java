package rsal.device;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;

/// Those who want to be told something, told in the order in which they came. One that throws loses its place and
/// harms nobody else.
public final class Listeners<T> {
    private final List<Entry<T>> entries = new ArrayList<>();
    private final Consumer<? super RuntimeException> onFailure;
    private List<Entry<T>> reported = List.of();
    private boolean changed;

    /// @param onFailure told what a listener threw
    public Listeners(Consumer<? super RuntimeException> onFailure) {
        this.onFailure = onFailure;
    }

    public Subscription add(Consumer<? super T> listener) {
        var entry = new Entry<T>(listener);
        entries.add(entry);
        changed = true;
        return () -> {
            entry.cancelled = true;
            changed |= entries.remove(entry);
        };
    }

    /// Those who come while it tells are told from the next time on; those who go are told no more.
    public void publish(T value) {
        if (changed) {
            reported = List.copyOf(entries);
            changed = false;
        }
        List<Entry<T>> now = reported; // a listener may make us tell again
        for (int i = 0; i < now.size(); i++) {
            Entry<T> entry = now.get(i);
            if (entry.cancelled) {
                continue;
            }
            try {
                entry.listener.accept(value);
            } catch (RuntimeException e) {
                entry.cancelled = true;
                changed |= entries.remove(entry);
                onFailure.accept(e);
            }
        }
    }

    public boolean isEmpty() {
        return entries.isEmpty();
    }

    private static final class Entry<T> {
        private final Consumer<? super T> listener;
        private boolean cancelled;

        Entry(Consumer<? super T> listener) {
            this.listener = listener;
        }
    }
}
