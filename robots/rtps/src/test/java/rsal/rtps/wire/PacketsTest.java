package rsal.rtps.wire;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.StreamSupport;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rsal.rtps.wire.Submessage.AckNack;
import rsal.rtps.wire.Submessage.Data;
import rsal.rtps.wire.Submessage.DataFragments;
import rsal.rtps.wire.Submessage.Gap;
import rsal.rtps.wire.Submessage.Heartbeat;
import rsal.rtps.wire.Submessage.NackFragments;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/// Packets that Cyclone DDS 11.0.1 and Fast DDS 2.9.1 sent, with what another program read in them.
public class PacketsTest {
    /// Kinds that the reader hands on.
    private static final List<String> HANDED_ON =
            List.of("ACKNACK", "HEARTBEAT", "GAP", "DATA", "DATA_FRAG", "NACK_FRAG");

    /// @param submessages as the other program read them
    public record Packet(String name, byte[] bytes, JsonNode submessages) {
        @Override
        public String toString() {
            return name;
        }
    }

    public static JsonNode all() {
        try (var in = Objects.requireNonNull(PacketsTest.class.getResourceAsStream("/packets.json"))) {
            return JsonMapper.shared().readTree(in);
        } catch (IOException e) {
            throw new AssertionError(e);
        }
    }

    public static List<Packet> packets() {
        return StreamSupport.stream(all().get("rtps").spliterator(), false)
                .map(each -> new Packet(
                        each.get("name").asString(),
                        HexFormat.of().parseHex(each.get("hex").asString()),
                        each.get("submessages")))
                .toList();
    }

    @ParameterizedTest
    @MethodSource("packets")
    void areReadAsOthersReadThem(Packet packet) throws Exception {
        var read = new ArrayList<Submessage>();
        MessageReader.read(ByteBuffer.wrap(packet.bytes()), (_, submessage) -> read.add(submessage));
        List<JsonNode> expected = expected(packet);
        assertThat(read).hasSameSizeAs(expected);
        for (int i = 0; i < read.size(); i++) {
            assertSame(read.get(i), expected.get(i), packet.bytes());
        }
    }

    private static List<JsonNode> expected(Packet packet) {
        return StreamSupport.stream(packet.submessages().spliterator(), false)
                .filter(each -> HANDED_ON.contains(each.get("kind").asString()))
                .toList();
    }

    private static void assertSame(Submessage read, JsonNode expected, byte[] bytes) {
        switch (read) {
            case AckNack answer -> {
                assertThat(answer.missing().base())
                        .isEqualTo(expected.get("base").asLong());
                assertThat(answer.missing().numbers().toArray()).isEqualTo(longs(expected.get("missing")));
                assertThat(answer.count()).isEqualTo(expected.get("count").asInt());
                assertThat(answer.isFinal()).isEqualTo(expected.get("final").asBoolean());
            }
            case Heartbeat heartbeat -> {
                assertThat(heartbeat.first()).isEqualTo(expected.get("first").asLong());
                assertThat(heartbeat.last()).isEqualTo(expected.get("last").asLong());
                assertThat(heartbeat.count()).isEqualTo(expected.get("count").asInt());
                assertThat(heartbeat.isFinal()).isEqualTo(expected.get("final").asBoolean());
            }
            case Gap gap -> {
                assertThat(gap.start()).isEqualTo(expected.get("gapStart").asLong());
                assertThat(gap.more().base()).isEqualTo(expected.get("listBase").asLong());
                assertThat(gap.more().numbers().toArray()).isEqualTo(longs(expected.get("listed")));
            }
            case NackFragments nack -> {
                assertThat(nack.number()).isEqualTo(expected.get("seq").asLong());
                assertThat(nack.missing().numbers().toArray()).isEqualTo(longs(expected.get("missing")));
            }
            case Data data -> {
                assertThat(data.number()).isEqualTo(expected.get("seq").asLong());
                if (expected.has("payloadOffset")) {
                    int at = expected.get("payloadOffset").asInt();
                    int length = expected.get("payloadLength").asInt();
                    assertThat(data.payload()).isEqualTo(ByteBuffer.wrap(Arrays.copyOfRange(bytes, at, at + length)));
                }
            }
            case DataFragments part -> {
                assertThat(part.number()).isEqualTo(expected.get("seq").asLong());
                assertThat(part.first())
                        .isEqualTo(expected.get("fragmentStartingNum").asInt());
                assertThat(part.count())
                        .isEqualTo(expected.get("fragmentsInSubmessage").asInt());
                assertThat(part.fragmentSize())
                        .isEqualTo(expected.get("fragmentSize").asInt());
                assertThat(part.sampleSize())
                        .isEqualTo(expected.get("sampleSize").asInt());
            }
        }
    }

    private static long[] longs(JsonNode numbers) {
        return StreamSupport.stream(numbers.spliterator(), false)
                .mapToLong(JsonNode::asLong)
                .toArray();
    }

    @ParameterizedTest
    @MethodSource("packets")
    void areWrittenByteByByteAsOthersWriteThem(Packet packet) throws Exception {
        var read = new ArrayList<Submessage>();
        MessageReader.read(ByteBuffer.wrap(packet.bytes()), (_, submessage) -> read.add(submessage));
        List<JsonNode> expected = expected(packet);
        for (int i = 0; i < read.size(); i++) {
            var writer = new MessageWriter(new GuidPrefix(0, 0)).begin(GuidPrefix.UNKNOWN);
            switch (read.get(i)) {
                case AckNack answer -> writer.ackNack(answer);
                case Heartbeat heartbeat -> writer.heartbeat(heartbeat);
                case Gap gap -> writer.gap(gap);
                case NackFragments nack -> writer.nackFragments(nack);
                case Data data -> {
                    if (!data.inlineQos().isEmpty() || data.content() != Submessage.Content.DATA) {
                        continue;
                    }
                    writer.data(
                            data.reader(),
                            data.writer(),
                            data.number(),
                            Optional.empty(),
                            data.content(),
                            bytes(data.payload()));
                }
                case DataFragments _ -> {
                    continue; // its payload is a part of the sample only
                }
            }
            int at = expected.get(i).get("offset").asInt();
            int length = 4 + expected.get(i).get("length").asInt();
            ByteBuffer written = writer.message().position(MessageReader.HEADER);
            assertThat(HexFormat.of().formatHex(bytes(written)))
                    .isEqualTo(HexFormat.of().formatHex(packet.bytes(), at, at + length));
        }
    }

    private static byte[] bytes(ByteBuffer buffer) {
        var bytes = new byte[buffer.remaining()];
        buffer.duplicate().get(bytes);
        return bytes;
    }

    @ParameterizedTest
    @MethodSource("packets")
    void parametersAreWrittenAsTheyWereRead(Packet packet) throws Exception {
        var lists = new ArrayList<ByteBuffer>();
        MessageReader.read(ByteBuffer.wrap(packet.bytes()), (_, submessage) -> {
            if (submessage instanceof Data data
                    && data.payload().remaining() > 4
                    && data.payload().getShort(0) == 3) { // PL_CDR_LE
                lists.add(data.payload().position(4).slice().order(ByteOrder.LITTLE_ENDIAN));
            }
        });
        for (ByteBuffer list : lists) {
            int id = list.getShort(0) & 0xffff;
            ByteBuffer value = ParameterList.read(list.duplicate().order(list.order()))
                    .find(id, 0)
                    .orElseThrow();
            var again = ByteBuffer.allocate(1_000).order(ByteOrder.LITTLE_ENDIAN);
            new ParameterList.Writer(again).put(id, to -> to.put(value.duplicate()));
            assertThat(again.flip()).isEqualTo(list.slice(0, 4 + value.limit()));
        }
    }
}
