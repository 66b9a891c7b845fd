package rsal.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rsal.testkit.Trials;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/// Does what how-tos say that have people write into `agents/own`.
class OwnFolderIT {
    private static final Path HOW_TO = Path.of("../../docs/how-to");

    @TempDir
    Path folder;

    @Trials(
            value = {
                "own-device",
                "another-robot-system",
                "another-bridge",
                "another-world-format",
                "another-log-format"
            },
            landing = 2)
    void itsCommandsShowWhatItSays(String guide) throws Exception {
        String page = Files.readString(HOW_TO.resolve(guide + ".md"));
        OwnFolder own = OwnFolder.of(page, folder);
        TutorialIT.follow(page, new Rsal(folder, own.classes().toString()));
    }

    /// The how-to's bridge drives a robot, and refuses what it can't read.
    @Test
    void robotsAreDrivenOverABridgeOfOnesOwn() throws Exception {
        OwnFolder own = OwnFolder.of(Files.readString(HOW_TO.resolve("another-bridge.md")), folder);
        Process bridge = new Rsal(folder, own.classes().toString())
                .start("bridge", "text", "teleop", "--no-agents", "--port", "0", "--json");
        try (var reported = bridge.inputReader();
                var client = new DatagramSocket()) {
            JsonNode offer = JsonMapper.shared()
                    .readTree(reported.readLine())
                    .get("offers")
                    .get(0);
            client.connect(InetAddress.getLoopbackAddress(), offer.get("port").asInt());
            client.setSoTimeout(10_000);
            assertThat(ask(client, "robot-9 0.3 0")).startsWith("error: There is no robot 'robot-9', but robot-1");
            assertThat(ask(client, "robot-1 fast 0")).startsWith("error: Write ROBOT FORWARD TURN");
            assertThat(ask(client, "robot-1 NaN 0")).startsWith("error: Write ROBOT FORWARD TURN");
            double begin = x(ask(client, "robot-1 0.3 0"));
            double there = begin;
            for (int line = 0; line < 10_000 && there < begin + 0.2; line++) {
                // up to a hundred lines are answered in a step of 0.1 s
                there = x(ask(client, "robot-1 0.3 0"));
            }
            assertThat(there).isGreaterThan(begin + 0.2);
        } finally {
            Ended.signal("INT", bridge);
            assertThat(bridge.waitFor()).isEqualTo(130);
        }
    }

    private static String ask(DatagramSocket client, String line) throws IOException {
        byte[] bytes = line.getBytes(StandardCharsets.UTF_8);
        client.send(new DatagramPacket(bytes, bytes.length));
        var answer = new DatagramPacket(new byte[200], 200);
        client.receive(answer);
        return new String(answer.getData(), 0, answer.getLength(), StandardCharsets.UTF_8);
    }

    /// Of an answer `ROBOT X Y THETA` [m].
    private static double x(String answer) {
        return Double.parseDouble(answer.split(" ", -1)[1]);
    }
}
