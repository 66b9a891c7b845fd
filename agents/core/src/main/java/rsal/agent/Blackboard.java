package rsal.agent;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/// Notes by topic and name that fade when their time is up. Reads never show a faded note; a note under the same
/// topic and name replaces the one before.
public final class Blackboard {
    private final InstantSource clock;
    private final List<Note<?>> notes = new ArrayList<>();

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
        notes.add(note);
    }

    public void erase(Topic<?> topic, String name) {
        notes.removeIf(note -> note.topic.equals(topic) && note.name.equals(name));
    }

    public <M> Optional<Note<M>> read(Topic<M> topic, String name) {
        return read(topic).stream().filter(note -> note.name.equals(name)).findFirst();
    }

    /// All notes of a topic, oldest first.
    public <M> List<Note<M>> read(Topic<M> topic) {
        fade();
        var found = new ArrayList<Note<M>>();
        for (Note<?> note : notes) {
            if (note.topic.equals(topic)) {
                @SuppressWarnings("unchecked") // written with this very topic
                var matching = (Note<M>) note;
                found.add(matching);
            }
        }
        return found;
    }

    /// All notes, oldest first.
    public List<Note<?>> all() {
        fade();
        return List.copyOf(notes);
    }

    private void fade() {
        Instant now = clock.instant();
        notes.removeIf(note -> note.fades.filter(at -> !now.isBefore(at)).isPresent());
    }

    /// @param written when
    /// @param fades when it will be gone; empty when it stays
    public record Note<M>(Topic<M> topic, String name, M content, Instant written, Optional<Instant> fades) {}
}
