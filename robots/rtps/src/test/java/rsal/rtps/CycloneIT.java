package rsal.rtps;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.util.HexFormat;
import java.util.List;
import java.util.Objects;
import java.util.SplittableRandom;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.FutureTask;
import java.util.stream.IntStream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.rtps.discovery.Qos;
import rsal.testkit.OfficialPython;

/// With Cyclone DDS by its Python package, both ways, over real sockets on the loopback network.
class CycloneIT {
    private static final String TEXT = "std_msgs::msg::dds_::String_";
    private static final int COUNT = 300;
    private static final int LONG = 1_500_000; // B; in fragments
    private static final Qos ALL = Qos.DEFAULT.keep(Qos.KEEP_ALL);

    @ParameterizedTest
    @ValueSource(strings = {"multicast", "unicast"})
    void exchangesAllSamplesBothWays(String discovery) throws Exception {
        int domain = 1 + (int) (ProcessHandle.current().pid() % 100); // no other test's
        var heard = new CopyOnWriteArrayList<String>();
        var heardLong = new CopyOnWriteArrayList<String>();
        var peer = new FutureTask<>(() -> OfficialPython.run(
                script(), Integer.toString(domain), discovery, Integer.toString(COUNT), Integer.toString(LONG)));
        try (var participant = new UdpParticipant(
                UdpParticipant.Options.local(domain, "test"),
                System::nanoTime,
                new SplittableRandom(),
                GraphListener.NONE)) {
            participant.createReader("rt/peer/text", TEXT, ALL, "", sample -> heard.add(text(sample.payload())));
            participant.createReader(
                    "rt/peer/long", TEXT, Qos.LATCHED, "", sample -> heardLong.add(text(sample.payload())));
            SampleWriter writer = participant.createWriter("rt/rsal/text", TEXT, ALL, "");
            SampleWriter latched = participant.createWriter("rt/rsal/long", TEXT, Qos.LATCHED, "");
            participant.write(latched, 0, payload("r".repeat(LONG)));
            Thread.ofPlatform().start(peer);
            while (participant.matched(writer) == 0 && !peer.isDone()) {
                Thread.sleep(10);
            }
            for (int i = 0; i < COUNT; i++) {
                participant.write(writer, 0, payload("rsal " + i));
            }

            List<String> lines = peer.get().lines().toList();

            assertThat(lines).contains("texts %d True".formatted(COUNT), "long " + sha256("r".repeat(LONG)));
            assertThat(heard)
                    .isEqualTo(
                            IntStream.range(0, COUNT).mapToObj(i -> "peer " + i).toList());
            assertThat(heardLong.stream().map(CycloneIT::sha256)).containsExactly(sha256("p".repeat(LONG)));
        }
    }

    private static String script() throws IOException {
        try (var in = Objects.requireNonNull(CycloneIT.class.getResourceAsStream("/cyclone_peer.py"))) {
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        }
    }

    private static byte[] payload(String text) {
        byte[] utf8 = text.getBytes(StandardCharsets.UTF_8);
        return ByteBuffer.allocate(4 + 4 + utf8.length + 1)
                .put(new byte[] {0, 1, 0, 0})
                .order(ByteOrder.LITTLE_ENDIAN)
                .putInt(utf8.length + 1)
                .put(utf8)
                .array();
    }

    private static String text(ByteBuffer payload) {
        ByteBuffer bytes = payload.slice().order(ByteOrder.LITTLE_ENDIAN).position(4);
        var utf8 = new byte[bytes.getInt() - 1];
        bytes.get(utf8);
        return new String(utf8, StandardCharsets.UTF_8);
    }

    private static String sha256(String text) {
        try {
            return HexFormat.of()
                    .formatHex(MessageDigest.getInstance("SHA-256").digest(text.getBytes(StandardCharsets.UTF_8)));
        } catch (java.security.NoSuchAlgorithmException e) {
            throw new AssertionError(e);
        }
    }
}
