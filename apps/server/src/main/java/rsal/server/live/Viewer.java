package rsal.server.live;

import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import rsal.engine.SpeedFactor;
import rsal.engine.report.RunEvent;
import rsal.server.description.Descriptions;
import rsal.server.frame.Feed;
import rsal.server.frame.ObjectRegistry;
import rsal.server.history.Past;
import rsal.server.live.ViewerCounts.Kind;
import rsal.server.live.ViewerCounts.Reason;
import rsal.server.message.Json;
import rsal.server.message.Messages.Events;
import rsal.server.message.Messages.LookBack;
import rsal.server.message.Messages.MotorsOff;
import rsal.server.message.Messages.Reach;
import rsal.server.message.Messages.Receipt;
import rsal.server.message.Messages.ServerMessage;
import rsal.server.message.Messages.Things;
import rsal.server.message.Refusal;

/// One browser that watches. It is sent no more than it takes: at most [#FRAMES] frames and one batch of events
/// are under way, the rest waits where it is anyway, frames as the newest snapshot and events in the run's log.
/// One that takes nothing for [#PATIENCE] is let go.
public final class Viewer {
    public static final int FRAMES = 2;
    static final int EVENTS = 500;
    /// In offers, which come 20 times a second.
    static final int PATIENCE = 20 * 20;

    /// At least so many offers lie between two times that it is told how far it can look back.
    private static final int OFFERS_PER_REACH = 5;
    /// It is told that along with a frame, so that its page is drawn once for both; after so many offers by itself.
    private static final int LONGEST_WITHOUT_REACH = 2 * OFFERS_PER_REACH;

    /// Where messages go. Sending does not wait.
    public interface Line {
        void send(String text);

        void send(byte[] bytes);

        /// Whether all that was sent has left this process. What a viewer says it has taken is only its word.
        boolean isClear();

        /// Ends it without a word, since none would get through.
        void cut();
    }

    private final Line line;
    private final ViewerCounts counts;
    private final Deque<Long> framesInProgress = new ArrayDeque<>();
    private int run; // 0 is none
    private long newestFrame;
    private long details; // their version; 0 is none
    private int robots;
    private final Set<Integer> things = new HashSet<>(); // their numbers
    private @Nullable ObjectRegistry reported; // all of it
    private long eventsSent;
    private long eventsTaken;
    private int offersWaited; // since it last took something
    private boolean shows; // some frame of the run

    // where it looks
    private @Nullable LookBack wish;
    private @Nullable PlaybackCursor looking; // null is the present
    private int looks = 1; // elsewhere than where it was going
    private @Nullable Reach reach; // as it was told
    private int offersSinceReach;

    /// @param counts where is counted what it was sent
    public Viewer(Line line, ViewerCounts counts) {
        this.line = line;
        this.counts = counts;
    }

    /// Ends it, as it can't be shown anything; its page comes again.
    void drop() {
        line.cut();
    }

    /// Sends what is new where it looks.
    ///
    /// @param live the present; null when there is none
    /// @param passed since it was last offered something, in real time
    public synchronized void offer(@Nullable Feed live, Past past, Duration passed) {
        look(live, past, passed);
        Feed feed = looking == null ? live : looking;
        if (feed != null) {
            offer(feed, reach(past, live == null ? MotorsOff.NONE : live.motorsOff()));
        }
    }

    private static Reach reach(Past past, MotorsOff motors) {
        return new Reach(
                past.number(), past.from().toNanos() / 1e9, past.until().toNanos() / 1e9, motors);
    }

    private void look(@Nullable Feed live, Past past, Duration passed) {
        PlaybackCursor before = looking;
        PlaybackCursor here = before != null && before.past().equals(past) ? before : null; // else of a run before
        LookBack wanted = wish;
        wish = null;
        if (wanted != null && (!wanted.live().orElse(false) || live == null)) {
            looking = PlaybackCursor.at(past, wanted, here == null ? past.until() : here.time(), looks);
            looks = looking.looks();
        } else if (wanted != null) {
            looking = null;
        } else if (here != null) {
            here.pass(shows ? passed : Duration.ZERO); // its page may still be loading
            looking = live != null && here.isPlaying() && here.hasArrived() ? null : here;
        } else {
            looking = live == null ? new PlaybackCursor(past) : null;
        }
        if (looking != before) {
            newestFrame = 0; // frames and details are counted again
            details = 0;
        }
    }

    /// Sends what is new of the run, as far as the viewer has taken what it was sent before.
    private void offer(Feed feed, Reach farthest) {
        if (isWaitedFor() && ++offersWaited > PATIENCE) {
            if (offersWaited == PATIENCE + 1) { // it is not gone at once
                counts.letGo(Reason.SILENT);
            }
            line.cut();
        } else if (line.isClear()) {
            if (run != feed.number()) {
                begin(feed);
            }
            sendNews(feed);
            sendReach(farthest, isDue(feed));
            sendFrame(feed);
            sendEvents(feed);
        }
    }

    private boolean isWaitedFor() {
        return !line.isClear() || !framesInProgress.isEmpty() || eventsTaken < eventsSent;
    }

    /// Who and what has come, before the frame that has them.
    private void sendNews(Feed feed) {
        if (robots < feed.robots()) {
            send(Kind.NEWCOMERS, feed.newcomers(robots));
            robots = feed.robots();
        }
        ObjectRegistry roster = feed.things();
        if (!roster.equals(reported)) {
            Optional<Things> news = roster.news(things);
            news.ifPresent(some -> send(Kind.THINGS, Json.write(ServerMessage.of(some))));
            reported = news.isPresent() ? null : roster;
        }
    }

    /// @param along whether a frame is sent along with it
    private void sendReach(Reach now, boolean along) {
        offersSinceReach++;
        boolean due = reach == null
                || reach.run() != run
                || !reach.motors().equals(now.motors())
                || offersSinceReach >= (along ? OFFERS_PER_REACH : LONGEST_WITHOUT_REACH);
        if (due && now.run() == run && !now.equals(reach)) {
            reach = now;
            offersSinceReach = 0;
            send(Kind.REACH, Json.write(ServerMessage.of(now)));
        }
    }

    private boolean isDue(Feed feed) {
        return newestFrame < feed.sequence() && framesInProgress.size() < FRAMES;
    }

    private void sendFrame(Feed feed) {
        if (!isDue(feed)) {
            return;
        }
        if (details != feed.detailsVersion()) {
            send(Kind.DETAILS, feed.details(details));
            details = feed.detailsVersion();
        }
        if (newestFrame > 0) {
            counts.skipped(feed.sequence() - newestFrame - 1);
        }
        newestFrame = feed.sequence();
        framesInProgress.add(newestFrame);
        line.send(feed.frame());
        counts.sent(Kind.FRAME, feed.frame().length);
    }

    private void send(Kind kind, String text) {
        line.send(text);
        counts.sent(kind, text.getBytes(StandardCharsets.UTF_8).length);
    }

    private void begin(Feed feed) {
        run = feed.number();
        framesInProgress.clear();
        shows = false;
        newestFrame = 0;
        details = 0;
        robots = feed.robots();
        things.clear();
        reported = null;
        eventsSent = 0;
        eventsTaken = 0;
        send(Kind.RUN, feed.info());
    }

    private void sendEvents(Feed feed) {
        if (eventsTaken < eventsSent) {
            return;
        }
        List<RunEvent> news = feed.events(eventsSent);
        if (news.isEmpty()) {
            return;
        }
        List<RunEvent> batch = news.subList(0, Math.min(EVENTS, news.size()));
        eventsSent = batch.getLast().sequence();
        var events = new Events(run, batch.stream().map(Descriptions::event).toList());
        send(Kind.EVENTS, Json.write(ServerMessage.of(events)));
    }

    /// The viewer says what it has taken. What it was not sent, it can't have taken.
    ///
    /// @throws Refusal when it wants to look where nobody can
    public synchronized void received(Receipt receipt) {
        receipt.look().ifPresent(look -> {
            look.speed().ifPresent(Viewer::speed); // refused now, not when it is offered something
            wish = wish == null ? look : wish.then(look); // several may come between two offers
        });
        boolean taken = receipt.frame()
                .map(frame -> framesInProgress.removeIf(sent -> sent <= frame))
                .orElse(false);
        long events = Math.clamp(receipt.events().orElse(0L), eventsTaken, eventsSent);
        shows |= taken;
        if (taken || events > eventsTaken) {
            offersWaited = 0;
        }
        eventsTaken = events;
    }

    private static double speed(String typed) {
        return Refusal.unless(() -> SpeedFactor.parse(typed));
    }
}
