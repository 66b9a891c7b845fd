package rsal.agent;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.NavigableSet;
import java.util.Optional;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;

/// Notes by topic and name that fade when their time is up. Reads never show a faded note; a note under the same
/// topic and name replaces the one before.
///
/// Writing, erasing and reading one note take time that grows with the logarithm of how many notes fade, not with how
/// many there are; reading a topic takes as long as it has notes.
public final class Blackboard {
    private static final Comparator<Entry> SOONEST =
            Comparator.comparing(Entry::fades).thenComparingLong(Entry::number);

    private final InstantSource clock;
    private final Map<Topic<?>, LinkedHashMap<String, Entry>> topics = new HashMap<>(); // oldest first
    private final NavigableSet<Entry> fading = new TreeSet<>(SOONEST);
    private long written;
    private int size;

    public Blackboard(InstantSource clock) {
        this.clock = clock;
    }

    /// Writes a note that stays for a time.
    public <M> void write(Topic<M> topic, String name, M content, Duration lifetime) {
        Instant now = clock.instant();
        boolean outlivesTime = lifetime.compareTo(Duration.between(now, Instant.MAX)) > 0;
        add(new Note<>(topic, name, content, now, outlivesTime ? Optional.empty() : Optional.of(now.plus(lifetime))));
    }

    /// Writes a note that stays until it is erased.
    public <M> void write(Topic<M> topic, String name, M content) {
        add(new Note<>(topic, name, content, clock.instant(), Optional.empty()));
    }

    private void add(Note<?> note) {
        fade(); // else a board that nobody reads would grow for ever
        erase(note.topic, note.name);
        var entry = new Entry(note, written++);
        topics.computeIfAbsent(note.topic, _ -> new LinkedHashMap<>()).put(note.name, entry);
        size++;
        if (note.fades.isPresent()) {
            fading.add(entry);
        }
    }

    public void erase(Topic<?> topic, String name) {
        LinkedHashMap<String, Entry> ofTopic = topics.get(topic);
        Entry entry = ofTopic == null ? null : ofTopic.remove(name);
        if (ofTopic == null || entry == null) {
            return;
        }
        size--;
        if (ofTopic.isEmpty()) {
            topics.remove(topic);
        }
        if (entry.note.fades.isPresent()) {
            fading.remove(entry);
        }
    }

    public <M> Optional<Note<M>> read(Topic<M> topic, String name) {
        fade();
        LinkedHashMap<String, Entry> ofTopic = topics.get(topic);
        @Nullable Entry entry = ofTopic == null ? null : ofTopic.get(name);
        return entry == null ? Optional.empty() : Optional.of(of(topic, entry));
    }

    /// All notes of a topic, oldest first.
    public <M> List<Note<M>> read(Topic<M> topic) {
        fade();
        var found = new ArrayList<Note<M>>();
        LinkedHashMap<String, Entry> ofTopic = topics.get(topic);
        if (ofTopic != null) {
            ofTopic.values().forEach(entry -> found.add(of(topic, entry)));
        }
        return found;
    }

    /// All notes, oldest first.
    public List<Note<?>> all() {
        fade();
        var all = new ArrayList<Entry>(size);
        topics.values().forEach(ofTopic -> all.addAll(ofTopic.values()));
        all.sort(Comparator.comparingLong(Entry::number));
        var notes = new ArrayList<Note<?>>(size);
        all.forEach(entry -> notes.add(entry.note));
        return notes;
    }

    /// How many notes there are.
    public int size() {
        fade();
        return size;
    }

    private void fade() {
        if (fading.isEmpty()) {
            return;
        }
        Instant now = clock.instant();
        while (!fading.isEmpty() && !now.isBefore(fading.getFirst().fades())) {
            Note<?> faded = fading.getFirst().note;
            erase(faded.topic, faded.name);
        }
    }

    @SuppressWarnings("unchecked") // written with this very topic
    private static <M> Note<M> of(@SuppressWarnings("unused") Topic<M> topic, Entry entry) {
        return (Note<M>) entry.note;
    }

    /// @param written when
    /// @param fades when it will be gone; empty when it stays
    public record Note<M>(Topic<M> topic, String name, M content, Instant written, Optional<Instant> fades) {}

    /// @param number counts what was ever written
    private record Entry(Note<?> note, long number) {
        Instant fades() {
            return note.fades.orElse(Instant.MAX);
        }
    }
}
