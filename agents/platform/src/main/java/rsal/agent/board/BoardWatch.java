package rsal.agent.board;

import java.time.InstantSource;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import rsal.device.Subscription;

/// What an agent has heard of a part of a board, ready to be read without asking. On the agent's lane.
public final class BoardWatch<M> implements Subscription {
    /// How many notes it remembers, the newest: more than it shows, as those that it shows may go.
    private static final int MOST = 10_000;

    private final InstantSource clock;
    private final long number;
    private final Query<M> query;
    private final Runnable listener;
    private final Map<Note.Key, Note<M>> heard = new HashMap<>();
    private Runnable stop = () -> {};
    private int turn; // counts conversations about it
    private boolean following;
    private boolean current;
    private boolean over;

    BoardWatch(InstantSource clock, long number, Query<M> query, Runnable listener) {
        this.clock = clock;
        this.number = number;
        this.query = query;
        this.listener = listener;
    }

    long number() {
        return number;
    }

    Query<M> query() {
        return query;
    }

    /// The notes that it wants and that have not faded, the newest first, as far as it has heard.
    public List<Note<M>> notes() {
        fade();
        return query.among(heard.values().stream()).stream().limit(query.most()).toList();
    }

    /// Whether the board's master tells of changes, as far as is known. While it does not, what was heard fades.
    public boolean isCurrent() {
        return current;
    }

    /// Wants to know no more.
    @Override
    public void cancel() {
        over = true;
        lost();
        stop.run();
    }

    boolean isOver() {
        return over;
    }

    boolean isFollowing() {
        return following;
    }

    /// A conversation about it begins, and what belongs to one before counts no more.
    int follows() {
        following = true;
        return ++turn;
    }

    boolean isTurn(int number) {
        return !over && following && number == turn;
    }

    void stopBy(Runnable how) {
        stop = how;
    }

    void lost() {
        following = false;
        current = false;
    }

    void take(BoardService.Changes changes) {
        current = true;
        if (changes.anew()) {
            heard.clear();
        }
        changes.gone().forEach(heard::remove);
        changes.notes().stream().filter(query::wants).forEach(note -> heard.put(note.key(), query.typed(note)));
        if (heard.size() > MOST) {
            fade();
            query.among(heard.values().stream()).stream()
                    .skip(MOST)
                    .map(Note::key)
                    .forEach(heard::remove);
        }
        listener.run();
    }

    private void fade() {
        heard.values().removeIf(note -> note.hasFaded(clock.instant()));
    }
}
