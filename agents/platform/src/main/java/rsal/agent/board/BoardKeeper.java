package rsal.agent.board;

import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Iterator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import rsal.agent.AgentContext;
import rsal.agent.protocol.Request.Asked;
import rsal.agent.protocol.Subscribe.Subscriber;

/// The master of a board: keeps a team's notes, answers who asks for some and tells those who watch what has changed.
/// Of two masters of one board the one that started first keeps it; the other stands by until that one has ended.
///
/// Those who watch are told at most ten times a second, the newest of each note. All on the agent's lane.
public final class BoardKeeper {
    private static final Duration BEAT = Duration.ofMillis(100);

    private final AgentContext self;
    private final String board;
    private final Limits limits;
    private final Authors authors;
    private final Set<Watcher> watchers = new LinkedHashSet<>();
    private boolean beatIsDue;

    /// @param board its name
    public BoardKeeper(AgentContext self, String board, Limits limits) {
        this.self = self;
        this.board = board;
        this.limits = limits;
        this.authors = new Authors(self.scheduler(), limits.authors(), limits.notes());
    }

    /// From now on keeps it.
    public void begin() {
        BoardService.writing(self, board).answer(this::write);
        BoardService.asking(self, board).answer(this::answer);
        BoardService.watching(self, board).answer(this::admit);
        self.offer(BoardService.capability(board));
        self.directory().onDeparture(_ -> publish());
        publish();
    }

    private void write(Asked<BoardService.Writing, BoardService.Written> asked) {
        BoardService.Writing said = asked.what();
        if (said.notes().size() + said.erased().size() > BoardService.MOST_AT_ONCE) {
            asked.refuse("Only %d notes may be written at once.".formatted(BoardService.MOST_AT_ONCE));
            return;
        }
        boolean isNew;
        try {
            isNew = authors.isNew(asked.from(), said);
        } catch (IllegalStateException full) {
            asked.refuse(String.valueOf(full.getMessage()));
            return;
        }
        asked.inform(new BoardService.Written(isNew ? take(asked.from(), said) : Map.of()));
        publishSoon();
    }

    private Map<Note.Name, String> take(String author, BoardService.Writing said) {
        var refused = new HashMap<Note.Name, String>();
        for (Note.Name name : said.erased()) {
            change(new Note.Key(author, name), () -> authors.erase(new Note.Key(author, name)));
        }
        for (Note<?> note : said.notes()) {
            if (note.author().equals(author)) {
                change(
                        note.key(),
                        () -> authors.put(note)
                                .ifPresent(why -> refused.put(note.key().name(), why)));
            } else {
                refused.put(
                        note.key().name(), "'%s' writes notes in the name of '%s'.".formatted(author, note.author()));
            }
        }
        return refused;
    }

    /// Notes who has to hear of it.
    private void change(Note.Key key, Runnable how) {
        Optional<Note<?>> before = authors.read(key);
        how.run();
        Optional<Note<?>> after = authors.read(key);
        for (Watcher watcher : watchers) {
            if (before.filter(watcher.query::wants).isPresent()
                    || after.filter(watcher.query::wants).isPresent()) {
                watcher.dirty.add(key);
            }
        }
    }

    private void answer(Asked<BoardService.Asking, BoardService.Answer> asked) {
        asked.inform(answer(asked.what().query()));
    }

    private <M> BoardService.Answer answer(Query<M> query) {
        List<Note<M>> all = authors.find(query);
        int shown = Math.min(all.size(), query.most());
        return new BoardService.Answer(List.copyOf(all.subList(0, shown)), all.size() - shown);
    }

    private void admit(Subscriber<BoardService.Asking, BoardService.Changes> subscriber) {
        List.copyOf(watchers).stream()
                .filter(watcher -> watcher.isSame(subscriber))
                .forEach(
                        watcher -> { // which that agent has given up, as it heard nothing for a while
                            watchers.remove(watcher);
                            watcher.subscriber.fail("'%s' has asked again.".formatted(subscriber.from()));
                        });
        long own = watchers.stream()
                .filter(watcher -> watcher.subscriber.from().equals(subscriber.from()))
                .count();
        if (own >= limits.watchesEach() || watchers.size() >= limits.watches()) {
            subscriber.refuse("%d watch here, %d of them (%s); no more than %d and %d may."
                    .formatted(watchers.size(), own, subscriber.from(), limits.watches(), limits.watchesEach()));
            return;
        }
        var watcher = new Watcher(subscriber, subscriber.what().query());
        watchers.add(watcher);
        subscriber.whenUnwanted(() -> {
            watchers.remove(watcher);
            publish();
        });
        authors.find(watcher.query).forEach(note -> watcher.dirty.add(note.key()));
        watcher.publishChanges();
        publishSoon();
    }

    private void publishSoon() {
        if (!beatIsDue) {
            beatIsDue = true;
            self.scheduler().after(BEAT, () -> {
                beatIsDue = false;
                beat();
            });
        }
    }

    private void beat() {
        for (Watcher watcher : List.copyOf(watchers)) {
            if (!watcher.dirty.isEmpty()) {
                watcher.publishChanges();
            }
        }
        if (watchers.stream().anyMatch(watcher -> !watcher.dirty.isEmpty())) {
            publishSoon();
        }
        publish();
    }

    private void publish() {
        List<String> keepers = BoardService.keepers(self.directory(), board);
        if (!keepers.isEmpty() && !keepers.getFirst().equals(self.name())) {
            self.state("standing by for '%s'".formatted(keepers.getFirst()));
        } else {
            self.state("keeping %d notes, which %d watch".formatted(authors.size(), watchers.size()));
        }
    }

    /// How much room there is, so that nobody can take it all.
    ///
    /// @param authors how many agents may have notes, from 1
    /// @param notes how many notes each may have, from 1
    /// @param watches how many may watch, from 0
    /// @param watchesEach how many queries one agent may watch, from 0
    public record Limits(int authors, int notes, int watches, int watchesEach) {
        public static final Limits DEFAULT = new Limits(1_000, 250, 1_000, 16);

        public Limits {
            if (authors < 1 || notes < 1 || watches < 0 || watchesEach < 0) {
                throw new IllegalArgumentException(
                        "A board needs positive limits, not (%d authors, %d notes, %d and %d subscriptions)."
                                .formatted(authors, notes, watches, watchesEach));
            }
        }
    }

    private final class Watcher {
        private final Subscriber<BoardService.Asking, BoardService.Changes> subscriber;
        private final Query<?> query;
        private final Set<Note.Key> dirty = new LinkedHashSet<>();
        private final Set<Note.Key> reported = new HashSet<>();
        private boolean begun;

        Watcher(Subscriber<BoardService.Asking, BoardService.Changes> subscriber, Query<?> query) {
            this.subscriber = subscriber;
            this.query = query;
        }

        boolean isSame(Subscriber<BoardService.Asking, BoardService.Changes> other) {
            return subscriber.from().equals(other.from())
                    && subscriber.what().watch() == other.what().watch();
        }

        void publishChanges() {
            var notes = new ArrayList<Note<?>>();
            var gone = new ArrayList<Note.Key>();
            Iterator<Note.Key> next = dirty.iterator();
            while (next.hasNext() && notes.size() + gone.size() < BoardService.MOST_AT_ONCE) {
                Note.Key key = next.next();
                next.remove();
                Optional<Note<?>> note = authors.read(key).filter(query::wants);
                note.ifPresent(notes::add);
                if (note.isPresent()) {
                    reported.add(key);
                } else if (reported.remove(key)) {
                    gone.add(key);
                }
            }
            if (!begun || !notes.isEmpty() || !gone.isEmpty()) {
                subscriber.inform(new BoardService.Changes(!begun, notes, gone));
                begun = true;
            }
            if (reported.size() > 2 * authors.size() + BoardService.MOST_AT_ONCE) {
                reported.removeIf(key -> authors.read(key).isEmpty()); // have faded there, too
            }
        }
    }
}
