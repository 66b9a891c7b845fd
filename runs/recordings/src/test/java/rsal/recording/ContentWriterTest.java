package rsal.recording;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import rsal.data.Pose2d;
import rsal.engine.report.SentMessage;
import rsal.recording.proto.Descriptors;
import rsal.recording.proto.MessageType;
import rsal.recording.proto.ProtoReader;

class ContentWriterTest {
    private enum Color {
        RED,
        GREEN
    }

    private record Leg(String to, double length) {}

    private record Bid(
            String item,
            double cost,
            int trips,
            boolean firm,
            Color color,
            Pose2d from,
            Optional<Pose2d> maybe,
            List<Leg> legs,
            List<String> tags,
            double[] samples,
            Map<String, Integer> stock,
            Duration within,
            OptionalDouble limit,
            Object anything) {}

    private record Again(Optional<Again> again, int depth) {}

    private record Broken(int number) {
        @Override
        @SuppressWarnings("UnusedMethod") // but by reflection
        public int number() {
            throw new IllegalStateException("out of order");
        }
    }

    /// What came to a sink, by topic, as its readers see it who know nothing of the classes.
    private final Map<String, List<Map<String, Object>>> written = new LinkedHashMap<>();

    private final Encoder encoder = new Encoder(
            new MessageSink() {
                private final List<String> topics = new ArrayList<>();
                private final Map<String, MessageType> types = new HashMap<>();

                @Override
                public int open(String topic, String schema, byte[] descriptors, Map<String, String> about)
                        throws IOException {
                    types.put(topic, Descriptors.read(descriptors, schema).orElseThrow());
                    topics.add(topic);
                    return topics.size() - 1;
                }

                @Override
                public void message(int channel, long time, long taken, ByteBuffer message) throws IOException {
                    String topic = topics.get(channel);
                    written.computeIfAbsent(topic, _ -> new ArrayList<>())
                            .add(ProtoReader.read(types.get(topic), message));
                }
            },
            0);

    private static SentMessage said(String topic, String act) {
        return new SentMessage(
                Duration.ofSeconds(3), "amy", "bob", topic, act.isEmpty() ? "" : "c:1", "", act, "words for people");
    }

    @SuppressWarnings("unchecked")
    private Map<String, Object> content(String topic) {
        return (Map<String, Object>) written.get(topic).getLast().get("content");
    }

    @Test
    void aRecordKeepsItsFields() throws IOException {
        var bid = new Bid(
                "can-3",
                2.5,
                -4,
                true,
                Color.GREEN,
                new Pose2d(1, 2, 0.5),
                Optional.empty(),
                List.of(new Leg("a", 1.5), new Leg("", 0)),
                List.of("x", "", "z"),
                new double[] {0, 1.5},
                Map.of("nuts", 7),
                Duration.ofMillis(1500),
                OptionalDouble.empty(),
                new Object());
        encoder.said(said("bids", ""), bid);
        Map<String, Object> message = written.get("/messages.bids").getLast();
        assertThat(message).containsEntry("from", "amy").containsEntry("to", "bob");
        assertThat(content("/messages.bids"))
                .containsEntry("item", "can-3")
                .containsEntry("cost", 2.5)
                .containsEntry("trips", -4L)
                .containsEntry("firm", true)
                .containsEntry("color", "GREEN")
                .containsEntry("from", Map.of("x", 1.0, "y", 2.0, "theta", 0.5))
                .doesNotContainKey("maybe")
                .containsEntry("legs", List.of(Map.of("to", "a", "length", 1.5), Map.of("to", "", "length", 0.0)))
                .containsEntry("tags", List.of("x", "", "z"))
                .containsEntry("samples", List.of(0.0, 1.5))
                .containsEntry("stock", List.of(Map.of("key", "nuts", "value", "7")))
                .containsEntry("within", 1.5)
                .containsEntry("limit", Double.NaN)
                .containsEntry("anything", ""); // its words differ from run to run
        assertThat(written.get("/messages")).as("as always").hasSize(1);
    }

    @Test
    void actsOfAConversationHaveATopicForEachKindOfContent() throws IOException {
        encoder.said(said("work", "cfp"), new Leg("a", 1));
        encoder.said(said("work", "propose"), new Again(Optional.empty(), 3));
        encoder.said(said("work", "refuse"), "too far");
        assertThat(written).containsOnlyKeys("/messages", "/messages.work.Leg", "/messages.work.Again");
        assertThat(written.get("/messages")).hasSize(3);
        assertThat(written.get("/messages.work.Leg").getLast()).containsEntry("conversation", "c:1");
    }

    @Test
    void aTopicOfSeveralClassesIsSeveralTopics() throws IOException {
        encoder.said(said("news", ""), new Leg("a", 1));
        encoder.said(said("news", ""), new Again(Optional.empty(), 3));
        encoder.said(said("news", ""), new Leg("b", 1));
        assertThat(written.get("/messages.news")).hasSize(2);
        assertThat(written.get("/messages.news.Again")).hasSize(1);
    }

    @Test
    void recordsWithinThemselvesEnd() throws IOException {
        encoder.said(said("again", ""), new Again(Optional.of(new Again(Optional.empty(), 1)), 0));
        assertThat(content("/messages.again"))
                .containsEntry("again", "Again[again=Optional.empty, depth=1]")
                .containsEntry("depth", 0L);
    }

    @Test
    void codeOfTheAuthorThatThrowsHarmsNothing() throws IOException {
        encoder.said(said("broken", ""), new Broken(1));
        encoder.said(said("legs", ""), new Leg("a", 1));
        assertThat(written).containsOnlyKeys("/messages", "/messages.legs");
        assertThat(written.get("/messages")).hasSize(2);
    }

    @Test
    void nonsenseIsNoDescriptor() {
        var random = new SplittableRandom(1);
        for (int i = 0; i < 2000; i++) {
            var bytes = new byte[random.nextInt(60)];
            random.nextBytes(bytes);
            try {
                Descriptors.read(bytes, "rsal.message.X");
            } catch (IOException _) {
                // as it should be
            }
        }
        assertThatThrownBy(() -> Descriptors.read(new byte[] {10, 100, 1}, "rsal.message.X"))
                .isInstanceOf(IOException.class);
    }

    @Test
    void aDescriptorThatContainsItselfEnds() throws IOException {
        MessageType inner = MessageType.named("rsal.message.Self").with(1, "x", MessageType.Kind.DOUBLE);
        MessageType self = MessageType.named("rsal.message.Self").with(1, "self", inner);
        assertThat(Descriptors.read(self.descriptors(), "rsal.message.Self")).isPresent();
        assertThat(Descriptors.read(self.descriptors(), "rsal.message.Other")).isEmpty();
    }
}
