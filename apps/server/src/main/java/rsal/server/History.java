package rsal.server;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import rsal.scenario.run.RunEvent;
import rsal.server.Messages.Trails;

/// The moments of a live run that viewers were or could have been shown, to look back on. At most [#MOST_BYTES] are
/// kept: when it has more, every second moment is let go and half as many are kept from then on, so that it reaches
/// back to the beginning, ever more coarsely. For one thread, but for [#trails].
final class History implements Past {
    static final long MOST_BYTES = 64L << 20;

    private static final Duration FIRST_SPACING = Duration.ofMillis(100); // of the run

    private final Feed feed;
    private final long most;
    private List<Moment> moments = new ArrayList<>();
    private Duration spacing = FIRST_SPACING;
    private long bytes;

    /// @param feed of the run
    History(Feed feed) {
        this(feed, MOST_BYTES);
    }

    /// @param most bytes that it keeps
    History(Feed feed, long most) {
        this.feed = feed;
        this.most = most;
    }

    /// Keeps what the feed shows now, unless that is hardly newer than the last, or as old.
    ///
    /// @param time of the feed's frame, since the run's start
    /// @param last whether there will be none after it
    synchronized void keep(Duration time, boolean last) {
        Duration newest = moments.isEmpty() ? null : moments.getLast().time();
        boolean due =
                newest == null || time.compareTo(newest.plus(spacing)) >= 0 || (last && time.compareTo(newest) > 0);
        var moment = new Moment(time, feed.things(), feed.details(0), feed.frame());
        if (last && time.equals(newest) && !moments.getLast().details().equals(moment.details())) {
            bytes -= bytes(moments.size() > 1 ? moments.get(moments.size() - 2) : null, moments.removeLast());
            due = true; // how it ended is known a little later
        }
        if (!due) {
            return;
        }
        bytes += bytes(moments.isEmpty() ? null : moments.getLast(), moment);
        moments.add(moment);
        while (bytes > most && moments.size() > 2) {
            thin();
        }
    }

    /// Of all moments together.
    long bytes() {
        return bytes;
    }

    private void thin() {
        spacing = spacing.multipliedBy(2);
        var some = new ArrayList<Moment>(moments.size() / 2 + 1);
        bytes = 0;
        for (int i = 0; i < moments.size(); i += 2) { // the first stays, so that it reaches back to there
            bytes += bytes(some.isEmpty() ? null : some.getLast(), moments.get(i));
            some.add(moments.get(i));
        }
        moments = some;
    }

    /// What it takes beyond the one before.
    private static long bytes(@Nullable Moment before, Moment moment) {
        boolean sameDetails = before != null && before.details().equals(moment.details());
        return (long) moment.frame().length
                + (sameDetails ? 0 : moment.details().length());
    }

    /// Where robots went before some time. For any thread.
    Trails trails(Duration until) {
        List<Moment> some = recent(until);
        int robots = some.isEmpty() ? 0 : FrameEncoder.robots(some.getLast().frame()); // as those that leave stay
        var trails = new TrailMaker(robots);
        Duration spacing = TrailMaker.spacing(robots);
        Duration next = Duration.ZERO;
        for (Moment moment : some) {
            if (moment.time().compareTo(next) >= 0) {
                next = moment.time().plus(spacing);
                double seconds = moment.time().toNanos() / 1e9;
                FrameEncoder.places(moment.frame(), (robot, x, y) -> trails.add(robot, seconds, x, y));
            }
        }
        return trails.trails();
    }

    private synchronized List<Moment> recent(Duration until) {
        if (moments.isEmpty() || until.compareTo(moments.getFirst().time()) < 0) {
            return List.of();
        }
        int last = newest(until);
        int first = last;
        Duration begin = moments.get(last).time().minus(TrailMaker.SECONDS);
        while (first > 0 && moments.get(first - 1).time().compareTo(begin) >= 0) {
            first--;
        }
        return List.copyOf(moments.subList(first, last + 1));
    }

    @Override
    public int number() {
        return feed.number();
    }

    @Override
    public String info() {
        return feed.info();
    }

    @Override
    public int robots() {
        return feed.robots();
    }

    @Override
    public String newcomers(int known) {
        return feed.newcomers(known);
    }

    @Override
    public Duration from() {
        return moments.isEmpty() ? Duration.ZERO : moments.getFirst().time();
    }

    @Override
    public Duration until() {
        return moments.isEmpty() ? Duration.ZERO : moments.getLast().time();
    }

    @Override
    public boolean isRecording() {
        return false;
    }

    @Override
    public Moment at(Duration time) {
        return moments.get(newest(time));
    }

    @Override
    public Duration near(Duration time, int after) {
        return moments.get(Math.clamp((long) newest(time) + after, 0, moments.size() - 1))
                .time();
    }

    /// Index of the newest by then; of the first when there is none.
    private int newest(Duration time) {
        int low = 0;
        int high = moments.size() - 1;
        while (low < high) {
            int middle = (low + high + 1) / 2;
            if (moments.get(middle).time().compareTo(time) <= 0) {
                low = middle;
            } else {
                high = middle - 1;
            }
        }
        return low;
    }

    @Override
    public List<RunEvent> events(long sequence) {
        return feed.events(sequence);
    }
}
