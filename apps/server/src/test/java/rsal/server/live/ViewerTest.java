package rsal.server.live;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;
import rsal.engine.report.RunEvent;
import rsal.server.frame.Feed;
import rsal.server.frame.Moment;
import rsal.server.frame.ObjectRegistry;
import rsal.server.history.Past;
import rsal.server.live.ViewerCounts.Kind;
import rsal.server.live.ViewerCounts.Reason;
import rsal.server.message.Messages.Receipt;
import rsal.server.message.Messages.ThingInfo;

class ViewerTest {
    private final FakeLine line = new FakeLine();
    private final ViewerCounts counts = new ViewerCounts();
    private final Viewer viewer = new Viewer(line, counts);
    private int robots = 2;
    private ObjectRegistry roster = new ObjectRegistry(1, Map.of(), 0);

    @Test
    void isSentEverythingWhenItComes() {
        offer(feed(1, 40, 3));
        assertThat(line.takeAll()).containsExactly("run 1", "details of 40", "frame 40", "events 1-3");
    }

    @Test
    void hasAtMostTwoFramesUnderWay() {
        for (long frame = 1; frame <= 10; frame++) {
            offer(feed(1, frame, 0));
        }
        assertThat(line.takeAll())
                .filteredOn(message -> message.startsWith("frame"))
                .containsExactly("frame 1", "frame 2");
    }

    @Test
    void getsTheNewestFrameAsSoonAsItHasTakenOne() {
        offer(feed(1, 1, 0));
        offer(feed(1, 2, 0));
        offer(feed(1, 3, 0));
        line.takeAll();
        viewer.received(frame(1));
        offer(feed(1, 9, 0));
        assertThat(line.takeAll()).containsExactly("details of 9 since 2", "frame 9");
    }

    @Test
    void getsNoFrameTwice() {
        offer(feed(1, 1, 0));
        line.takeAll();
        viewer.received(frame(1));
        offer(feed(1, 1, 0));
        assertThat(line.takeAll()).isEmpty();
    }

    @Test
    void missesNoEventHoweverSlowItIs() {
        int all = 2 * Viewer.EVENTS + 1;
        offer(feed(1, 1, 1));
        for (int i = 0; i < 5; i++) {
            offer(feed(1, 1, all)); // it has not taken the first yet
        }
        viewer.received(events(1));
        offer(feed(1, 1, all));
        viewer.received(events(501));
        offer(feed(1, 1, all));
        viewer.received(events(1001));
        offer(feed(1, 1, all));
        assertThat(line.takeAll())
                .filteredOn(message -> message.startsWith("events"))
                .containsExactly("events 1-1", "events 2-501", "events 502-1001");
    }

    @Test
    void isCountedWithWhatItWasSentAndWhatNot() {
        offer(feed(1, 1, 3));
        offer(feed(1, 2, 3));
        offer(feed(1, 5, 3)); // two are under way
        assertThat(counts.skippedFrames()).isZero();
        viewer.received(frame(2));
        offer(feed(1, 9, 3));
        assertThat(counts.skippedFrames()).isEqualTo(9 - 2 - 1);
        assertThat(counts.messages(Kind.FRAME)).isEqualTo(3);
        assertThat(counts.bytes(Kind.FRAME)).isEqualTo(3);
        assertThat(counts.messages(Kind.RUN)).isEqualTo(1);
        assertThat(counts.bytes(Kind.RUN)).isEqualTo("run 1".length());
        assertThat(counts.messages(Kind.EVENTS)).isEqualTo(1);
        offer(feed(2, 4, 0)); // counted anew
        assertThat(counts.skippedFrames()).isEqualTo(6);
    }

    @Test
    void isShownAnotherRunFromItsBeginning() {
        offer(feed(1, 70, 2));
        line.takeAll();
        offer(feed(2, 1, 1));
        assertThat(line.takeAll()).containsExactly("run 2", "details of 1", "frame 1", "events 1-1");
    }

    @Test
    void isSentNothingWhileItsLineIsBusyWhateverItClaims() {
        offer(feed(1, 1, 1));
        line.takeAll();
        line.clear = false;
        viewer.received(frame(Long.MAX_VALUE));
        viewer.received(events(Long.MAX_VALUE));
        offer(feed(2, 2, 9));
        assertThat(line.takeAll()).isEmpty();
    }

    @Test
    void isLetGoWhenItTakesNothingForTooLong() {
        for (int i = 0; i <= Viewer.PATIENCE; i++) {
            viewer.received(frame(0)); // says something, but takes nothing
            offer(feed(1, 1, 0));
            assertThat(line.cut).isFalse();
        }
        assertThat(counts.gone(Reason.SILENT)).isZero();
        offer(feed(1, 1, 0));
        assertThat(line.cut).isTrue();
        offer(feed(1, 1, 0)); // its connection has yet to end
        assertThat(counts.gone(Reason.SILENT)).isEqualTo(1);
    }

    @Test
    void isKeptAsLongAsItTakesSomethingNowAndThen() {
        for (long frame = 1; frame <= 3L * Viewer.PATIENCE; frame++) {
            offer(feed(1, frame, 0));
            if (frame % 100 == 0) {
                viewer.received(frame(frame));
            }
        }
        assertThat(line.cut).isFalse();
    }

    @Test
    void isKeptWhenThereIsNothingNewForIt() {
        offer(feed(1, 1, 0));
        viewer.received(frame(1));
        for (int i = 0; i < 2 * Viewer.PATIENCE; i++) {
            offer(feed(1, 1, 0));
        }
        assertThat(line.cut).isFalse();
    }

    @Test
    void isInformedWhoHasComeBeforeTheFrameThatHasThem() {
        offer(feed(1, 1, 0));
        line.takeAll();
        robots = 5;
        offer(feed(1, 2, 0));
        offer(feed(1, 2, 0));
        assertThat(line.takeAll()).containsExactly("robots from 2", "details of 2 since 1", "frame 2");
        offer(feed(2, 1, 0));
        assertThat(line.takeAll()).containsExactly("run 2", "details of 1", "frame 1");
    }

    @Test
    void isInformedOfEachThingOnceAndOfEachThatGoes() {
        roster = things(1, 2, 3);
        offer(feed(1, 1, 0));
        assertThat(line.takeAll()).containsExactly("run 1", "things +[1, 2, 3] -[]", "details of 1", "frame 1");
        roster = things(2, 4);
        offer(feed(1, 1, 0));
        offer(feed(1, 1, 0));
        assertThat(line.takeAll()).containsExactly("things +[4] -[1, 3]");
        offer(feed(2, 1, 0));
        assertThat(line.takeAll()).contains("things +[2, 4] -[]");
    }

    @Test
    void isInformedOfManyThingsLittleByLittle() {
        roster = things(IntStream.rangeClosed(1, 2 * ObjectRegistry.BATCH + 1).toArray());
        for (int offers = 0; offers < 5; offers++) {
            offer(feed(1, 1, 0));
        }
        assertThat(line.takeAll())
                .filteredOn(message -> message.startsWith("things"))
                .hasSize(3);
    }

    @Test
    void isInformedHowFarItCanLookBackAlongWithAFrame() {
        for (int offer = 1; offer <= 40; offer++) {
            int frame = 1 + (offer - 1) / 5; // of a run that goes by too fast for more
            viewer.offer(feed(1, frame, 0), past(offer), Duration.ZERO);
            viewer.received(frame(frame));
            List<String> sent = line.takeAll();
            assertThat(sent.stream().anyMatch(message -> message.startsWith("{\"reach\"")))
                    .as("offer %d: %s", offer, sent)
                    .isEqualTo(sent.contains("frame " + frame));
        }
    }

    @Test
    void isInformedHowFarItCanLookBackEvenWhereNoFrameComes() {
        viewer.offer(feed(1, 1, 0), past(1), Duration.ZERO);
        line.takeAll();
        for (int offer = 1; offer <= 40; offer++) {
            viewer.offer(feed(1, 1, 0), past(2), Duration.ZERO);
        }
        assertThat(line.takeAll()).singleElement().asString().contains("\"until\":2.0");
    }

    /// Of a run of which nothing is told but what is new now.
    private void offer(Feed feed) {
        viewer.offer(feed, past(0, 0), Duration.ZERO);
    }

    private static Past past(int seconds) {
        return past(1, seconds);
    }

    private static Past past(int run, int seconds) {
        return new Past() {
            @Override
            public int number() {
                return run;
            }

            @Override
            public String info() {
                throw new UnsupportedOperationException();
            }

            @Override
            public int robots() {
                throw new UnsupportedOperationException();
            }

            @Override
            public String newcomers(int known) {
                throw new UnsupportedOperationException();
            }

            @Override
            public Duration from() {
                return Duration.ZERO;
            }

            @Override
            public Duration until() {
                return Duration.ofSeconds(seconds);
            }

            @Override
            public boolean isRecording() {
                return false;
            }

            @Override
            public Moment at(Duration time) {
                throw new UnsupportedOperationException();
            }

            @Override
            public Duration near(Duration time, int after) {
                throw new UnsupportedOperationException();
            }

            @Override
            public List<RunEvent> events(long sequence) {
                throw new UnsupportedOperationException();
            }
        };
    }

    private static ObjectRegistry things(int... numbers) {
        var all = new LinkedHashMap<Integer, ThingInfo>();
        for (int number : numbers) {
            all.put(number, new ThingInfo(number, "thing", 0, 0, 0, 0, List.of()));
        }
        return new ObjectRegistry(1, all, 0);
    }

    private static Receipt frame(long sequence) {
        return new Receipt(Optional.of(sequence), Optional.empty(), Optional.empty(), Optional.empty());
    }

    private static Receipt events(long sequence) {
        return new Receipt(Optional.empty(), Optional.of(sequence), Optional.empty(), Optional.empty());
    }

    private Feed feed(int run, long frame, int events) {
        return new Feed() {
            @Override
            public int number() {
                return run;
            }

            @Override
            public String info() {
                return "run " + run;
            }

            @Override
            public int robots() {
                return robots;
            }

            @Override
            public String newcomers(int known) {
                return "robots from " + known;
            }

            @Override
            public ObjectRegistry things() {
                return roster;
            }

            @Override
            public long detailsVersion() {
                return frame;
            }

            @Override
            public String details(long known) {
                return "details of " + frame + (known == 0 ? "" : " since " + known);
            }

            @Override
            public byte[] frame() {
                return new byte[] {(byte) frame};
            }

            @Override
            public long sequence() {
                return frame;
            }

            @Override
            public List<RunEvent> events(long sequence) {
                return LongStream.rangeClosed(sequence + 1, events)
                        .mapToObj(i -> new RunEvent(i, Duration.ZERO, "agent", "", "", Optional.empty()))
                        .toList();
            }
        };
    }

    /// Notes what is sent: frames by their only byte, events by their range.
    private static final class FakeLine implements Viewer.Line {
        private final List<String> sent = new ArrayList<>();
        private boolean clear = true;
        private boolean cut;

        @Override
        public void send(String text) {
            if (text.startsWith("{\"events\"")) {
                List<String> sequences = java.util.regex.Pattern.compile("\"sequence\":(\\d+)")
                        .matcher(text)
                        .results()
                        .map(match -> match.group(1))
                        .toList();
                sent.add("events " + sequences.getFirst() + "-" + sequences.getLast());
            } else if (text.startsWith("{\"things\"")) {
                List<Integer> came = java.util.regex.Pattern.compile("\"number\":(\\d+)")
                        .matcher(text)
                        .results()
                        .map(match -> Integer.valueOf(match.group(1)))
                        .toList();
                String gone = text.replaceAll(".*\"gone\":(\\[[^]]*]).*", "$1").replace(",", ", ");
                sent.add("things +" + came + " -" + gone);
            } else {
                sent.add(text);
            }
        }

        @Override
        public void send(byte[] bytes) {
            sent.add("frame " + bytes[0]);
        }

        @Override
        public boolean isClear() {
            return clear;
        }

        @Override
        public void cut() {
            cut = true;
        }

        List<String> takeAll() {
            var all = List.copyOf(sent);
            sent.clear();
            return all;
        }
    }
}
