package rsal.player.client;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIOException;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.player.Recorded;
import rsal.player.client.Connection.Silence;
import rsal.player.message.Chars;
import rsal.player.message.Graphics2d;
import rsal.player.message.GripperInterface;
import rsal.player.message.Interface;
import rsal.player.message.Pose;
import rsal.player.message.Position2d;
import rsal.player.message.Protocol;
import rsal.player.message.Session;
import rsal.player.wire.Address;
import rsal.player.wire.Header;
import rsal.player.wire.MessageKind;
import rsal.player.wire.Packet;

@Timeout(60)
class ConnectionTest {
    private static final Duration PATIENCE = Duration.ofSeconds(5);
    private static final String IDENT = "Player v.3.1.1-dev";
    private static final Address PLAYER = Address.of(Interface.PLAYER.code(), 0);
    private static final Address BASE = Address.of(Interface.POSITION2D.code(), 0);

    private final BlockingQueue<Packet> data = new LinkedBlockingQueue<>();
    private ScriptedServer server;
    private ScriptedServer.Client client;
    private Connection connection;

    @BeforeEach
    void connect() throws IOException {
        server = new ScriptedServer();
        connect(Delivery.PULL);
    }

    private void connect(Delivery delivery) throws IOException {
        var opening = opening(delivery);
        client = server.accept(IDENT);
        connection = opening.join();
    }

    private CompletableFuture<Connection> opening(Delivery delivery) {
        return opening(delivery, Silence.USUAL);
    }

    private CompletableFuture<Connection> opening(Delivery delivery, Silence silence) {
        var opening = new CompletableFuture<Connection>();
        Thread.ofVirtual().start(() -> {
            try {
                opening.complete(Connection.open(server.address(), delivery, PATIENCE, silence, data::add));
            } catch (IOException e) {
                opening.completeExceptionally(e);
            }
        });
        return opening;
    }

    @AfterEach
    void disconnect() throws IOException {
        connection.close();
        client.close();
        server.close();
    }

    private static <T> T result(CompletionStage<T> stage) {
        return stage.toCompletableFuture().orTimeout(10, TimeUnit.SECONDS).join();
    }

    private static Packet state(double x) {
        var state = new Position2d.State(new Pose(x, 0, 0), new Pose(0, 0, 0), 0);
        return Packet.of(BASE, MessageKind.DATA, Position2d.STATE, 0, state);
    }

    private static Packet synch() {
        return Packet.of(PLAYER, MessageKind.SYNCH, Session.COMPLETE, 0);
    }

    @Test
    void asksForTheNewestOfEachKindInRounds() throws Exception {
        assertThat(connection.ident()).isEqualTo(IDENT);
        assertThat(connection.protocol()).isSameAs(Protocol.V3_1);
        Packet mode = client.next();
        assertThat(mode.header().subtype()).isEqualTo(Session.MODE);
        assertThat(mode.body(Session.Mode.class)).isEqualTo(new Session.Mode(Session.PULL));
        client.acknowledge(mode);
        Packet rule = client.next();
        assertThat(rule.body(Session.ReplaceRule.class))
                .isEqualTo(new Session.ReplaceRule(-1, -1, 1, -1, Session.REPLACE));
        client.acknowledge(rule);
        for (int round = 0; round < 3; round++) {
            Packet wanted = client.next();
            assertThat(wanted.header().subtype()).isEqualTo(Session.DATA);
            client.acknowledge(wanted);
            client.send(state(round));
            client.send(synch());
        }
        for (int round = 0; round < 3; round++) {
            Packet reported = data.poll(10, TimeUnit.SECONDS);
            assertThat(reported.body(Position2d.State.class).odomFromBase().x()).isEqualTo(round);
        }
    }

    @Test
    void roundsDoNotRace() throws Exception {
        client.next(PLAYER, Session.DATA);
        long begun = System.nanoTime();
        for (int round = 0; round < 10; round++) {
            client.send(state(round));
            client.send(synch());
            client.next(PLAYER, Session.DATA);
        }
        assertThat(Duration.ofNanos(System.nanoTime() - begun)).isGreaterThan(Duration.ofMillis(150));
    }

    @Test
    void understandsAServerThatSendsByteByByte() throws Exception {
        client.socket().setTcpNoDelay(true);
        for (byte one : state(3).bytes()) {
            client.send(new byte[] {one});
        }
        assertThat(data.poll(10, TimeUnit.SECONDS)
                        .body(Position2d.State.class)
                        .odomFromBase()
                        .x())
                .isEqualTo(3);
    }

    @Test
    void hasTheNewestOfEachKindPushed() throws Exception {
        connection.close();
        client.close();
        connect(Delivery.PUSH);
        Packet mode = client.next();
        assertThat(mode.body(Session.Mode.class)).isEqualTo(new Session.Mode(Session.PUSH));
        assertThat(client.next().header().subtype()).isEqualTo(Session.REPLACE_RULE);
        client.send(state(1));
        assertThat(data.poll(10, TimeUnit.SECONDS)).isNotNull();
        connection.devices();
        assertThat(client.next().header().subtype()).as("it asks for no rounds").isEqualTo(Session.DEVICES);
    }

    /// The server's half of the sessions that were recorded, but for what it answered about itself.
    @ParameterizedTest
    @ValueSource(strings = {"simple", "semantics"})
    void understandsWhatAServerOnceSaid(String session) throws Exception {
        connection.close();
        client.close();
        connect(Delivery.PUSH);
        CompletionStage<Packet> answer = CompletableFuture.failedStage(new AssertionError("Nothing was asked."));
        int reported = 0;
        for (Recorded.Message message : Recorded.session(session)) {
            Packet packet =
                    Packet.read(new ByteArrayInputStream(message.bytes())).orElseThrow();
            Header header = packet.header();
            if (header.address().interf() == Interface.PLAYER.code() || header.kind() == MessageKind.COMMAND) {
                continue;
            }
            if (message.sent()) {
                answer = connection.ask(packet);
                client.next(header.address(), header.subtype());
                continue;
            }
            client.send(message.bytes());
            if (header.kind() == MessageKind.ACK) {
                assertThat(result(answer).body()).isEqualTo(packet.body());
            } else if (header.kind() == MessageKind.NACK) {
                CompletionStage<Packet> refused = answer;
                assertThatThrownBy(() -> result(refused)).hasCauseInstanceOf(RefusedException.class);
            } else {
                reported++;
            }
        }
        assertThat(reported).isGreaterThan(100);
        for (int i = 0; i < reported; i++) {
            Packet packet = data.poll(10, TimeUnit.SECONDS);
            assertThat(packet).isNotNull();
            assertThat(connection.protocol().read(packet)).isPresent();
        }
    }

    @ParameterizedTest
    @CsvSource({
        "AUTO, 127.0.0.1, false",
        "AUTO, ::1, false",
        "AUTO, 192.168.1.5, true",
        "PUSH, 192.168.1.5, false",
        "PULL, 127.0.0.1, true"
    })
    void pullsFromOtherMachinesUnlessAskedOtherwise(Delivery delivery, String server, boolean pulls) {
        assertThat(delivery.pulls(InetAddress.ofLiteral(server))).isEqualTo(pulls);
    }

    @Test
    void reportsWhichDevicesThereAreAndWhatDrivesThem() throws IOException {
        CompletionStage<List<Address>> devices = connection.devices();
        client.acknowledge(client.next(PLAYER, Session.DEVICES), new Session.Devices(List.of(BASE)));
        assertThat(result(devices)).containsExactly(BASE);
        CompletionStage<String> driver = connection.driver(BASE);
        Packet request = client.next(PLAYER, Session.DRIVER);
        assertThat(request.body(Session.Driver.class).device()).isEqualTo(BASE);
        client.acknowledge(request, new Session.Driver(BASE, Chars.of("stage")));
        assertThat(result(driver)).isEqualTo("stage");
    }

    @Test
    void subscribesToADeviceUnlessItsDriverFails() throws IOException {
        CompletionStage<String> good = connection.subscribe(BASE);
        Packet request = client.next(PLAYER, Session.DEVICE);
        assertThat(request.body(Session.Subscription.class).access()).isEqualTo(Session.OPEN);
        client.acknowledge(request, new Session.Subscription(BASE, Session.OPEN, Chars.of("stage")));
        assertThat(result(good)).isEqualTo("stage");
        CompletionStage<String> bad = connection.subscribe(BASE);
        request = client.next(PLAYER, Session.DEVICE);
        client.acknowledge(request, new Session.Subscription(BASE, Session.ERROR, Chars.of("stage")));
        assertThatThrownBy(() -> result(bad))
                .hasRootCauseInstanceOf(RefusedException.class)
                .rootCause()
                .hasMessage("The driver of 'position2d:0' did not start.");
    }

    @Test
    void givesEachAnswerToTheOneWhoAsked() throws IOException {
        Address other = Address.of(Interface.POSITION2D.code(), 1);
        CompletionStage<Packet> first = connection.ask(Packet.of(BASE, MessageKind.REQUEST, Position2d.GEOMETRY, 0));
        CompletionStage<Packet> second = connection.ask(Packet.of(other, MessageKind.REQUEST, Position2d.GEOMETRY, 0));
        Packet one = client.next(BASE, Position2d.GEOMETRY);
        Packet two = client.next(other, Position2d.GEOMETRY);
        client.refuse(two);
        client.acknowledge(one);
        assertThat(result(first).header().address()).isEqualTo(BASE);
        assertThatThrownBy(() -> result(second))
                .rootCause()
                .isInstanceOf(RefusedException.class)
                .hasMessage("The server refuses request 1 of 'position2d:1'.");
    }

    @Test
    void commandsArriveAndNeedNoAnswer() throws IOException {
        var velocity = new Position2d.Velocity(new Pose(0.3, 0, 0.1), 1);
        connection.command(Packet.of(BASE, MessageKind.COMMAND, Position2d.VELOCITY, 0, velocity));
        Packet command = client.next(BASE, Position2d.VELOCITY);
        assertThat(command.header().kind()).isEqualTo(MessageKind.COMMAND);
        assertThat(command.body(Position2d.Velocity.class)).isEqualTo(velocity);
    }

    @Test
    void aServerThatEndsIsLostAndWhoeverWaitsIsInformed() throws IOException {
        CompletionStage<Packet> waiting = connection.ask(Packet.of(BASE, MessageKind.REQUEST, Position2d.GEOMETRY, 0));
        client.next(BASE, Position2d.GEOMETRY);
        client.close();
        assertThat(result(connection.lost())).isEqualTo("The server has closed the connection.");
        assertThatThrownBy(() -> result(waiting)).hasRootCauseInstanceOf(IOException.class);
        assertThatThrownBy(() -> result(connection.devices())).rootCause().hasMessageContaining("closed");
    }

    @Test
    void aServerThatSaysNothingIsAskedAndLostWhenItDoesNotAnswer() throws Exception {
        connection.close();
        client.close();
        var opening = opening(Delivery.PUSH, new Silence(Duration.ofMillis(100), 10));
        client = server.accept(IDENT);
        connection = opening.join();
        byte[] state = state(1).bytes();
        client.send(Arrays.copyOf(state, 50)); // a message that takes its time
        for (int answered = 0; answered < 3; answered++) {
            client.next(PLAYER, Session.DEVICES);
        }
        assertThat(connection.lost().toCompletableFuture()).isNotDone();
        client.send(Arrays.copyOfRange(state, 50, state.length));
        assertThat(data.poll(10, TimeUnit.SECONDS)).isNotNull();
        client.acknowledge(client.next(PLAYER, Session.DEVICES), new Session.Devices(List.of(BASE)));
        assertThat(result(connection.lost())).isEqualTo("Nothing came for 1 s.");
    }

    @Test
    void whatIsNeverAnsweredIsForgotten() throws IOException {
        Packet geometry = Packet.of(BASE, MessageKind.REQUEST, Position2d.GEOMETRY, 0);
        CompletionStage<Packet> first = connection.ask(geometry);
        List<CompletionStage<Packet>> others = new ArrayList<>();
        for (int i = 0; i < 16; i++) {
            others.add(connection.ask(geometry));
        }
        assertThatThrownBy(() -> result(first)).rootCause().hasMessage("The server does not answer.");
        client.acknowledge(client.next(BASE, Position2d.GEOMETRY));
        assertThat(result(others.getFirst()).header().kind()).isEqualTo(MessageKind.ACK);
        assertThat(others.getLast().toCompletableFuture()).isNotDone();
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
    void noiseEndsTheConnectionWithAReason(long seed) throws IOException {
        var noise = new byte[4096];
        new SplittableRandom(seed).nextBytes(noise);
        client.send(noise);
        client.socket().shutdownOutput(); // else it may wait for the rest of a message
        assertThat(result(connection.lost())).isNotBlank();
    }

    @Test
    void messagesInSinglesBytesAreRead() throws Exception {
        for (byte each : state(7).bytes()) {
            client.send(new byte[] {each});
        }
        assertThat(data.poll(10, TimeUnit.SECONDS).body(Position2d.State.class).odomFromBase())
                .isEqualTo(new Pose(7, 0, 0));
    }

    @Test
    void whatIsNotForAClientIsLeftOut() throws Exception {
        client.send(Packet.of(BASE, MessageKind.COMMAND, Position2d.VELOCITY, 0));
        client.send(Packet.of(BASE, MessageKind.ACK, Position2d.GEOMETRY, 0)); // nobody asked
        byte[] unknown = state(1).bytes();
        unknown[19] = 77;
        client.send(unknown);
        client.send(state(2));
        assertThat(data.poll(10, TimeUnit.SECONDS)
                        .body(Position2d.State.class)
                        .odomFromBase()
                        .x())
                .isEqualTo(2);
    }

    @Test
    void closingInformsWhoeverWaits() {
        CompletionStage<Packet> waiting = connection.ask(Packet.of(BASE, MessageKind.REQUEST, Position2d.GEOMETRY, 0));
        connection.close();
        connection.close();
        assertThat(result(connection.lost())).isEqualTo("The connection was closed.");
        assertThatThrownBy(() -> result(waiting)).rootCause().hasMessage("The connection was closed.");
    }

    @Test
    void aServerOfSomethingElseIsNamedAtOnce() throws IOException {
        var opening = opening(Delivery.PULL);
        try (ScriptedServer.Client web = server.accept("HTTP/1.1 400 Bad Request\r\nServer: x")) {
            assertThatThrownBy(() -> result(opening))
                    .rootCause()
                    .hasMessageContaining("is not a Player server; it begins with 'HTTP/1.1 400 Bad Request??");
            assertThat(web.in().read()).as("it is let go").isEqualTo(-1);
        }
    }

    @Test
    void nobodyThereIsReported() throws IOException {
        InetSocketAddress nobody;
        try (var closed = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            nobody = (InetSocketAddress) closed.getLocalSocketAddress();
        }
        assertThatIOException().isThrownBy(() -> Connection.open(nobody, Delivery.AUTO, PATIENCE, data::add));
    }

    @Test
    void whatWasCommandedLastIsSentLast() throws InterruptedException {
        var outbox = new Outbox();
        Address gripper = Address.of(Interface.GRIPPER.code(), 0);
        for (int subtype : new int[] {GripperInterface.OPEN, GripperInterface.CLOSE, GripperInterface.OPEN}) {
            outbox.command(Packet.of(gripper, MessageKind.COMMAND, subtype, 0));
        }
        assertThat(outbox.take().orElseThrow().getFirst().header().subtype()).isEqualTo(GripperInterface.CLOSE);
        assertThat(outbox.take().orElseThrow().getFirst().header().subtype()).isEqualTo(GripperInterface.OPEN);
        assertThat(outbox.isEmpty()).isTrue();
    }

    @Test
    void ofCommandsThatWereNotSentTheNewestOfAKindCounts() throws InterruptedException {
        var outbox = new Outbox();
        for (int i = 0; i < 1000; i++) {
            var velocity = new Position2d.Velocity(new Pose(i, 0, 0), 1);
            outbox.command(Packet.of(BASE, MessageKind.COMMAND, Position2d.VELOCITY, 0, velocity));
            outbox.command(Packet.of(
                    Address.of(Interface.POSITION2D.code(), 1), MessageKind.COMMAND, Position2d.VELOCITY, 0, velocity));
        }
        assertThat(outbox.request(Packet.of(BASE, MessageKind.REQUEST, Position2d.GEOMETRY, 0)))
                .isTrue();
        for (int index = 0; index < 2; index++) {
            Packet sent = outbox.take().orElseThrow().getFirst();
            assertThat(sent.header().address().index()).isEqualTo(index);
            assertThat(sent.body())
                    .hasSize(28)
                    .satisfies(_ -> assertThat(sent.body(Position2d.Velocity.class)
                                    .velocity()
                                    .x())
                            .isEqualTo(999));
        }
        assertThat(outbox.take().orElseThrow().getFirst().header().kind())
                .as("in their order")
                .isEqualTo(MessageKind.REQUEST);
        int accepted = 0;
        while (outbox.request(Packet.of(BASE, MessageKind.REQUEST, Position2d.GEOMETRY, 0))) {
            accepted++;
        }
        assertThat(accepted).as("it does not grow for ever").isEqualTo(1024);
        assertThat(Header.BYTES).isEqualTo(40);
    }

    @Test
    void commandsThatBelongTogetherStayTogetherAndTheNewestOfThemCount() throws InterruptedException {
        Address canvas = Address.of(Interface.GRAPHICS2D.code(), 0);
        var outbox = new Outbox();
        for (int lines = 1; lines <= 3; lines++) {
            var together = new ArrayList<Packet>();
            together.add(Packet.of(canvas, MessageKind.COMMAND, Graphics2d.CLEAR, 0));
            for (int i = 0; i < lines; i++) {
                together.add(Packet.of(canvas, MessageKind.COMMAND, Graphics2d.POLYLINE, 0));
            }
            outbox.commands(canvas, together);
        }
        outbox.command(Packet.of(BASE, MessageKind.COMMAND, Position2d.VELOCITY, 0));
        assertThat(outbox.take().orElseThrow())
                .extracting(packet -> packet.header().subtype())
                .containsExactly(Graphics2d.CLEAR, Graphics2d.POLYLINE, Graphics2d.POLYLINE, Graphics2d.POLYLINE);
        assertThat(outbox.take().orElseThrow()).hasSize(1);
    }
}
