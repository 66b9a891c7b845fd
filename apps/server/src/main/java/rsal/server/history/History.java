package rsal.server.history;

import java.time.Duration;
import java.util.List;
import org.jspecify.annotations.Nullable;
import rsal.engine.report.RunEvent;
import rsal.server.frame.Feed;
import rsal.server.frame.FrameEncoder;
import rsal.server.frame.Moment;
import rsal.server.frame.TrailMaker;
import rsal.server.message.Messages.Trails;

/// The moments of a live run that viewers were or could have been shown, to look back on. At most [#MOST_BYTES]
/// are kept, [thinned][DownsampledSeries] so that it reaches back to the beginning. For one thread, but for
/// [#trails].
public final class History implements Past {
    static final long MOST_BYTES = 64L << 20;

    private static final Duration FIRST_SPACING = Duration.ofMillis(100); // of the run

    private final Feed feed;
    private final DownsampledSeries<Moment> moments;

    /// @param feed of the run
    public History(Feed feed) {
        this(feed, MOST_BYTES);
    }

    /// @param most bytes that it keeps
    public History(Feed feed, long most) {
        this.feed = feed;
        this.moments = new DownsampledSeries<>(most, FIRST_SPACING, History::bytes);
    }

    /// Keeps what the feed shows now, unless that is hardly newer than the last, or as old.
    ///
    /// @param time of the feed's frame, since the run's start
    /// @param last whether there will be none after it
    public synchronized void keep(Duration time, boolean last) {
        var moment = new Moment(time, feed.things(), feed.details(0), feed.frame());
        boolean known = moments.endsAt(time);
        if (known ? last && !newest().details().equals(moment.details()) : last || moments.isDue(time)) {
            moments.keep(time, moment); // how it ended is known a little later
        }
    }

    private Moment newest() {
        return moments.all().getLast().value();
    }

    /// Of all moments together.
    public long bytes() {
        return moments.bytes();
    }

    /// What it takes beyond the one before.
    private static long bytes(@Nullable Moment before, Moment moment) {
        boolean sameDetails = before != null && before.details().equals(moment.details());
        return (long) moment.frame().length
                + (sameDetails ? 0 : moment.details().length());
    }

    /// Where robots went before some time. For any thread.
    public Trails trails(Duration until) {
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
        if (moments.all().isEmpty() || until.compareTo(from()) < 0) {
            return List.of();
        }
        int last = moments.newest(until);
        int first = last;
        Duration begin = time(last).minus(TrailMaker.SECONDS);
        while (first > 0 && time(first - 1).compareTo(begin) >= 0) {
            first--;
        }
        return moments.all().subList(first, last + 1).stream()
                .map(DownsampledSeries.Entry::value)
                .toList();
    }

    private Duration time(int moment) {
        return moments.all().get(moment).time();
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
        return moments.all().isEmpty() ? Duration.ZERO : time(0);
    }

    @Override
    public Duration until() {
        return moments.all().isEmpty() ? Duration.ZERO : moments.all().getLast().time();
    }

    @Override
    public boolean isRecording() {
        return false;
    }

    @Override
    public Moment at(Duration time) {
        return moments.at(time).orElseThrow().value();
    }

    @Override
    public Duration near(Duration time, int after) {
        return time(
                Math.clamp((long) moments.newest(time) + after, 0, moments.all().size() - 1));
    }

    @Override
    public List<RunEvent> events(long sequence) {
        return feed.events(sequence);
    }
}
