package rsal.ros2.system;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.sun.net.httpserver.HttpServer;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.URI;
import java.nio.ByteBuffer;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import rsal.data.LaserScan;
import rsal.data.Odometry;
import rsal.data.Pose2d;
import rsal.data.Twist2d;
import rsal.device.DriveBase;
import rsal.device.LaserScanner;
import rsal.robot.Robot;
import rsal.ros2.MemoryNetwork;
import rsal.ros2.cdr.CdrReader;
import rsal.ros2.cdr.InvalidCdr;
import rsal.ros2.link.Profile;
import rsal.ros2.link.RosLink;
import rsal.ros2.link.RosTopic;
import rsal.ros2.message.RosMessages;
import rsal.ros2.rosbridge.FakeRosbridge;
import rsal.ros2.rosbridge.RosbridgeServer;
import rsal.ros2.rosbridge.RosbridgeTransport;
import rsal.ros2.rosbridge.WebSocketTransport;
import rsal.scene.Scene;
import rsal.settings.Arguments;
import rsal.system.Diagnosis.Finding;
import rsal.system.RobotSystem;
import rsal.system.RobotSystem.Change;
import rsal.system.RobotSystemProvider.Config;
import rsal.testkit.contract.RobotBench;
import rsal.time.AllowedToReadWallClock;
import rsal.time.WallScheduler;

/// A robot behind a server of rosbridge, by WebSocket.
@AllowedToReadWallClock("Sockets live in real time.")
class RosbridgeSocketIT {
    private static final Duration STEP = Duration.ofMillis(50);

    private final WallScheduler there = new WallScheduler("robot", Runnable::run);
    private final WallScheduler here = new WallScheduler("run", Runnable::run);
    private final MemoryNetwork network = new MemoryNetwork(); // of the robot's thread
    private final FakeRosbridge rosbridge = new FakeRosbridge(network, false);
    private final AtomicReference<Twist2d> commanded = new AtomicReference<>(Twist2d.STOP);
    private final BlockingQueue<Change> changes = new LinkedBlockingQueue<>();
    private double x; // of the robot [m]

    @AfterEach
    void close() {
        here.close();
        there.close();
    }

    /// A robot that goes as fast as it is told.
    private void robotIsThere() {
        RosLink robot = network.join();
        var messages = new RosMessages();
        var odometry = robot.advertise(new RosTopic("/r1/odom", "nav_msgs/msg/Odometry"), Profile.DEFAULT);
        var scans = robot.advertise(new RosTopic("/r1/scan", "sensor_msgs/msg/LaserScan"), Profile.SENSOR_DATA);
        robot.subscribe(new RosTopic("/r1/cmd_vel", "geometry_msgs/msg/Twist"), Profile.DEFAULT, this::obey);
        there.every(STEP, () -> {
            x += commanded.get().vx() * STEP.toMillis() / 1e3;
            Instant now = there.instant();
            odometry.publish(messages.odometry(
                    now, new Odometry(new Pose2d(x, 0, 0), commanded.get(), false), "odom", "base_footprint"));
            var scan = new LaserScan(Pose2d.ORIGIN, -1, 1, 0.1, 5, new float[] {1, Float.POSITIVE_INFINITY, 3});
            scans.publish(messages.scan(now, scan, "laser_link", 0.05));
        });
    }

    private void obey(ByteBuffer message) {
        try {
            commanded.set(new Twist2d(CdrReader.of(message).float64(), 0, 0));
        } catch (InvalidCdr e) {
            throw new AssertionError(e);
        }
    }

    private RobotSystem system(URI address) {
        var provider = new Ros2Provider();
        var settings = Arguments.parse(
                provider.parameters(), Map.of("rosbridge", address.toString(), "namespaces", "/r1", "armed", "true"));
        return provider.create(
                new Config(
                        settings,
                        Scene.of(RobotBench.WORLD.grid()),
                        List.of(OneRobot.spec(Map.of("laser", "urg04lx"))),
                        1),
                here);
    }

    private void waitFor(String what, java.util.function.BooleanSupplier there) throws InterruptedException {
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(20);
        while (!there.getAsBoolean()) {
            assertThat(System.nanoTime()).as(what).isLessThan(end);
            Thread.sleep(20);
        }
    }

    private static double x(Robot robot) {
        return robot.find(DriveBase.class)
                .flatMap(DriveBase::latest)
                .map(odometry -> odometry.value().odomFromBase().x())
                .orElse(0.0);
    }

    @Test
    void drivesARobotAndFindsItAgainWhenTheServerWasAway() throws Exception {
        there.execute(this::robotIsThere);
        int port;
        RobotSystem system;
        Robot robot;
        try (var server = new RosbridgeServer(rosbridge, 0, there)) {
            port = server.address().getPort();
            system = system(server.address());
            system.onChange(changes::add);
            var found = new java.util.concurrent.CompletableFuture<List<Robot>>();
            here.execute(() -> system.discover().thenAccept(found::complete));
            robot = found.get(20, TimeUnit.SECONDS).getFirst();
            drive(robot, 0.5);
            double begin = x(robot);
            waitFor("it drives", () -> x(robot) > begin + 0.2);
            LaserScanner laser = robot.find(LaserScanner.class).orElseThrow();
            waitFor("it measures", () -> laser.latest().isPresent());
            assertThat(laser.latest().orElseThrow().value().ranges()[1]).isGreaterThan(3); // infinite: nothing there
        }
        assertThat(changes.poll(20, TimeUnit.SECONDS)).isInstanceOf(Change.Gone.class);
        try (var server = new RosbridgeServer(rosbridge, port, there)) {
            assertThat(server.address().getPort()).isEqualTo(port);
            assertThat(changes.poll(30, TimeUnit.SECONDS)).isInstanceOf(Change.Appeared.class);
            waitFor(
                    "it is stopped, as nobody could stop it meanwhile",
                    () -> commanded.get().vx() == 0);
            double begin = x(robot);
            drive(robot, -0.5);
            waitFor("it drives back", () -> x(robot) < begin - 0.2);
            here.execute(system::close);
            waitFor("it is stopped at the end", () -> commanded.get().vx() == 0);
        }
    }

    private void drive(Robot robot, double speed) {
        var command = new Object() {
            private int times;
        };
        here.every(STEP, () -> {
            if (command.times++ < 40) {
                robot.find(DriveBase.class).orElseThrow().command(new Twist2d(speed, 0, 0));
            }
        });
    }

    @Test
    void theDoctorFindsRobotsBehindAServer() throws Exception {
        there.execute(this::robotIsThere);
        URI address;
        try (var server = new RosbridgeServer(rosbridge, 0, there)) {
            address = server.address();
            assertThat(diagnosed(address))
                    .containsExactly(
                            new Finding("rosbridge", true, "answers at '%s'".formatted(address), ""),
                            new Finding("robot", true, "'/r1' has cmd_vel, odometry, scans", ""));
        }
        assertThat(diagnosed(address)).singleElement().satisfies(finding -> {
            assertThat(finding.ok()).isFalse();
            assertThat(finding.found()).contains(address.toString(), "nobody listens there");
        });
    }

    @Test
    void theDoctorSaysThatAServerDoesNotAnswer() throws Exception {
        try (var server = new RosbridgeServer(rosbridge, 0, _ -> {})) {
            URI address = server.address();
            assertThat(diagnosed(address)).singleElement().satisfies(finding -> {
                assertThat(finding.ok()).isFalse();
                assertThat(finding.found()).isEqualTo("'%s' does not answer within 3 s".formatted(address));
            });
        }
    }

    private static List<Finding> diagnosed(URI address) {
        var diagnosis = new Ros2Diagnosis();
        Map<String, String> typed = Map.of("rosbridge", address.toString(), "time", "3");
        return diagnosis.look(Arguments.parse(diagnosis.parameters(), typed));
    }

    private static final class Ears implements RosbridgeTransport.Receiver {
        private final BlockingQueue<String> closed = new LinkedBlockingQueue<>();

        @Override
        public void onText(String message) {
            // not asked for
        }

        @Override
        public void onBinary(ByteBuffer message) {
            // not asked for
        }

        @Override
        public void onClosed(String why) {
            closed.add(why);
        }
    }

    private static void refused(int port, String why) {
        try (var transport = new WebSocketTransport(URI.create("ws://127.0.0.1:%d".formatted(port)))) {
            assertThatThrownBy(() ->
                            transport.open(new Ears()).toCompletableFuture().get(20, TimeUnit.SECONDS))
                    .hasMessageContaining(why);
        }
    }

    @Test
    void saysWhyThereIsNoConnection() throws Exception {
        int free;
        try (var socket = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            free = socket.getLocalPort();
        }
        refused(free, "nobody listens there");
        HttpServer pages = HttpServer.create(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0), 0);
        pages.start();
        try {
            refused(pages.getAddress().getPort(), "it is not a WebSocket server (HTTP 404)");
        } finally {
            pages.stop(0);
        }
    }

    @Test
    void messagesThatAreTooLargeEndTheConnection() throws Exception {
        try (var server = new RosbridgeServer(rosbridge, 0, there);
                var transport = new WebSocketTransport(server.address())) {
            var ears = new Ears();
            transport.open(ears).toCompletableFuture().get(20, TimeUnit.SECONDS);
            waitFor("the server has a client", rosbridge::hasClients);
            there.execute(() -> rosbridge.sendAll(new byte[RosbridgeTransport.MOST_BYTES + 1]));
            assertThat(ears.closed.poll(20, TimeUnit.SECONDS)).isEqualTo("it sent a message of more than 64 MiB");
        }
    }
}
