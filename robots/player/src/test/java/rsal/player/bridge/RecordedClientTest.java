package rsal.player.bridge;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedInputStream;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import rsal.device.Navigator.Tolerance;
import rsal.player.Recorded;
import rsal.player.message.Protocol;
import rsal.player.wire.Header;
import rsal.player.wire.MessageKind;
import rsal.player.wire.Packet;
import rsal.scene.RobotService;
import rsal.settings.Location;
import rsal.sim.SimProvider;
import rsal.system.RobotSystemProvider;

/// A client that once talked to a real server, and now says the same to us: it gets the same answers, as far
/// as kind and shape go. The robots differ.
@Timeout(60)
class RecordedClientTest extends BridgeBench {
    private static final String ROBOT_THEN = "r0\0";
    private static final String ROBOT_NOW = "r1\0";

    @Override
    protected RobotSystemProvider provider() {
        return new SimProvider();
    }

    /// What the real server offered.
    @Override
    List<RobotService> services() {
        return List.of(
                service("stage", Map.of("simulation:0", RobotService.SIMULATION, "position2d:0", "base")),
                service("stage", Map.of("ranger:0", "sonar", "ranger:1", "laser")),
                service("rangertolaser", Map.of("laser:0", "laser")));
    }

    private static RobotService service(String driver, Map<String, String> sources) {
        return new RobotService(
                driver,
                Location.of("test.cfg"),
                6665,
                sources.keySet().stream().sorted().toList(),
                List.of(),
                Optional.of("r1"),
                sources,
                List.of(),
                new Tolerance(0.1, 0.1),
                Optional.empty());
    }

    @Test
    void getsTheAnswersThatItGotThen() throws Exception {
        BlockingQueue<Packet> answers = new LinkedBlockingQueue<>();
        int asked = 0;
        try (var socket = new Socket(InetAddress.getLoopbackAddress(), port())) {
            var in = new BufferedInputStream(socket.getInputStream());
            assertThat(new String(in.readNBytes(32), StandardCharsets.US_ASCII)).startsWith("Player v.3.1");
            Thread.ofVirtual().start(() -> listen(in, answers));
            for (Recorded.Message message : Recorded.session("simple")) {
                Packet packet = packet(message.bytes());
                if (message.sent()) {
                    socket.getOutputStream().write(withOurRobot(message.bytes()));
                } else if (packet.header().kind() == MessageKind.ACK
                        || packet.header().kind() == MessageKind.NACK) {
                    until(() -> !answers.isEmpty());
                    isLike(answers.remove(), packet);
                    asked++;
                }
            }
            assertThat(asked).isEqualTo(20);
            until(() -> truth().x() > START.x() + 0.5); // as its last word was a velocity
        }
    }

    private static void listen(BufferedInputStream in, BlockingQueue<Packet> answers) {
        try {
            for (Optional<Packet> next = Packet.read(in); next.isPresent(); next = Packet.read(in)) {
                MessageKind kind = next.get().header().kind();
                if (kind == MessageKind.ACK || kind == MessageKind.NACK) {
                    answers.add(next.get());
                }
            }
        } catch (IOException _) {
            // it has hung up
        }
    }

    private static void isLike(Packet now, Packet then) throws IOException {
        Header header = now.header();
        assertThat(header.kind())
                .as("%s", then.header())
                .isEqualTo(then.header().kind());
        assertThat(header.address().interf()).isEqualTo(then.header().address().interf());
        assertThat(header.address().index()).isEqualTo(then.header().address().index());
        assertThat(header.subtype()).isEqualTo(then.header().subtype());
        assertThat(header.sequence()).isEqualTo(then.header().sequence());
        assertThat(Protocol.V3_1.read(now).map(Record::getClass))
                .isEqualTo(Protocol.V3_1.read(then).map(Record::getClass));
    }

    private static Packet packet(byte[] bytes) throws IOException {
        return Packet.read(new ByteArrayInputStream(bytes)).orElseThrow();
    }

    private static byte[] withOurRobot(byte[] bytes) {
        return new String(bytes, StandardCharsets.ISO_8859_1)
                .replace(ROBOT_THEN, ROBOT_NOW)
                .getBytes(StandardCharsets.ISO_8859_1);
    }
}
