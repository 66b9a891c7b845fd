package rsal.server;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import rsal.scenario.run.RunEvent;
import rsal.server.Messages.Events;
import rsal.server.Messages.Receipt;
import rsal.server.Messages.ServerMessage;
import rsal.server.Messages.Things;

/// One browser that watches. It is sent no more than it takes: at most [#FRAMES] frames and one batch of events
/// are under way, the rest waits where it is anyway, frames as the newest snapshot and events in the run's log.
/// One that takes nothing for [#PATIENCE] is let go.
final class Viewer {
    static final int FRAMES = 2;
    static final int EVENTS = 500;
    /// In offers, which come 20 times a second.
    static final int PATIENCE = 20 * 20;

    /// Where messages go. Sending does not wait.
    interface Line {
        void send(String text);

        void send(byte[] bytes);

        /// Whether all that was sent has left this process. What a viewer says it has taken is only its word.
        boolean isClear();

        /// Ends it without a word, since none would get through.
        void cut();
    }

    private final Line line;
    private final Deque<Long> framesUnderWay = new ArrayDeque<>();
    private int run; // 0 is none
    private long newestFrame;
    private String details = "";
    private int robots;
    private final Set<Integer> things = new HashSet<>(); // their numbers
    private @Nullable Roster told; // all of it
    private long eventsSent;
    private long eventsTaken;
    private int offersWaited; // since it last took something

    Viewer(Line line) {
        this.line = line;
    }

    /// Sends what is new of the run, as far as the viewer has taken what it was sent before.
    synchronized void offer(Feed feed) {
        if (isWaitedFor() && ++offersWaited > PATIENCE) {
            line.cut();
        } else if (line.isClear()) {
            if (run != feed.number()) {
                begin(feed);
            }
            sendNews(feed);
            sendFrame(feed);
            sendEvents(feed);
        }
    }

    private boolean isWaitedFor() {
        return !line.isClear() || !framesUnderWay.isEmpty() || eventsTaken < eventsSent;
    }

    /// Who and what has come, before the frame that has them.
    private void sendNews(Feed feed) {
        if (robots < feed.robots()) {
            line.send(feed.newcomers(robots));
            robots = feed.robots();
        }
        Roster roster = feed.things();
        if (!roster.equals(told)) {
            Optional<Things> news = roster.news(things);
            news.ifPresent(some -> line.send(Json.write(ServerMessage.of(some))));
            told = news.isPresent() ? null : roster;
        }
    }

    private void sendFrame(Feed feed) {
        if (newestFrame >= feed.sequence() || framesUnderWay.size() == FRAMES) {
            return;
        }
        if (!details.equals(feed.details())) {
            details = feed.details();
            line.send(details);
        }
        newestFrame = feed.sequence();
        framesUnderWay.add(newestFrame);
        line.send(feed.frame());
    }

    private void begin(Feed feed) {
        run = feed.number();
        framesUnderWay.clear();
        newestFrame = 0;
        details = "";
        robots = feed.robots();
        things.clear();
        told = null;
        eventsSent = 0;
        eventsTaken = 0;
        line.send(feed.info());
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
        line.send(Json.write(ServerMessage.of(events)));
    }

    /// The viewer says what it has taken. What it was not sent, it can't have taken.
    synchronized void received(Receipt receipt) {
        boolean taken = receipt.frame()
                .map(frame -> framesUnderWay.removeIf(sent -> sent <= frame))
                .orElse(false);
        long events = Math.clamp(receipt.events().orElse(0L), eventsTaken, eventsSent);
        if (taken || events > eventsTaken) {
            offersWaited = 0;
        }
        eventsTaken = events;
    }
}
