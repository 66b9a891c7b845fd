package rsal.server.history;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import rsal.engine.report.RunEvent;
import rsal.server.frame.Feed;
import rsal.server.frame.FrameEncoder;
import rsal.server.frame.ObjectRegistry;
import rsal.server.live.PlaybackCursor;
import rsal.server.live.Viewer;
import rsal.server.live.ViewerCounts;
import rsal.server.message.Messages.LookBack;
import rsal.server.message.Messages.MotorsOff;
import rsal.server.message.Messages.Receipt;
import rsal.server.message.Messages.Trail;

class HistoryTest {
    private static final int FRAME_BYTES = 1000;

    private final FakeFeed feed = new FakeFeed();
    private final Times line = new Times();
    private final Viewer viewer = new Viewer(line, new ViewerCounts());

    @Test
    void hasTheNewestMomentByATime() {
        var history = new History(feed);
        for (int tenth = 0; tenth <= 100; tenth++) {
            keep(history, tenth);
        }
        assertThat(history.from()).isEqualTo(Duration.ZERO);
        assertThat(history.until()).isEqualTo(Duration.ofSeconds(10));
        assertThat(history.at(Duration.ofMillis(4_250)).time()).isEqualTo(Duration.ofMillis(4_200));
        assertThat(history.at(Duration.ofMillis(4_200)).details()).isEqualTo("details of 42");
        assertThat(history.at(Duration.ofDays(1)).time()).isEqualTo(Duration.ofSeconds(10));
        assertThat(history.at(Duration.ofDays(-1)).time()).isEqualTo(Duration.ZERO);
        assertThat(history.near(Duration.ofSeconds(4), -1)).isEqualTo(Duration.ofMillis(3_900));
        assertThat(history.near(Duration.ofSeconds(4), Integer.MAX_VALUE)).isEqualTo(Duration.ofSeconds(10));
    }

    @Test
    void keepsNoMomentTwiceAndNoneTooNearTheLastButTheEnd() {
        var history = new History(feed);
        keep(history, 0);
        keep(history, 0);
        history.keep(Duration.ofMillis(30), false);
        assertThat(history.until()).isEqualTo(Duration.ZERO);
        history.keep(Duration.ofMillis(60), true);
        assertThat(history.until()).isEqualTo(Duration.ofMillis(60));
    }

    /// However long a run is, it is all there, ever more coarsely.
    @Test
    void whatItKeepsIsBounded() {
        long most = 100 * FRAME_BYTES;
        var history = new History(feed, most);
        for (int tenth = 0; tenth <= 50_000; tenth++) {
            keep(history, tenth);
        }
        int moments = 0;
        Duration longest = Duration.ZERO;
        Duration before = history.from();
        while (before.compareTo(history.until()) < 0) {
            Duration next = history.near(before, 1);
            Duration gap = next.minus(before);
            longest = gap.compareTo(longest) > 0 ? gap : longest;
            before = next;
            moments++;
        }
        assertThat(history.from()).isEqualTo(Duration.ZERO);
        assertThat(moments).isBetween(40, 100);
        assertThat(longest).isLessThanOrEqualTo(Duration.ofSeconds(125));
        assertThat(history.until()).isGreaterThan(Duration.ofMinutes(80));
    }

    /// As times are told as numbers of seconds, which are not exact.
    @Test
    void eachMomentIsFoundByItsTimeAndSteppedFrom() {
        var history = new History(feed);
        for (int tenth = 0; tenth <= 600; tenth++) {
            keep(history, tenth);
        }
        for (int tenth = 1; tenth < 600; tenth++) {
            double seconds = Duration.ofMillis(100L * tenth).toNanos() / 1e9;
            assertThat(PlaybackCursor.at(history, wish(seconds, 0), Duration.ZERO, 1)
                            .time())
                    .isEqualTo(Duration.ofMillis(100L * tenth));
            assertThat(PlaybackCursor.at(history, wish(seconds, 1), Duration.ZERO, 1)
                            .time())
                    .isEqualTo(Duration.ofMillis(100L * (tenth + 1)));
            assertThat(PlaybackCursor.at(history, wish(seconds, -1), Duration.ZERO, 1)
                            .time())
                    .isEqualTo(Duration.ofMillis(100L * (tenth - 1)));
        }
    }

    private static LookBack wish(double time, int step) {
        return new LookBack(Optional.empty(), Optional.of(time), Optional.of(step), Optional.empty(), Optional.empty());
    }

    @Test
    void aViewerLooksBackAndIsInThePresentAgain() {
        var history = new History(feed);
        keepFiveSeconds(history);
        offer(history);
        assertThat(line.newest()).isEqualTo("5.0 now");
        viewer.received(look(new LookBack(
                Optional.of(false), Optional.of(2.0), Optional.of(0), Optional.of(false), Optional.empty())));
        offer(history);
        assertThat(line.newest()).isEqualTo("2.0 past");
        keep(history, 51); // the run goes on
        offer(history);
        assertThat(line.newest()).isEqualTo("2.0 past");

        viewer.received(look(new LookBack(
                Optional.of(false), Optional.empty(), Optional.of(0), Optional.of(true), Optional.of("10"))));
        offer(history); // there
        offer(history); // and half a second on
        assertThat(line.newest()).isEqualTo("2.5 past");
        viewer.received(look(new LookBack(
                Optional.of(true), Optional.empty(), Optional.of(0), Optional.of(false), Optional.empty())));
        offer(history);
        assertThat(line.newest()).isEqualTo("5.1 now");

        viewer.received(look(new LookBack(
                Optional.of(false), Optional.of(4.9), Optional.of(0), Optional.of(true), Optional.of("100"))));
        offer(history);
        offer(history); // plays up to the present
        assertThat(line.newest()).isEqualTo("5.1 now");
    }

    @Test
    void looksThatComeBetweenTwoOffersAllCount() {
        var history = new History(feed);
        keepFiveSeconds(history);
        var back = new LookBack(
                Optional.of(false), Optional.empty(), Optional.of(-1), Optional.of(false), Optional.empty());
        viewer.received(look(wish(2, 0)));
        viewer.received(look(back));
        viewer.received(look(back));
        offer(history);
        assertThat(line.newest()).isEqualTo("1.8 past");
        viewer.received(look(back));
        viewer.received(look(wish(3, 0)));
        offer(history);
        assertThat(line.newest()).isEqualTo("3.0 past");
        viewer.received(look(new LookBack(
                Optional.of(true), Optional.empty(), Optional.empty(), Optional.empty(), Optional.empty())));
        viewer.received(look(back));
        offer(history);
        assertThat(line.newest()).isEqualTo("4.9 past");
    }

    @Test
    void aRecordingPlaysOnceItIsShown() {
        var history = new History(feed);
        keepFiveSeconds(history);
        for (int i = 0; i < 20; i++) {
            viewer.offer(null, history, Duration.ofMillis(50)); // its page is still loading
        }
        assertThat(line.times).containsExactly("0.0 past");
        viewer.received(new Receipt(Optional.of(1L), Optional.empty(), Optional.empty(), Optional.empty()));
        for (int i = 0; i < 20; i++) {
            viewer.offer(null, history, Duration.ofMillis(50));
            viewer.received(
                    new Receipt(Optional.of(Long.MAX_VALUE), Optional.empty(), Optional.empty(), Optional.empty()));
        }
        assertThat(line.newest()).isEqualTo("1.0 past");
    }

    @Test
    void whoLooksBackIsInformedWhoseMotorsAreOffNow() {
        var history = new History(feed);
        keep(history, 0);
        keep(history, 50);
        viewer.received(look(new LookBack(
                Optional.of(false), Optional.of(0.0), Optional.of(0), Optional.of(false), Optional.empty())));
        offer(history);
        assertThat(line.newestReach()).contains("\"motors\":{\"all\":false,\"of\":[],\"switchedOff\":[]}");
        feed.motorsOff = new MotorsOff(false, List.of("prey-1"), List.of("prey-1"));
        offer(history); // at once, though nothing else is new
        assertThat(line.newest()).isEqualTo("0.0 past");
        assertThat(line.newestReach())
                .contains("\"motors\":{\"all\":false,\"of\":[\"prey-1\"],\"switchedOff\":[\"prey-1\"]}");
    }

    @Test
    void whoLooksBackSeesTheNextRunWhenThatBegins() {
        var history = new History(feed);
        keep(history, 0);
        keep(history, 7);
        viewer.received(look(new LookBack(
                Optional.of(false), Optional.of(0.0), Optional.of(0), Optional.of(false), Optional.empty())));
        offer(history);
        assertThat(line.newest()).isEqualTo("0.0 past");
        feed.number = 2;
        feed.tenth = 1;
        var next = new History(feed);
        keep(next, 1);
        offer(next);
        assertThat(line.newest()).isEqualTo("0.1 now");
    }

    @Test
    void reportsWhereRobotsWentBeforeAMoment() {
        var history = new History(feed);
        assertThat(history.trails(Duration.ofSeconds(9)).robots()).isEmpty();
        for (int tenth = 0; tenth <= 600; tenth++) {
            keep(history, tenth);
        }
        Trail trail = history.trails(Duration.ofSeconds(40)).robots().getFirst();
        assertThat(trail.times()).hasSize(301).startsWith(10.0, 10.1).endsWith(39.9, 40.0);
        assertThat(trail.xs()).startsWith(10.0, 10.1).endsWith(39.9, 40.0);
        assertThat(history.trails(Duration.ofDays(1)).robots().getFirst().times())
                .endsWith(60.0);
        assertThat(history.trails(Duration.ofSeconds(-1)).robots()).isEmpty();
    }

    private void keepFiveSeconds(History history) {
        for (int tenth = 0; tenth <= 50; tenth++) {
            keep(history, tenth);
        }
    }

    private void keep(History history, int tenth) {
        feed.tenth = tenth;
        history.keep(Duration.ofMillis(100L * tenth), false);
    }

    private void offer(History history) {
        viewer.offer(feed, history, Duration.ofMillis(50));
        viewer.received(new Receipt(Optional.of(Long.MAX_VALUE), Optional.empty(), Optional.empty(), Optional.empty()));
    }

    private static Receipt look(LookBack wish) {
        return new Receipt(Optional.empty(), Optional.empty(), Optional.of(wish), Optional.empty());
    }

    private static final class FakeFeed implements Feed {
        private int number = 1;
        private int tenth;
        private MotorsOff motorsOff = MotorsOff.NONE;

        @Override
        public MotorsOff motorsOff() {
            return motorsOff;
        }

        @Override
        public int number() {
            return number;
        }

        @Override
        public String info() {
            return "run";
        }

        @Override
        public int robots() {
            return 0;
        }

        @Override
        public String newcomers(int known) {
            return "";
        }

        @Override
        public ObjectRegistry things() {
            return new ObjectRegistry(number, Map.of(), 0);
        }

        @Override
        public long detailsVersion() {
            return tenth + 1L;
        }

        @Override
        public String details(long known) {
            assertThat(known).as("moments have all details").isZero();
            return "details of " + tenth;
        }

        @Override
        public byte[] frame() {
            return ByteBuffer.allocate(FRAME_BYTES)
                    .order(ByteOrder.LITTLE_ENDIAN)
                    .putDouble(16, tenth / 10.0)
                    .putInt(32, 1) // robot, which goes a metre a second
                    .putInt(FrameEncoder.HEADER_BYTES, 100 * tenth)
                    .putShort(FrameEncoder.HEADER_BYTES + 14, (short) FrameEncoder.PRESENT)
                    .array();
        }

        @Override
        public long sequence() {
            return tenth + 1L;
        }

        @Override
        public List<RunEvent> events(long sequence) {
            return List.of();
        }
    }

    /// Notes of which times it is sent frames, and what else.
    private static final class Times implements Viewer.Line {
        private final List<String> times = new ArrayList<>();
        private final List<String> texts = new ArrayList<>();

        String newest() {
            return times.getLast();
        }

        String newestReach() {
            return texts.stream()
                    .filter(text -> text.startsWith("{\"reach\""))
                    .reduce((_, later) -> later)
                    .orElseThrow();
        }

        @Override
        public void send(String text) {
            texts.add(text);
        }

        @Override
        public void send(byte[] bytes) {
            ByteBuffer frame = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
            boolean past = (frame.getInt(FrameEncoder.FLAGS_AT) & FrameEncoder.PAST) != 0;
            times.add(frame.getDouble(16) + (past ? " past" : " now"));
        }

        @Override
        public boolean isClear() {
            return true;
        }

        @Override
        public void cut() {}
    }
}
