package rsal.agent.board;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import rsal.agent.AgentContext;
import rsal.agent.Directory;
import rsal.agent.ServiceDescription;
import rsal.agent.Topic;
import rsal.agent.protocol.Conversation;
import rsal.agent.protocol.ConversationResult;
import rsal.agent.protocol.Request;
import rsal.agent.protocol.Subscribe;
import rsal.data.Point2d;

/// An agent's end of a board that its team shares: writes notes, asks for some, watches others. Make one for each
/// board.
///
/// Notes are written one message after the other, each with all that has changed meanwhile, so that of a note that
/// changes quickly the newest arrives. An agent may have a thousand; what is more is refused. All on the agent's lane.
public final class TeamBoard {
    private static final Duration RETRY = Duration.ofSeconds(2);
    private static final int MOST_OWN = 1_000;
    private static final int MOST_UNTOLD = 2 * MOST_OWN;

    private final AgentContext self;
    private final String board;
    private final Consumer<? super BoardEvent> listener;
    private final Request<BoardService.Writing, BoardService.Written> writing;
    private final Request<BoardService.Asking, BoardService.Answer> asking;
    private final Subscribe<BoardService.Asking, BoardService.Changes> watching;
    private final Instant session;
    private final Map<Note.Name, Note<?>> own = new LinkedHashMap<>(); // until they fade
    private final Set<Note.Name> changed = new LinkedHashSet<>(); // and not known to the master
    private final Set<BoardWatch<?>> watches = new LinkedHashSet<>();
    private Optional<String> keeper = Optional.empty();
    private Set<Note.Name> inProgress = Set.of();
    private long number;
    private long watched;
    private boolean silent;
    private boolean retryIsDue;

    /// @param board its name, which the master has, too
    /// @param listener told what becomes of the board, on the agent's lane
    public TeamBoard(AgentContext self, String board, Consumer<? super BoardEvent> listener) {
        this.self = self;
        this.board = board;
        this.listener = listener;
        this.writing = BoardService.writing(self, board);
        this.asking = BoardService.asking(self, board);
        this.watching = BoardService.watching(self, board);
        this.session = self.scheduler().instant();
        self.directory().onChange(this::note);
        self.directory().onDeparture(went -> gone(went.agent().name())); // after the conversations with it have ended
        self.scheduler().execute(this::look); // when its owner is ready to be told
    }

    /// The master, as far as is known; empty when there is none.
    public Optional<String> keeper() {
        return keeper;
    }

    /// Writes a note about no place in particular.
    ///
    /// @throws IllegalArgumentException when it is nothing for a board ([Note])
    public <M> void write(Topic<M> topic, String name, M content, Duration lifetime) {
        write(new Note<>(topic, name, content, Optional.empty(), self.name(), now(), lifetime));
    }

    /// Writes a note about a place.
    ///
    /// @throws IllegalArgumentException when it is nothing for a board ([Note])
    public <M> void write(Topic<M> topic, String name, M content, Point2d mapFromPlace, Duration lifetime) {
        write(new Note<>(topic, name, content, Optional.of(mapFromPlace), self.name(), now(), lifetime));
    }

    private void write(Note<?> note) {
        Note.Name name = note.key().name();
        own.values().removeIf(old -> old.hasFaded(now()));
        boolean isFull = own.size() >= MOST_OWN && !own.containsKey(name);
        if (isFull || !mayTell(name)) {
            refuse(name, "'%s' has more notes than the maximum of %d for one agent.".formatted(self.name(), MOST_OWN));
            return;
        }
        own.put(name, note);
        changed.add(name);
        send();
    }

    /// Takes back what this agent wrote; one that it did not write is left as it is.
    public void erase(Topic<?> topic, String name) {
        Note.Name known = Note.Name.of(topic, name);
        if (own.remove(known) == null) {
            return;
        }
        if (mayTell(known)) {
            changed.add(known);
            send();
        } else {
            refuse(
                    known,
                    "Too many removals wait for board '%s'. Its notes stay there until they expire.".formatted(board));
        }
    }

    private boolean mayTell(Note.Name name) {
        return changed.size() < MOST_UNTOLD || changed.contains(name);
    }

    /// Asks the master.
    ///
    /// @param onEnd told once: what was found, or why it is not known
    public <M> void ask(Query<M> query, Consumer<? super ConversationResult<Found<M>>> onEnd) {
        if (keeper.isEmpty()) {
            look();
        }
        keeper.ifPresentOrElse(
                name -> asking.ask(
                        name,
                        new BoardService.Asking(query, 0),
                        ending -> onEnd.accept(ending.map(answer -> new Found<>(
                                answer.notes().stream()
                                        .filter(query::wants)
                                        .map(query::typed)
                                        .toList(),
                                answer.left())))),
                () -> self.scheduler()
                        .execute(() -> onEnd.accept(
                                new ConversationResult.Silent<>("Nobody keeps board '%s'.".formatted(board)))));
    }

    /// Keeps what the master tells of these notes, and goes on when another takes over.
    ///
    /// @param onChange told, on the agent's lane, when something else is heard; not when notes fade
    public <M> BoardWatch<M> watch(Query<M> query, Runnable onChange) {
        var watch = new BoardWatch<>(self.scheduler(), ++watched, query, onChange);
        watch.stopBy(() -> watches.remove(watch));
        watches.add(watch);
        follow(watch);
        return watch;
    }

    private void follow(BoardWatch<?> watch) {
        if (watch.isOver() || watch.isFollowing() || keeper.isEmpty()) {
            return;
        }
        String name = keeper.get();
        int turn = watch.follows();
        Conversation talk = watching.subscribe(
                name,
                new BoardService.Asking(watch.query(), watch.number()),
                changes -> {
                    if (watch.isTurn(turn)) {
                        heard();
                        watch.take(changes);
                    }
                },
                ending -> {
                    if (watch.isTurn(turn)) {
                        unfollow(watch, name, ending);
                    }
                });
        watch.stopBy(() -> {
            talk.cancel();
            watches.remove(watch);
        });
    }

    private void unfollow(BoardWatch<?> watch, String name, ConversationResult<BoardService.Changes> ending) {
        watch.lost();
        switch (ending) {
            case ConversationResult.Refused<BoardService.Changes>(String why) -> refuse("watch " + watch.query(), why);
            case ConversationResult.NotUnderstood<BoardService.Changes>(String why) ->
                refuse("watch " + watch.query(), why);
            case ConversationResult.Silent<BoardService.Changes>(String why) -> followAgain(watch, name, why);
            case ConversationResult.Failed<BoardService.Changes>(String why) -> followAgain(watch, name, why);
            case ConversationResult.Cancelled<BoardService.Changes> _,
                    ConversationResult.Informed<BoardService.Changes> _ -> {}
        }
    }

    private void followAgain(BoardWatch<?> watch, String name, String why) {
        fellSilent(name, why);
        self.scheduler().after(RETRY, () -> follow(watch));
    }

    private void note(Directory.Change change) {
        if (change instanceof Directory.Change.Offered(Directory.Entry _, ServiceDescription offered)
                && offered.equals(BoardService.capability(board))) {
            look();
        }
    }

    private void gone(String agent) {
        if (keeper.filter(agent::equals).isPresent()) {
            keeper = Optional.empty();
            watches.forEach(BoardWatch::lost);
            listener.accept(new BoardEvent.Gone(agent));
            look();
        }
    }

    /// Whether somebody keeps the board, whom all is told that is not told yet.
    private void look() {
        if (keeper.isPresent()) {
            return;
        }
        keeper = BoardService.keepers(self.directory(), board).stream()
                .filter(name -> !name.equals(self.name()))
                .findFirst();
        keeper.ifPresent(name -> {
            silent = false;
            inProgress = Set.of(); // those that were told are gone
            changed.addAll(own.keySet());
            listener.accept(new BoardEvent.Kept(name));
            send();
            List.copyOf(watches).forEach(this::follow);
        });
    }

    private void send() {
        if (keeper.isEmpty() || !inProgress.isEmpty() || changed.isEmpty() || retryIsDue) {
            return;
        }
        Set<Note.Name> next = new LinkedHashSet<>(
                changed.stream().limit(BoardService.MOST_AT_ONCE).toList());
        changed.removeAll(next);
        inProgress = next;
        number++;
        var notes = new ArrayList<Note<?>>();
        var erased = new ArrayList<Note.Name>();
        for (Note.Name name : next) {
            Optional.<Note<?>>ofNullable(own.get(name)).ifPresentOrElse(notes::add, () -> erased.add(name));
        }
        String to = keeper.get();
        writing.ask(to, new BoardService.Writing(session, number, notes, erased), ending -> sent(to, next, ending));
    }

    @SuppressWarnings("ReferenceEquality") // two may be of the same notes
    private void sent(String to, Set<Note.Name> what, ConversationResult<BoardService.Written> ending) {
        if (inProgress == what) {
            inProgress = Set.of();
        }
        switch (ending) {
            case ConversationResult.Informed<BoardService.Written>(BoardService.Written written) -> {
                heard();
                written.refused().entrySet().stream()
                        .sorted(Map.Entry.comparingByKey(
                                Comparator.comparing(Note.Name::topic).thenComparing(Note.Name::name)))
                        .forEach(refused -> giveUp(refused.getKey(), refused.getValue()));
            }
            case ConversationResult.Refused<BoardService.Written>(String why) ->
                what.forEach(name -> giveUp(name, why));
            case ConversationResult.NotUnderstood<BoardService.Written>(String why) ->
                what.forEach(name -> giveUp(name, why));
            case ConversationResult.Failed<BoardService.Written>(String why) -> what.forEach(name -> giveUp(name, why));
            case ConversationResult.Silent<BoardService.Written>(String why) -> {
                changed.addAll(what);
                fellSilent(to, why);
                retry(to);
            }
            case ConversationResult.Cancelled<BoardService.Written> _ -> {} // nobody does
        }
        send();
    }

    private void giveUp(Note.Name name, String why) {
        if (!changed.contains(name)) { // else it has a newer one, about which will be heard
            own.remove(name);
        }
        refuse(name, why);
    }

    private void retry(String name) {
        if (keeper.filter(name::equals).isPresent() && !retryIsDue) {
            retryIsDue = true;
            self.scheduler().after(RETRY, () -> {
                retryIsDue = false;
                send();
            });
        }
    }

    private void fellSilent(String name, String why) {
        boolean isThere = self.directory().find(name).isPresent(); // else it has gone, which is told as such
        if (isThere && keeper.filter(name::equals).isPresent() && !silent) {
            silent = true;
            listener.accept(new BoardEvent.Silent(name, why));
        }
    }

    private void heard() {
        if (silent && keeper.isPresent()) {
            silent = false;
            listener.accept(new BoardEvent.Heard(keeper.get()));
        }
    }

    private void refuse(Object what, String why) {
        listener.accept(new BoardEvent.Refused(what.toString(), why));
    }

    private Instant now() {
        return self.scheduler().instant();
    }
}
