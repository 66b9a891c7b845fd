package rsal.rtps;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import rsal.rtps.SimulatedNetwork.Node;
import rsal.rtps.discovery.Qos;
import rsal.rtps.wire.PacketsTest;
import rsal.testkit.Rounds;

/// Whatever arrives, a participant goes on, keeps within its limits, and serves the others.
class FuzzTest {
    private static final InetSocketAddress STRANGER = new InetSocketAddress("10.9.9.9", 7410);

    @Test
    void damagedPacketsDisturbNobody() {
        var random = new SplittableRandom(1);
        List<byte[]> packets =
                PacketsTest.packets().stream().map(PacketsTest.Packet::bytes).toList();
        var network = new SimulatedNetwork(1, 0);
        Node talker = network.join();
        Node listener = network.join();
        var heard = new ArrayList<Long>();
        SampleWriter writer = talker.participant.createWriter("rt/chatter", "T", Qos.DEFAULT, "", network.now());
        listener.participant.createReader(
                "rt/chatter", "T", Qos.DEFAULT, "", sample -> heard.add(sample.number()), network.now());
        network.run(Duration.ofSeconds(1));
        int rounds = Rounds.of(20_000, 1_000_000);
        for (int i = 0; i < rounds; i++) {
            byte[] packet = damaged(packets.get(random.nextInt(packets.size())), random);
            if (random.nextInt(3) == 0 && packet.length >= 20) { // as if somebody we know had sent it
                byte[] known = prefix(random.nextBoolean() ? talker : listener);
                System.arraycopy(known, 0, packet, 8, known.length);
            }
            network.inject(listener, packet, STRANGER);
            if (i % 100 == 0) {
                network.run(Duration.ofMillis(10));
            }
        }
        assertThat(listener.participant.malformed()).isPositive();
        assertThat(listener.participant.participants().size()).isLessThanOrEqualTo(512);
        Node fresh = network.join();
        var late = new ArrayList<Long>();
        fresh.participant.createReader(
                "rt/chatter", "T", Qos.DEFAULT, "", sample -> late.add(sample.number()), network.now());
        network.run(Duration.ofSeconds(5));
        talker.write(writer, new byte[100]);
        network.run(Duration.ofSeconds(5));
        assertThat(late).hasSize(1);
    }

    private static byte[] prefix(Node node) {
        var prefix = node.participant.self().prefix();
        return ByteBuffer.allocate(12)
                .putLong(prefix.high())
                .putInt(prefix.low())
                .array();
    }

    private static byte[] damaged(byte[] packet, SplittableRandom random) {
        byte[] bytes = Arrays.copyOf(packet, random.nextInt(4) == 0 ? random.nextInt(packet.length) : packet.length);
        IntStream.range(0, random.nextInt(4)).forEach(_ -> {
            if (bytes.length > 0) {
                int at = random.nextInt(bytes.length);
                bytes[at] =
                        random.nextBoolean() ? (byte) random.nextInt(256) : (byte) (random.nextBoolean() ? 0xff : 0);
            }
        });
        return bytes;
    }

    /// Each packet as if another participant had sent it.
    @Test
    void floodsOfParticipantsAreBounded() {
        var network = new SimulatedNetwork(2, 0);
        Node node = network.join();
        byte[] announcement = PacketsTest.packets().getFirst().bytes();
        byte[] own = Arrays.copyOfRange(announcement, 8, 20);
        for (int i = 0; i < 5_000; i++) {
            byte[] bytes = announcement.clone();
            for (int at = 0; at + 12 <= bytes.length; at++) {
                if (Arrays.equals(bytes, at, at + 12, own, 0, 12)) {
                    bytes[at + 10] = (byte) i;
                    bytes[at + 11] = (byte) (i >> 8);
                }
            }
            setDomain(bytes, 79, 0);
            network.inject(node, bytes, STRANGER);
        }
        assertThat(node.participant.participants()).hasSize(512);
        assertThat(node.participant.surplus()).isPositive();
        network.run(Duration.ofSeconds(60)); // they never came again
        assertThat(node.participant.participants()).isEmpty();
    }

    private static void setDomain(byte[] bytes, int from, int to) {
        for (int at = 0; at + 8 <= bytes.length; at++) { // parameter 0x000f of four bytes
            if (bytes[at] == 0x0f && bytes[at + 1] == 0 && bytes[at + 2] == 4 && bytes[at + 4] == from) {
                bytes[at + 4] = (byte) to;
            }
        }
    }
}
