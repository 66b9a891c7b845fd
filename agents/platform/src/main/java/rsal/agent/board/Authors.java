package rsal.agent.board;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import rsal.agent.Blackboard;
import rsal.agent.Topic;

/// All notes of a board, by author: each has a blackboard of its own with bounded room.
final class Authors {
    private final InstantSource clock;
    private final int mostAuthors;
    private final int mostNotes; // of each
    private final Map<String, Author> authors = new LinkedHashMap<>();

    Authors(InstantSource clock, int mostAuthors, int mostNotes) {
        this.clock = clock;
        this.mostAuthors = mostAuthors;
        this.mostNotes = mostNotes;
    }

    /// Why a note is not taken; empty when it was.
    Optional<String> put(Note<?> note) {
        Instant now = clock.instant();
        if (note.written().isAfter(now)) {
            return Optional.of("It was written after now, which is '%s'.".formatted(now));
        }
        Author author = authors.get(note.author());
        if (author == null) {
            return Optional.of("No agent has this name.");
        }
        if (note.hasFaded(now)) {
            author.erase(note.key().name());
            return Optional.empty();
        }
        if (author.board.size() >= mostNotes && author.read(note.key().name()).isEmpty()) {
            return Optional.of("'%s' has %d notes here already, which is the maximum for one agent."
                    .formatted(note.author(), mostNotes));
        }
        author.board.write(stored(note.topic().name()), note.name(), note, Duration.between(now, note.fades()));
        return Optional.empty();
    }

    void erase(Note.Key key) {
        Author author = authors.get(key.author());
        if (author != null) {
            author.erase(key.name());
        }
    }

    Optional<Note<?>> read(Note.Key key) {
        return Optional.ofNullable(authors.get(key.author())).flatMap(author -> author.read(key.name()));
    }

    <M> List<Note<M>> find(Query<M> query) {
        return query.among(query.author()
                .map(name -> Stream.ofNullable(authors.get(name)))
                .orElseGet(() -> authors.values().stream())
                .flatMap(author -> author.notes(query.topic().name())));
    }

    /// Whether what an author says comes in time; from now on only what it says after that does.
    ///
    /// @throws IllegalStateException when there is no room for another author
    boolean isNew(String author, BoardService.Writing said) {
        Author known = authors.get(author);
        if (known == null) {
            makeRoom();
            known = new Author(new Blackboard(clock));
            authors.put(author, known);
        }
        return known.hears(said);
    }

    private void makeRoom() {
        if (authors.size() >= mostAuthors) {
            authors.values().removeIf(author -> author.board.size() == 0);
        }
        if (authors.size() >= mostAuthors) {
            throw new IllegalStateException(
                    "%d agents have notes here, which is the maximum.".formatted(authors.size()));
        }
    }

    /// How many notes there are.
    int size() {
        return authors.values().stream().mapToInt(author -> author.board.size()).sum();
    }

    private static Topic<Note<?>> stored(String topic) {
        @SuppressWarnings({"unchecked", "rawtypes"}) // a class can't tell of what notes are
        Class<Note<?>> any = (Class<Note<?>>) (Class) Note.class;
        return new Topic<>(topic, any);
    }

    private static final class Author {
        private final Blackboard board;
        private Instant session = Instant.MIN;
        private long number;

        Author(Blackboard board) {
            this.board = board;
        }

        boolean hears(BoardService.Writing said) {
            if (!said.isAfter(session, number)) {
                return false;
            }
            session = said.session();
            number = said.number();
            return true;
        }

        void erase(Note.Name name) {
            board.erase(stored(name.topic()), name.name());
        }

        Optional<Note<?>> read(Note.Name name) {
            return board.read(stored(name.topic()), name.name()).map(Blackboard.Note::content);
        }

        Stream<Note<?>> notes(String topic) {
            return board.read(stored(topic)).stream().map(Blackboard.Note::content);
        }
    }
}
