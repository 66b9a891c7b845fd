package rsal.foxglove;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import rsal.engine.LiveRun;
import rsal.recording.Backlog;
import rsal.recording.Backlog.Behind;
import rsal.recording.Backlog.Entry;
import rsal.scenario.RunOptions;
import rsal.scenario.RunPlan;
import rsal.scenario.Scenario;

class ClientTest {
    private final Tap line = new Tap();

    @Test
    void isSentAllOnceMoreAfterItHasTakenWhatWasUnderWay() throws Exception {
        RunPlan plan = Scenario.load("hunt-and-prey")
                .plan(RunOptions.NONE.withSpeed(Double.POSITIVE_INFINITY).withLimit(Duration.ofSeconds(5)));
        List<Entry> entries = entries(plan);
        List<Entry> states =
                entries.stream().filter(entry -> entry.seen().isPresent()).toList();
        assertThat(states).hasSizeGreaterThan(10);
        var client = new Client(line, 0, plan.map());

        client.welcome(states.getFirst());
        assertThat(line.texts).anyMatch(text -> text.contains("\"/map\""));
        assertThat(client.subscribe(1, 2)).isTrue();
        assertThat(client.subscribe(1, 3)).isFalse(); // in use
        assertThat(client.subscribe(2, 2)).isFalse(); // wanted already
        assertThat(client.subscribe(2, 10_000)).isFalse(); // no such channel
        client.welcome(states.getFirst());
        long once = line.of(1);
        assertThat(once).isPositive();

        line.isStuck = true;
        long before = line.sent;
        for (int i = 0; i < 100; i++) {
            for (Entry entry : entries) {
                client.write(entry);
                client.welcome(states.getLast());
            }
        }
        assertThat(line.sent - before).isZero(); // it is left out

        line.isStuck = false;
        client.welcome(states.getLast());
        assertThat(line.of(1)).isEqualTo(2 * once);
        client.unsubscribe(1);
        assertThat(client.subscribe(5, 2)).isTrue();
    }

    @Test
    void isSentEachEventOnceAlsoThoseThatHappenedBeforeItCameOrWhileItWasLeftOut() throws Exception {
        RunPlan plan = Scenario.load("hunt-and-prey")
                .plan(RunOptions.NONE.withSpeed(Double.POSITIVE_INFINITY).withLimit(Duration.ofSeconds(30)));
        List<Entry> events =
                entries(plan).stream().filter(Entry::isEvent).limit(6).toList();
        assertThat(events).hasSize(6);
        var past = new RecentEvents();
        var client = new Client(line, 0, plan.map());
        client.publishEvents(past);
        assertThat(line.texts).singleElement().asString().contains("\"/events\"", "\"/log\"");

        events.subList(0, 2).forEach(past::add);
        client.publishEvents(past);
        assertThat(client.subscribe(7, 1)).isTrue();
        client.publishEvents(past);
        client.publishEvents(past);
        assertThat(line.of(7)).isEqualTo(2);

        line.isStuck = true;
        events.subList(2, 5).forEach(past::add);
        client.publishEvents(past);
        assertThat(line.of(7)).isEqualTo(2);
        line.isStuck = false;
        client.publishEvents(past);
        assertThat(line.of(7)).isEqualTo(5);

        line.meanwhile = () -> assertThat(client.subscribe(8, 2)).isTrue(); // between an event's two messages
        past.add(events.getLast());
        client.publishEvents(past);
        assertThat(line.of(8)).isZero();
        client.publishEvents(past);
        assertThat(line.of(7)).isEqualTo(6);
        assertThat(line.of(8)).isEqualTo(6);

        client.unsubscribe(7);
        assertThat(client.subscribe(9, 1)).isTrue(); // as if it had come just now
        client.publishEvents(past);
        assertThat(line.of(9)).isEqualTo(6);
        assertThat(line.of(8)).isEqualTo(6);
    }

    @Test
    void onlyTheNewestEventsAreKept() throws Exception {
        Entry event = entries(Scenario.load("hunt-and-prey")
                        .plan(RunOptions.NONE
                                .withSpeed(Double.POSITIVE_INFINITY)
                                .withLimit(Duration.ofSeconds(5))))
                .getFirst();
        var past = new RecentEvents();
        for (int i = 0; i < 3 * RecentEvents.MOST + 7; i++) {
            past.add(event);
        }
        assertThat(past.next()).isEqualTo(3 * RecentEvents.MOST + 7);
        assertThat(past.first()).isEqualTo(2 * RecentEvents.MOST + 7);
        assertThat(past.event(past.first())).isEqualTo(event);
        assertThat(past.event(past.next() - 1)).isEqualTo(event);
    }

    private static List<Entry> entries(RunPlan plan) throws Exception {
        var backlog = new Backlog(Behind.WAIT);
        LiveRun run = LiveRun.of(plan).observer(backlog).start();
        var entries = new ArrayList<Entry>();
        while (!run.result().toCompletableFuture().isDone()) {
            backlog.take().ifPresent(entries::add);
        }
        run.result().toCompletableFuture().get(1, TimeUnit.SECONDS);
        backlog.end();
        while (!backlog.isOver()) {
            backlog.take().ifPresent(entries::add);
        }
        return entries;
    }

    /// Counts what is sent.
    private static final class Tap implements Client.Line {
        private final List<String> texts = new ArrayList<>();
        private final List<Integer> subscriptions = new ArrayList<>();
        private long sent; // [B]
        private boolean isStuck;
        private Runnable meanwhile = () -> {}; // done once, while the next is sent

        @Override
        public void send(String text) {
            texts.add(text);
            sent += text.length();
        }

        @Override
        public void send(ByteBuffer bytes) {
            sent += bytes.remaining();
            if (bytes.get(0) == 1) {
                subscriptions.add(bytes.getInt(1));
                Runnable now = meanwhile;
                meanwhile = () -> {};
                now.run();
            }
        }

        @Override
        public long inProgress() {
            return isStuck ? Client.MOST_IN_PROGRESS + 1 : 0;
        }

        long of(int subscription) {
            return subscriptions.stream().filter(each -> each == subscription).count();
        }
    }
}
