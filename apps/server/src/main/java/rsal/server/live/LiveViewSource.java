package rsal.server.live;

import java.time.Duration;
import rsal.server.frame.Feed;
import rsal.server.history.History;
import rsal.server.history.NumberHistory;
import rsal.server.history.Past;
import rsal.server.history.Recollection;
import rsal.server.message.Messages.Trails;

/// Shows the run that goes on, and what has been of it. For one thread, but for [#bytesKept],
/// [#numbers], [#recollection] and [#trails].
public final class LiveViewSource implements ViewSource {
    private static final double FOLLOWED = 15; // times real time; a robot of 0.5 m/s is elsewhere then at each look
    /// The same of a run that is to be as fast as it can, from which each look takes something.
    private static final double FOLLOWED_IN_HASTE = 4;
    /// Of these while fewer looks are taken, as more of them would make it slower.
    private static final double STILL = 0.7;

    private final CurrentRun current;
    private RunFeed feed;
    private volatile History history;
    private volatile NumberHistory numbers = new NumberHistory();
    private volatile Recollection recollection = new Recollection();
    private volatile long bytesKept;
    private boolean fast;

    public LiveViewSource(CurrentRun current) {
        this.current = current;
        feed = new RunFeed(current.now());
        history = new History(feed);
    }

    @Override
    public void look(int pause) {
        if (feed.number() != current.now().number()) {
            feed = new RunFeed(current.now());
            history = new History(feed);
            numbers = new NumberHistory();
            recollection = new Recollection();
        }
        feed.look(pause);
        history.keep(feed.time(), feed.isLast());
        numbers.look(feed.run().run(), feed.present(), feed.time());
        recollection.look(feed.run().run(), feed.seen());
        bytesKept = history.bytes() + recollection.bytes();
        fast = isFast(feed.speed(), feed.rate(), fast);
    }

    /// @param speed as asked for
    /// @param rate as measured
    /// @param before whether it was
    static boolean isFast(double speed, double rate, boolean before) {
        double followed = Double.isFinite(speed) ? FOLLOWED : FOLLOWED_IN_HASTE;
        return rate > (before ? STILL : 1) * followed;
    }

    /// What looking back takes. For any thread.
    public long bytesKept() {
        return bytesKept;
    }

    /// What devices have told so far, as numbers. For any thread.
    public NumberHistory numbers() {
        return numbers;
    }

    /// What devices had told and agents had in mind before. For any thread.
    public Recollection recollection() {
        return recollection;
    }

    /// Where robots went before some time. For any thread.
    public Trails trails(Duration until) {
        return history.trails(until);
    }

    @Override
    public Feed live() {
        return feed;
    }

    @Override
    public Past past() {
        return history;
    }

    @Override
    public boolean isFast() {
        return fast;
    }
}
