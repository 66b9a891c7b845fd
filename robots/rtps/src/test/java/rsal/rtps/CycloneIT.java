package rsal.rtps;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.Objects;
import java.util.SplittableRandom;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.rtps.discovery.Qos;
import rsal.testkit.OfficialPython;

/// With Cyclone DDS by its Python package, both ways, over real sockets on the loopback network.
class CycloneIT {
    private static final String TEXT = "std_msgs::msg::dds_::String_";
    private static final int COUNT = 300;
    private static final int MANY = 3_000; // texts, more than a writer keeps
    private static final int LONG = 1_500_000; // B; in fragments
    private static final Qos ALL = Qos.DEFAULT.keep(Qos.KEEP_ALL);

    @ParameterizedTest
    @ValueSource(strings = {"multicast", "unicast"})
    void exchangesAllSamplesBothWays(String discovery) throws Exception {
        int domain = 1 + (int) (ProcessHandle.current().pid() % 100); // no other test's
        var heard = new CopyOnWriteArrayList<String>();
        var heardLong = new CopyOnWriteArrayList<String>();
        var peer = new FutureTask<>(() -> OfficialPython.run(
                script("/cyclone_peer.py"),
                Integer.toString(domain),
                discovery,
                Integer.toString(COUNT),
                Integer.toString(LONG)));
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

    /// Takes a text at a time, and has no room for many others meanwhile.
    private static final class Store implements SampleListener {
        private static final int CAPACITY = 10;

        private final BlockingQueue<String> waiting = new ArrayBlockingQueue<>(CAPACITY);

        @Override
        public void onSample(Sample sample) {
            waiting.add(text(sample.payload())); // which fails when it is full
        }

        @Override
        public boolean hasRoom() {
            return waiting.remainingCapacity() > 0;
        }
    }

    /// Cyclone DDS's writer waits for our reader, which takes slowly; our writer waits for its reader, which
    /// takes nothing at first.
    @Test
    void waitsForReadersThatAreSlowBothWays(@TempDir Path folder) throws Exception {
        int domain = 1 + (int) (ProcessHandle.current().pid() % 100); // no other test's
        Path go = folder.resolve("go");
        var store = new Store();
        var peer = new FutureTask<>(() -> OfficialPython.run(
                script("/cyclone_keep_all.py"), Integer.toString(domain), Integer.toString(MANY), go.toString()));
        try (var participant = new UdpParticipant(
                UdpParticipant.Options.local(domain, "test"),
                System::nanoTime,
                new SplittableRandom(),
                GraphListener.NONE)) {
            SampleReader reader = participant.createReader("rt/peer/text", TEXT, ALL, "", store);
            SampleWriter writer = participant.createWriter("rt/rsal/text", TEXT, ALL, "");
            Thread.ofPlatform().start(peer);
            while (participant.matched(writer) == 0 && !peer.isDone()) {
                Thread.sleep(10);
            }
            var heard = new ArrayList<String>();
            for (int i = 0; i < MANY && !peer.isDone(); i++) {
                heard.add(store.waiting.poll(60, TimeUnit.SECONDS));
                participant.resume(reader);
            }
            assertThat(heard)
                    .isEqualTo(
                            IntStream.range(0, MANY).mapToObj(i -> "peer " + i).toList());

            while (!Files.exists(folder.resolve("go.before")) && !peer.isDone()) {
                Thread.sleep(10); // it receives no acknowledgments while its reader is full
            }
            int written = 0;
            while (written < MANY && participant.write(writer, 0, payload("rsal " + written))) {
                written++;
            }
            assertThat(written).isBetween(RtpsLimits.DEFAULT.kept(), MANY - 1); // no more while nothing is taken
            Files.createFile(go);
            while (written < MANY && !peer.isDone()) {
                written += participant.write(writer, 0, payload("rsal " + written)) ? 1 : 0;
            }

            assertThat(peer.get().lines()).contains("texts %d True".formatted(MANY));
        }
    }

    private static String script(String name) throws IOException {
        try (var in = Objects.requireNonNull(CycloneIT.class.getResourceAsStream(name))) {
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
