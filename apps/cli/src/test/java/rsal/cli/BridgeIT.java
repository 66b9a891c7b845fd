package rsal.cli;

import static java.nio.charset.StandardCharsets.US_ASCII;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.fail;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.io.BufferedReader;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.zip.InflaterInputStream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import rsal.testkit.LongTest;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/// `rsal bridge player` as a process of its own, and a client that knows nothing of our classes.
class BridgeIT {
    private static final int DATA = 1;
    private static final int COMMAND = 2;
    private static final int REQUEST = 3;
    private static final int SYNCH = 5;
    private static final int PLAYER = 1;
    static final int POSITION2D = 4;

    @TempDir
    Path folder;

    /// What has come of the next message of a kind, for a client that pushes.
    private record Message(int interf, int type, int subtype, double time, DataInputStream body) {}

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
        double time = from.readDouble();
        from.readInt();
        byte[] body = from.readNBytes(from.readInt());
        return new Message(interf, type, subtype, time, new DataInputStream(new java.io.ByteArrayInputStream(body)));
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
    void withAPageItIsServedAndSeen() throws Exception {
        Process process = new Rsal(folder)
                .withPage()
                .start("bridge", "player", "teleop", "--page", "--port", "0", "--json", "--no-agents");
        try (BufferedReader out = process.inputReader();
                BufferedReader err = process.errorReader()) {
            assertThat(err.readLine()).startsWith("Watch it at http://127.0.0.1:");
            JsonNode reported = JsonMapper.shared().readTree(out.readLine());
            int port = reported.get("offers").get(0).get("port").asInt();
            try (var socket = new Socket(InetAddress.getLoopbackAddress(), port)) {
                assertThat(new String(socket.getInputStream().readNBytes(6), US_ASCII))
                        .isEqualTo("Player");
            }
            Ended.signal("INT", process);
            assertThat(process.waitFor()).isEqualTo(130);
        }
    }

    @Test
    void aPlayerClientFindsEachRobotAtAPortAndDrivesIt() throws Exception {
        Process process = new Rsal(folder).start("bridge", "player", "teleop", "--port", "0", "--json", "--speed", "4");
        try (BufferedReader out = process.inputReader()) {
            JsonNode reported = JsonMapper.shared().readTree(out.readLine());
            Map<Integer, List<String>> names = new LinkedHashMap<>(); // by port
            reported.get("offers")
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
                turn(to);
                assertThat(turned(from)).isTrue();
            }
        } finally {
            Ended.signal("INT", process);
            assertThat(process.waitFor()).isEqualTo(130);
        }
    }

    @Test
    @LongTest
    void aRunThatGoesAsFastAsItCanWaitsForWhoPulls() throws Exception {
        Process process =
                new Rsal(folder).start("bridge", "player", "teleop", "--port", "0", "--json", "--speed", "max");
        try (BufferedReader out = process.inputReader()) {
            JsonNode reported = JsonMapper.shared().readTree(out.readLine());
            int port = reported.get("offers").get(0).get("port").asInt();
            try (var socket = new Socket(InetAddress.getLoopbackAddress(), port)) {
                socket.setSoTimeout(20_000);
                var from = new DataInputStream(socket.getInputStream());
                var to = new DataOutputStream(socket.getOutputStream());
                from.skipNBytes(32);
                send(to, PLAYER, REQUEST, 5, bytes(body -> body.writeInt(2))); // pull
                subscribe(to, POSITION2D);
                List<Double> times = new ArrayList<>();
                for (int round = 0; round < 300; round++) {
                    send(to, PLAYER, REQUEST, 4, new byte[0]);
                    times.addAll(timesOfRound(from));
                    Thread.sleep(2); // in which it would go on for seconds
                }
                for (int i = 1; i < times.size(); i++) {
                    assertThat(times.get(i) - times.get(i - 1)).isBetween(0.0, 0.101); // a step of the simulation
                }
            }
        } finally {
            Ended.signal("INT", process);
            assertThat(process.waitFor()).isEqualTo(130);
        }
    }

    @Test
    void clientsOfPlayer30AreServedByAnotherName() throws Exception {
        Process process = new Rsal(folder).start("bridge", "player-3.0", "teleop", "--port", "0", "--json");
        try (BufferedReader out = process.inputReader()) {
            JsonNode reported = JsonMapper.shared().readTree(out.readLine());
            int port = reported.get("offers").get(0).get("port").asInt();
            try (var socket = new Socket(InetAddress.getLoopbackAddress(), port)) {
                assertThat(new String(socket.getInputStream().readNBytes(32), US_ASCII))
                        .startsWith("Player v.3.0");
            }
        } finally {
            Ended.signal("INT", process);
            assertThat(process.waitFor()).isEqualTo(130);
        }
    }

    @Test
    @LongTest
    void serversThatAreNotThereCantBeReached() throws Exception {
        Ended nobody = new Rsal(folder)
                .run(
                        "run",
                        "teleop:real",
                        "--headless",
                        "--arm",
                        "--set",
                        "servers=localhost:1,localhost:2",
                        "--for",
                        "1");
        assertThat(nobody.code()).isEqualTo(5);
        assertThat(nobody.err())
                .contains("There is no Player server at 'localhost:")
                .doesNotContain("went wrong");
    }

    /// When the odometry of a round was measured [s].
    private static List<Double> timesOfRound(DataInputStream from) throws IOException {
        List<Double> times = new ArrayList<>();
        Message message = next(from);
        while (message.type != SYNCH) {
            if (message.type == DATA && message.interf == POSITION2D) {
                times.add(message.time);
            }
            message = next(from);
        }
        return times;
    }

    private static final int SIMULATION = 31;
    private static final int LOCALIZE = 25;
    private static final int MAP = 42;
    private static final int PLANNER = 44;
    private static final int ACK = 4;

    /// A room of 8 m × 6 m with a wall in it, and a robot in a corner.
    private static final String WORLD = """
            define wall model ( color "grey" )
            wall ( name "south" pose [0 -3 0 0] size [8.2 0.2 0.5] )
            wall ( name "north" pose [0 3 0 0] size [8.2 0.2 0.5] )
            wall ( name "west" pose [-4 0 0 0] size [0.2 6 0.5] )
            wall ( name "east" pose [4 0 0 0] size [0.2 6 0.5] )
            wall ( name "between" pose [0 -1 0 0] size [0.2 4 0.5] )
            wall ( name "box" pose [-3.2 2.3 0 0] size [0.8 0.6 0.5] )
            define pioneer position (
              size [0.44 0.38 0.22]
              drive "diff"
              localization "odom"
              odom_error [0.01 0.01 0 0.01]
              ranger ( sensor ( range [0 5.6] fov 240 samples 341 ) )
            )
            pioneer ( name "r0" pose [-2.5 -2 0 0] )
            """;

    /// Like the thesis's, with two servers in one file.
    private static final String CONFIGURATION = """
            driver ( name "stage" plugin "stageplugin" provides ["simulation:0"] worldfile "room.world" )
            driver ( name "stage" provides ["position2d:0" "ranger:0"] model "r0" )
            driver ( name "rangertolaser" requires ["ranger:0"] provides ["laser:0"] )
            driver ( name "mapfile" provides ["map:0"] filename "room.png" resolution 0.05 )
            driver
            (
              name "vfh"
              provides ["6666:position2d:1"]
              requires ["6665:position2d:0" "6665:laser:0"]
              safety_dist_0ms 0.1
              max_speed 0.4
            )
            driver
            (
              name "amcl"
              provides ["6666:localize:0" "6666:position2d:2"]
              requires ["odometry::6665:position2d:0" "6665:laser:0" "laser::6665:map:0"]
              init_pose_var [0.2 0.2 10]
              laser_max_beams 50
            )
            driver
            (
              name "wavefront"
              provides ["6666:planner:0" ]
              requires ["output::6666:position2d:1" "input::6666:position2d:2" "6665:map:0"]
              safety_dist 0.15
              distance_epsilon 0.3
            )
            driver ( name "mapfile" provides ["6666:map:0"] filename "room.png" resolution 0.05 )
            """;

    /// The room as an image, white where robots can drive: 8.2 m × 6.2 m, its middle at the origin.
    private static BufferedImage drawn() {
        var image = new BufferedImage(164, 124, BufferedImage.TYPE_INT_RGB);
        var pen = image.createGraphics();
        pen.setColor(Color.WHITE);
        pen.fillRect(4, 4, 156, 116);
        pen.setColor(Color.BLACK);
        pen.fillRect(80, 42, 4, 80); // between
        pen.fillRect(10, 10, 16, 12); // box
        pen.dispose();
        return image;
    }

    private static Message answer(DataInputStream from, int interf, int subtype) throws IOException {
        for (int i = 0; i < 1000; i++) {
            Message message = next(from);
            if (message.interf == interf && message.type == ACK && message.subtype == subtype) {
                return message;
            }
        }
        throw new IOException("There is no answer.");
    }

    static void subscribe(DataOutputStream to, int interf) throws IOException {
        send(to, PLAYER, REQUEST, 3, bytes(body -> {
            for (int number : new int[] {0, 0, interf, 0, 1, 0, 0}) {
                body.writeInt(number);
            }
        }));
    }

    /// As `playernav` does: it asks for the map, watches where the robot is, and sends it somewhere.
    @Test
    void aConfigurationIsServedAsPlayernavWantsIt() throws Exception {
        Files.writeString(folder.resolve("room.world"), WORLD);
        Files.writeString(folder.resolve("room.cfg"), CONFIGURATION);
        ImageIO.write(drawn(), "png", folder.resolve("room.png").toFile());
        Process process =
                new Rsal(folder).start("bridge", "player", "room.cfg", "--port", "0", "--json", "--speed", "10");
        try (BufferedReader out = process.inputReader()) {
            Map<String, Integer> ports = new LinkedHashMap<>();
            JsonMapper.shared()
                    .readTree(out.readLine())
                    .get("offers")
                    .forEach(offer -> ports.put(
                            offer.get("name").asString(), offer.get("port").asInt()));
            assertThat(ports.keySet())
                    .containsExactlyInAnyOrder(
                            "simulation:0",
                            "position2d:0",
                            "ranger:0",
                            "laser:0",
                            "map:0",
                            "position2d:1",
                            "localize:0",
                            "position2d:2",
                            "planner:0");
            try (var socket = new Socket(InetAddress.getLoopbackAddress(), ports.get("planner:0"))) {
                socket.setSoTimeout(30_000);
                var from = new DataInputStream(socket.getInputStream());
                var to = new DataOutputStream(socket.getOutputStream());
                from.skipNBytes(32);
                lookAtMap(from, to);
                subscribe(to, LOCALIZE);
                subscribe(to, PLANNER);
                send(to, PLANNER, COMMAND, 1, bytes(body -> {
                    body.writeDouble(2.5); // the other side of the wall
                    body.writeDouble(-2);
                    body.writeDouble(0);
                }));
                arrive(from);
            }
            try (var socket = new Socket(InetAddress.getLoopbackAddress(), ports.get("simulation:0"))) {
                socket.setSoTimeout(30_000);
                var from = new DataInputStream(socket.getInputStream());
                var to = new DataOutputStream(socket.getOutputStream());
                from.skipNBytes(32);
                send(to, SIMULATION, REQUEST, 1, bytes(body -> {
                    body.writeInt(3);
                    body.writeInt(3);
                    body.write(new byte[] {'r', '0', 0, 0});
                    body.write(new byte[24]);
                }));
                Message where = answer(from, SIMULATION, 1);
                where.body.skipNBytes(12);
                assertThat(Math.hypot(where.body.readDouble() - 2.5, where.body.readDouble() + 2))
                        .as("how far from its goal it really is")
                        .isLessThan(0.6);
            }
        } finally {
            Ended.signal("INT", process);
            assertThat(process.waitFor()).isEqualTo(130);
        }
    }

    private static void lookAtMap(DataInputStream from, DataOutputStream to) throws IOException {
        send(to, MAP, REQUEST, 1, new byte[0]);
        Message info = answer(from, MAP, 1);
        float scale = info.body.readFloat();
        int width = info.body.readInt();
        int height = info.body.readInt();
        assertThat(scale).isEqualTo(0.05f);
        assertThat(width).as("of the image").isEqualTo(164);
        assertThat(height).isEqualTo(124);
        send(to, MAP, REQUEST, 2, bytes(body -> {
            for (int number : new int[] {0, 0, width, height, 0, 0, 0}) {
                body.writeInt(number);
            }
        }));
        Message tile = answer(from, MAP, 2);
        tile.body.skipNBytes(28);
        byte[] cells = new InflaterInputStream(tile.body).readNBytes(width * height);
        assertThat(cells).hasSize(width * height).contains(-1, 1);
    }

    /// Reads on until the planner says that the robot is there.
    private static void arrive(DataInputStream from) throws IOException {
        boolean believes = false;
        boolean drove = false;
        while (true) {
            Message message = next(from);
            believes |= message.interf == LOCALIZE && message.type == DATA;
            if (message.interf == PLANNER && message.type == DATA) {
                boolean valid = message.body.readInt() == 1;
                boolean done = message.body.readInt() == 1;
                drove |= valid && !done;
                if (done) {
                    assertThat(drove).as("it drove there").isTrue();
                    assertThat(believes).as("its localizer told where it is").isTrue();
                    return;
                }
            }
        }
    }

    @Test
    void whatAConfigurationAsksForAndNobodyHasIsRefusedWithItsPlace() throws Exception {
        Files.writeString(folder.resolve("room.world"), WORLD);
        Files.writeString(
                folder.resolve("real.cfg"),
                CONFIGURATION + "driver ( name \"p2os\" provides [\"6670:position2d:0\"] use_tcp 1 )\n");
        Ended real = new Rsal(folder).run("bridge", "player", "real.cfg", "--port", "0");
        assertThat(real.code()).isEqualTo(3);
        assertThat(real.err()).contains("real.cfg:30:1: 'p2os' can't be served here.", "It is for real robots.");
        Files.writeString(folder.resolve("fast.cfg"), CONFIGURATION.replace("max_speed 0.4", "max_speed 400"));
        Ended fast = new Rsal(folder).run("bridge", "player", "fast.cfg", "--port", "0");
        assertThat(fast.code()).isEqualTo(3);
        assertThat(fast.err()).contains("fast.cfg:11:13: ", "must be a number from 0.05 to 3 [m/s], not '400");
    }

    /// Whether odometry tells of the turn, in the next few hundred messages.
    static void turn(DataOutputStream to) throws IOException {
        send(to, POSITION2D, COMMAND, 1, bytes(body -> {
            body.writeDouble(0);
            body.writeDouble(0);
            body.writeDouble(0.5); // turns on the spot
            body.writeInt(1);
        }));
    }

    /// How a client that drives falls silent.
    enum Silence {
        STOPPED,
        KILLED,
        NOTHING_IS_FORWARDED
    }

    /// Whatever the client commanded last: nothing of it goes on.
    @ParameterizedTest
    @EnumSource
    void aRobotStopsWhenItsClientFallsSilent(Silence how) throws Exception {
        Process process = new Rsal(folder).start("bridge", "player", "teleop", "--port", "0", "--json");
        try (BufferedReader out = process.inputReader()) {
            int port = JsonMapper.shared()
                    .readTree(out.readLine())
                    .get("offers")
                    .get(0)
                    .get("port")
                    .asInt();
            try (var socket = new Socket(InetAddress.getLoopbackAddress(), port);
                    var link = new Link(port)) {
                socket.setSoTimeout(20_000);
                var from = new DataInputStream(socket.getInputStream());
                from.skipNBytes(32);
                subscribe(new DataOutputStream(socket.getOutputStream()), POSITION2D);
                Process client = client(link.port());
                try {
                    awaitTurning(from, true);
                    switch (how) {
                        case STOPPED -> Ended.signal("STOP", client);
                        case KILLED -> Ended.signal("KILL", client);
                        case NOTHING_IS_FORWARDED -> link.fallSilent();
                    }
                    awaitTurning(from, false);
                } finally {
                    client.destroyForcibly();
                }
            }
        } finally {
            Ended.signal("INT", process);
            assertThat(process.waitFor()).isEqualTo(130);
        }
    }

    private static Process client(int port) throws IOException {
        return new ProcessBuilder(
                        Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                        "-cp",
                        System.getProperty("java.class.path"),
                        DrivingClient.class.getName(),
                        Integer.toString(port))
                .redirectErrorStream(true)
                .redirectOutput(ProcessBuilder.Redirect.DISCARD)
                .start();
    }

    /// Reads on until the robot turns, or stands.
    private static void awaitTurning(DataInputStream from, boolean turns) throws IOException {
        for (int i = 0; i < 1000; i++) {
            Message message = next(from);
            if (message.interf == POSITION2D && message.type == DATA) {
                message.body.skipNBytes(40);
                if (message.body.readDouble() > 0.1 == turns) {
                    return;
                }
            }
        }
        fail("The robot should %s.", turns ? "turn" : "stand");
    }

    /// Forwards what one client says and hears, until it falls silent without closing anything.
    private static final class Link implements AutoCloseable {
        private final ServerSocket listening = new ServerSocket(0, 1, InetAddress.getLoopbackAddress());
        private final List<Socket> sockets = Collections.synchronizedList(new ArrayList<>());
        private volatile boolean silent;

        Link(int to) throws IOException {
            Thread.ofPlatform().daemon().start(() -> {
                try {
                    Socket client = listening.accept();
                    var server = new Socket(InetAddress.getLoopbackAddress(), to);
                    sockets.addAll(List.of(client, server));
                    Thread.ofPlatform().daemon().start(() -> forward(server, client));
                    forward(client, server);
                } catch (IOException _) {
                    // the test is over
                }
            });
        }

        int port() {
            return listening.getLocalPort();
        }

        void fallSilent() {
            silent = true;
        }

        private void forward(Socket from, Socket to) {
            var some = new byte[8192];
            try {
                for (int read = from.getInputStream().read(some);
                        read >= 0;
                        read = from.getInputStream().read(some)) {
                    if (!silent) {
                        to.getOutputStream().write(some, 0, read);
                    }
                }
            } catch (IOException _) {
                // the test is over
            }
        }

        @Override
        public void close() throws IOException {
            listening.close();
            for (Socket socket : List.copyOf(sockets)) {
                socket.close();
            }
        }
    }

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
    void whatIsWrongIsReportedInASentence() throws Exception {
        Ended unknown = new Rsal(folder).run("bridge", "plaxer");
        assertThat(unknown.code()).isEqualTo(2);
        assertThat(unknown.err()).contains("There is no bridge 'plaxer'. Maybe 'player' was meant?");
        Ended nowhere = new Rsal(folder).run("bridge", "player", "teleop", "--listen", "not an address");
        assertThat(nowhere.code()).isEqualTo(2);
        assertThat(nowhere.err()).contains("'not an address' is not an address of a machine");
        try (var taken = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            String port = Integer.toString(taken.getLocalPort());
            Ended inUse = new Rsal(folder).run("bridge", "player", "teleop", "--port", port);
            assertThat(inUse.code()).isEqualTo(5);
            assertThat(inUse.err()).contains("RSAL can't listen at '", port, "another 'rsal bridge'", "--port 0");
        }
    }
}
