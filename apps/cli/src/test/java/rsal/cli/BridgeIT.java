package rsal.cli;

import static java.nio.charset.StandardCharsets.US_ASCII;
import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/// `rsal bridge player` as a process of its own, and a client that knows nothing of our classes.
class BridgeIT {
    private static final int DATA = 1;
    private static final int COMMAND = 2;
    private static final int REQUEST = 3;
    private static final int PLAYER = 1;
    private static final int POSITION2D = 4;

    @TempDir
    Path folder;

    /// What has come of the next message of a kind, for a client that pushes.
    private record Message(int interf, int type, int subtype, DataInputStream body) {}

    private static void send(DataOutputStream to, int interf, int type, int subtype, byte[] body) throws IOException {
        for (int number : new int[] {0, 0, interf, 0, type, subtype}) {
            to.writeInt(number);
        }
        to.writeDouble(0);
        to.writeInt(0);
        to.writeInt(body.length);
        to.write(body);
        to.flush();
    }

    private static Message next(DataInputStream from) throws IOException {
        from.skipNBytes(8);
        int interf = from.readInt();
        from.readInt();
        int type = from.readInt();
        int subtype = from.readInt();
        from.skipNBytes(12);
        byte[] body = from.readNBytes(from.readInt());
        return new Message(interf, type, subtype, new DataInputStream(new java.io.ByteArrayInputStream(body)));
    }

    private static byte[] bytes(Writer writer) throws IOException {
        var bytes = new java.io.ByteArrayOutputStream();
        writer.write(new DataOutputStream(bytes));
        return bytes.toByteArray();
    }

    private interface Writer {
        void write(DataOutputStream to) throws IOException;
    }

    @Test
    void aPlayerClientFindsEachRobotAtAPortAndDrivesIt() throws Exception {
        Process process = new Rsal(folder).start("bridge", "player", "teleop", "--port", "0", "--json", "--speed", "4");
        try (BufferedReader out = process.inputReader()) {
            JsonNode told = JsonMapper.shared().readTree(out.readLine());
            Map<Integer, List<String>> names = new LinkedHashMap<>(); // by port
            told.get("offers")
                    .forEach(offer -> names.computeIfAbsent(offer.get("port").asInt(), _ -> new ArrayList<>())
                            .add(offer.get("name").asString()));
            assertThat(names).hasSize(2);
            assertThat(names.values())
                    .allSatisfy(robot -> assertThat(robot)
                            .contains("position2d:0", "laser:0", "ranger:0", "sonar:0")
                            .doesNotContain("position2d:1"));
            int second = List.copyOf(names.keySet()).getLast();
            try (var socket = new Socket(InetAddress.getLoopbackAddress(), second)) {
                socket.setSoTimeout(20_000);
                var from = new DataInputStream(socket.getInputStream());
                var to = new DataOutputStream(socket.getOutputStream());
                assertThat(new String(from.readNBytes(32), US_ASCII)).startsWith("Player v.3.1");
                send(to, PLAYER, REQUEST, 3, bytes(body -> {
                    for (int number : new int[] {0, 0, POSITION2D, 0, 1, 0, 0}) {
                        body.writeInt(number); // subscribe to position2d:0
                    }
                }));
                send(to, POSITION2D, COMMAND, 1, bytes(body -> {
                    body.writeDouble(0);
                    body.writeDouble(0);
                    body.writeDouble(0.5); // turns on the spot
                    body.writeInt(1);
                }));
                assertThat(turned(from)).isTrue();
            }
        } finally {
            Ended.signal("INT", process);
            assertThat(process.waitFor()).isEqualTo(130);
        }
    }

    /// Whether odometry tells of the turn, in the next few hundred messages.
    private static boolean turned(DataInputStream from) throws IOException {
        for (int i = 0; i < 500; i++) {
            Message message = next(from);
            if (message.interf == POSITION2D && message.type == DATA) {
                message.body.skipNBytes(16);
                if (message.body.readDouble() > 0.3) {
                    return true;
                }
            }
        }
        return false;
    }

    @Test
    void whatIsWrongIsToldInASentence() throws Exception {
        Ended unknown = new Rsal(folder).run("bridge", "plaxer");
        assertThat(unknown.code()).isEqualTo(2);
        assertThat(unknown.err()).contains("There is no bridge (plaxer). Maybe (player) was meant?");
        Ended nowhere = new Rsal(folder).run("bridge", "player", "teleop", "--listen", "not an address");
        assertThat(nowhere.code()).isEqualTo(2);
        assertThat(nowhere.err()).contains("(not an address) is no address of a machine");
        try (var taken = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            String port = Integer.toString(taken.getLocalPort());
            Ended inUse = new Rsal(folder).run("bridge", "player", "teleop", "--port", port);
            assertThat(inUse.code()).isEqualTo(5);
            assertThat(inUse.err()).contains("Nobody may listen at (").contains(port);
        }
    }
}
