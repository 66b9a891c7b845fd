package rsal.player.server;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;

import java.io.BufferedInputStream;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.net.SocketException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.player.client.Connection;
import rsal.player.client.Delivery;
import rsal.player.client.RefusedException;
import rsal.player.message.Interface;
import rsal.player.message.Pose;
import rsal.player.message.Position2d;
import rsal.player.message.Protocol;
import rsal.player.message.Session;
import rsal.player.wire.Address;
import rsal.player.wire.Header;
import rsal.player.wire.Layout;
import rsal.player.wire.MessageKind;
import rsal.player.wire.Packet;

@Timeout(60)
class PortTest {
    private static final Address PLAYER = Address.of(Interface.PLAYER.code(), 0);
    private static final long SILENT_FOR_LONG = TimeUnit.MILLISECONDS.toNanos(1200);
    private static final Address BASE = Address.of(Interface.POSITION2D.code(), 0);

    private final Base base = new Base();
    private final BlockingQueue<Packet> data = new LinkedBlockingQueue<>();
    private final List<AutoCloseable> open = new ArrayList<>();
    private final AtomicLong now = new AtomicLong(); // real time, as the port has it [ns]
    private Port port;

    /// A base that notes what it is told.
    private static final class Base implements ServedDevice {
        private final BlockingQueue<Packet> commands = new LinkedBlockingQueue<>();
        private final AtomicInteger forsaken = new AtomicInteger();
        private final AtomicInteger users = new AtomicInteger();
        private final BlockingQueue<Integer> left = new LinkedBlockingQueue<>(); // users after each that went
        private final List<CompletableFuture<Answer>> asked = new CopyOnWriteArrayList<>();
        private volatile boolean works = true;
        private volatile Runnable named = () -> {}; // what happens when it is asked for its driver

        @Override
        public Interface interf() {
            return Interface.POSITION2D;
        }

        @Override
        public int index() {
            return 0;
        }

        @Override
        public String driver() {
            named.run();
            return "rsal";
        }

        @Override
        public CompletionStage<Boolean> open() {
            users.incrementAndGet();
            return CompletableFuture.completedStage(works);
        }

        @Override
        public void close() {
            left.add(users.decrementAndGet());
        }

        @Override
        public void forsaken() {
            forsaken.incrementAndGet();
        }

        @Override
        public boolean understands(MessageKind kind, int subtype) {
            return kind == MessageKind.COMMAND && subtype == Position2d.VELOCITY;
        }

        @Override
        public CompletionStage<Answer> ask(Packet request) {
            return switch (request.header().subtype()) {
                case Position2d.RESET_ODOMETRY -> CompletableFuture.completedStage(new Answer.Done());
                case Position2d.SPEED_PROFILE -> {
                    var answer = new CompletableFuture<Answer>(); // of one that takes its time
                    asked.add(answer);
                    yield answer;
                }
                case Position2d.SET_ODOMETRY -> CompletableFuture.failedStage(new IllegalStateException("broken"));
                default -> CompletableFuture.completedStage(new Answer.Refused());
            };
        }

        @Override
        public void command(Packet command) {
            commands.add(command);
        }
    }

    @BeforeEach
    void listen() throws IOException {
        port = new Port(
                new InetSocketAddress(InetAddress.getLoopbackAddress(), 0),
                List.of(base),
                Protocol.V3_1,
                () -> 12.5,
                now::get,
                Runnable::run);
        port.start();
        open.add(port);
    }

    @AfterEach
    void close() throws Exception {
        for (AutoCloseable each : open.reversed()) {
            each.close();
        }
    }

    private InetSocketAddress address() {
        return new InetSocketAddress(InetAddress.getLoopbackAddress(), port.number());
    }

    private Connection connect() throws IOException {
        Connection connection = Connection.open(address(), Delivery.PULL, Duration.ofSeconds(5), data::add);
        open.add(connection);
        return connection;
    }

    private static <T> T result(CompletionStage<T> stage) {
        return stage.toCompletableFuture().orTimeout(10, TimeUnit.SECONDS).join();
    }

    private void publish(double x) {
        var state = new Position2d.State(new Pose(x, 0, 0), new Pose(0, 0, 0), 0);
        port.publish(base, Position2d.STATE, 1, state);
    }

    private static double x(Packet state) throws IOException {
        return state.body(Position2d.State.class).odomFromBase().x();
    }

    /// A client that sends and gets what it likes.
    private final class Raw implements AutoCloseable {
        private final Socket socket = new Socket();
        private final BufferedInputStream in;

        Raw() throws IOException {
            socket.connect(address());
            socket.setSoTimeout(10_000);
            in = new BufferedInputStream(socket.getInputStream());
            assertThat(new String(in.readNBytes(32), java.nio.charset.StandardCharsets.US_ASCII))
                    .startsWith("Player v.3.1");
            open.add(this);
        }

        void send(byte[] bytes) throws IOException {
            socket.getOutputStream().write(bytes);
        }

        void ask(int subtype) throws IOException {
            send(Packet.of(PLAYER, MessageKind.REQUEST, subtype, 0).bytes());
        }

        void ask(int subtype, Record body) throws IOException {
            send(Packet.of(PLAYER, MessageKind.REQUEST, subtype, 0, body).bytes());
        }

        /// To the base.
        void send(MessageKind kind, int subtype, byte[] body) throws IOException {
            send(new Packet(new Header(BASE, kind, subtype, 0, 0, body.length), body).bytes());
        }

        Packet next() throws IOException {
            return Packet.read(in).orElseThrow();
        }

        Packet nextAnswer() throws IOException {
            Packet packet = next();
            while (packet.header().kind() == MessageKind.DATA) {
                packet = next();
            }
            return packet;
        }

        @Override
        public void close() throws IOException {
            socket.close();
        }
    }

    private Raw subscribed() throws IOException {
        var raw = new Raw();
        raw.ask(Session.DEVICE, new Session.Subscription(BASE, Session.OPEN, new byte[0]));
        assertThat(raw.nextAnswer().body(Session.Subscription.class).access()).isEqualTo(Session.OPEN);
        return raw;
    }

    @Test
    void ourOwnClientFindsAndSubscribesAndHears() throws Exception {
        Connection connection = connect();
        List<Address> devices = result(connection.devices());
        assertThat(devices).containsExactly(new Address(0x0100007f, port.number(), Interface.POSITION2D.code(), 0));
        assertThat(result(connection.driver(BASE))).isEqualTo("rsal");
        assertThat(result(connection.subscribe(BASE))).isEqualTo("rsal");
        publish(3);
        assertThat(x(data.poll(10, TimeUnit.SECONDS))).isEqualTo(3);
        publish(4);
        Packet second = data.poll(10, TimeUnit.SECONDS);
        assertThat(x(second)).isEqualTo(4);
        assertThat(second.header().time()).isEqualTo(1);
    }

    @Test
    void aDeviceThatIsNotThereOrDoesNotWorkIsRefused() throws IOException {
        Connection connection = connect();
        assertThatThrownBy(() -> result(connection.subscribe(Address.of(Interface.LASER.code(), 0))))
                .hasRootCauseInstanceOf(RefusedException.class);
        base.works = false;
        assertThatThrownBy(() -> result(connection.subscribe(BASE))).rootCause().hasMessageContaining("did not start");
    }

    @Test
    void requestsAreAnsweredByTheDeviceAndItsFailuresAreRefusals() throws IOException {
        Connection connection = connect();
        Packet done = result(connection.ask(Packet.of(BASE, MessageKind.REQUEST, Position2d.RESET_ODOMETRY, 0)));
        assertThat(done.header().time()).isEqualTo(12.5);
        assertThat(done.header().address().robot()).isEqualTo(port.number());
        for (Packet bad : List.of(
                Packet.of(BASE, MessageKind.REQUEST, Position2d.GEOMETRY, 0),
                Packet.of(
                        BASE,
                        MessageKind.REQUEST,
                        Position2d.SET_ODOMETRY,
                        0,
                        new Position2d.Odometry(new Pose(1, 2, 3))))) {
            assertThatThrownBy(() -> result(connection.ask(bad))).hasRootCauseInstanceOf(RefusedException.class);
        }
    }

    @Test
    void whoAsksMuchThatIsNotAnsweredHasToWait() throws Exception {
        var raw = new Raw();
        for (int i = 0; i < 100; i++) {
            raw.send(
                    Packet.of(BASE, MessageKind.REQUEST, Position2d.SPEED_PROFILE, 0, new Position2d.SpeedProfile(1, 1))
                            .bytes());
        }
        await().until(() -> base.asked.size() >= 64);
        await().during(200, TimeUnit.MILLISECONDS).until(() -> base.asked.size() == 64);
        base.asked.forEach(answer -> answer.complete(new ServedDevice.Answer.Done()));
        for (int i = 0; i < 64; i++) {
            assertThat(raw.next().header().kind()).isEqualTo(MessageKind.ACK);
        }
        raw.close();
    }

    @Test
    void capabilitiesAreAnswered() throws IOException {
        Connection connection = connect();
        result(connection.ask(
                Packet.of(BASE, MessageKind.REQUEST, 255, 0, new Session.Capability(2, Position2d.VELOCITY))));
        assertThatThrownBy(() -> result(connection.ask(
                        Packet.of(BASE, MessageKind.REQUEST, 255, 0, new Session.Capability(2, Position2d.CAR)))))
                .hasRootCauseInstanceOf(RefusedException.class);
    }

    @Test
    void commandsReachTheDeviceUnlessTheyAreMalformed() throws Exception {
        var raw = new Raw();
        var velocity = new Position2d.Velocity(new Pose(0.3, 0, 0.1), 1);
        raw.send(Packet.of(BASE, MessageKind.COMMAND, Position2d.VELOCITY, 0, new Position2d.Motors(1))
                .bytes());
        raw.send(Packet.of(Address.of(Interface.LASER.code(), 3), MessageKind.COMMAND, 1, 0)
                .bytes());
        raw.send(Packet.of(BASE, MessageKind.COMMAND, Position2d.VELOCITY, 0, velocity)
                .bytes());
        assertThat(base.commands.poll(10, TimeUnit.SECONDS).body(Position2d.Velocity.class))
                .isEqualTo(velocity);
        assertThat(base.commands).isEmpty();
    }

    @Test
    void whoCommandedLastForsakesTheDeviceWhenItGoes() throws Exception {
        subscribed(); // somebody who only looks stays
        var velocity = new Position2d.Velocity(new Pose(0.3, 0, 0.1), 1);
        byte[] command = Packet.of(BASE, MessageKind.COMMAND, Position2d.VELOCITY, 0, velocity)
                .bytes();
        var first = new Raw();
        first.send(command);
        assertThat(base.commands.poll(10, TimeUnit.SECONDS)).isNotNull();
        var second = new Raw();
        second.send(command);
        assertThat(base.commands.poll(10, TimeUnit.SECONDS)).isNotNull();
        first.close();
        assertThat(base.left.poll(10, TimeUnit.SECONDS)).isEqualTo(2);
        assertThat(base.forsaken).hasValue(0);
        second.close();
        assertThat(base.left.poll(10, TimeUnit.SECONDS)).isEqualTo(1);
        assertThat(base.forsaken).hasValue(1);
    }

    @Test
    void commandsThatComeByteByByteCount() throws Exception {
        var raw = new Raw();
        raw.socket.setTcpNoDelay(true);
        var velocity = new Position2d.Velocity(new Pose(0.3, 0, 0.1), 1);
        for (byte one : Packet.of(BASE, MessageKind.COMMAND, Position2d.VELOCITY, 0, velocity)
                .bytes()) {
            raw.send(new byte[] {one});
        }
        assertThat(base.commands.poll(10, TimeUnit.SECONDS).body(Position2d.Velocity.class))
                .isEqualTo(velocity);
    }

    /// As Player does.
    @Test
    void whatStandsBehindABodyIsLeft() throws Exception {
        var raw = new Raw();
        var velocity = new Position2d.Velocity(new Pose(0.3, 0, 0.1), 1);
        byte[] body = Layout.of(Position2d.Velocity.class).bytes(velocity);
        raw.send(MessageKind.COMMAND, Position2d.VELOCITY, Arrays.copyOf(body, body.length + 4));
        assertThat(base.commands.poll(5, TimeUnit.SECONDS))
                .isNotNull()
                .satisfies(command ->
                        assertThat(command.body(Position2d.Velocity.class)).isEqualTo(velocity));
        raw.send(MessageKind.REQUEST, Position2d.SPEED_GAINS, new byte[24]); // javaclient3 sends as many, for 12
        assertThat(raw.next().header().subtype()).isEqualTo(Position2d.SPEED_GAINS);
        raw.ask(Session.MODE, new Session.ReplaceRule(Session.PULL, 0, 0, 0, 0)); // longer than a mode
        assertThat(raw.next().header().kind()).isEqualTo(MessageKind.ACK);
    }

    /// Player's clients wait for an answer, some of them forever.
    @ParameterizedTest
    @CsvSource({
        "5, 4", // too short
        "77, 4", // there is no such request
        "254, 20", // properties: there are none
        "253, 20", "252, 24", "251, 24", "250, 28", "249, 28", "248, 20", "247, 20", "248, 0",
    })
    void requestsThatNobodyUnderstandsAreRefused(int subtype, int size) throws IOException {
        var raw = new Raw();
        raw.send(MessageKind.REQUEST, subtype, new byte[size]);
        Packet answer = raw.next();
        assertThat(answer.header().kind()).isEqualTo(MessageKind.NACK);
        assertThat(answer.header().subtype()).isEqualTo(subtype);
        assertThat(answer.header().address().interf()).isEqualTo(Interface.POSITION2D.code());
        assertThat(answer.body()).isEmpty();
    }

    @Test
    void aDriverThatIsNotThereIsRefusedWithoutABody() throws IOException {
        var raw = new Raw();
        raw.ask(Session.DRIVER, new Session.Driver(Address.of(Interface.LASER.code(), 7), new byte[0]));
        Packet answer = raw.next();
        assertThat(answer.header().kind()).isEqualTo(MessageKind.NACK);
        assertThat(answer.body()).isEmpty();
    }

    @Test
    void noDataComesBeforeAClientKnowsThatItWillGetSome() throws IOException {
        base.named = () -> publish(1); // between its wish and our answer
        var raw = new Raw();
        raw.ask(Session.DEVICE, new Session.Subscription(BASE, Session.OPEN, new byte[0]));
        assertThat(raw.next().header().kind()).isEqualTo(MessageKind.ACK);
        publish(2);
        assertThat(x(raw.next())).isEqualTo(2);
    }

    @Test
    void whatIsPushedComesAtOnce() throws IOException {
        Raw raw = subscribed();
        for (int i = 0; i < 5; i++) {
            publish(i);
        }
        for (int i = 0; i < 5; i++) {
            assertThat(x(raw.next())).isEqualTo(i);
        }
    }

    @Test
    void whatIsPulledComesInRoundsOfTheNewestEachWithAnEnd() throws IOException {
        Raw raw = subscribed();
        raw.ask(Session.MODE, new Session.Mode(Session.PULL));
        raw.nextAnswer();
        raw.ask(Session.REPLACE_RULE, new Session.ReplaceRule(-1, -1, 1, -1, Session.REPLACE));
        raw.nextAnswer();
        for (int i = 0; i < 50; i++) {
            publish(i);
        }
        raw.ask(Session.DATA);
        assertThat(raw.next().header().kind()).as("it says yes first").isEqualTo(MessageKind.ACK);
        assertThat(x(raw.next())).as("the newest").isEqualTo(49);
        assertThat(raw.next().header().kind()).isEqualTo(MessageKind.SYNCH);
        raw.ask(Session.DATA);
        assertThat(raw.next().header().kind()).isEqualTo(MessageKind.ACK);
        publish(50); // the round waited for it
        assertThat(x(raw.next())).isEqualTo(50);
        Packet synch = raw.next();
        assertThat(synch.header().kind()).isEqualTo(MessageKind.SYNCH);
        assertThat(synch.header().address()).isEqualTo(PLAYER);
    }

    @Test
    void whoDoesNotPullHearsOnlyAnswersAndWhatWasThereBefore() throws IOException {
        Raw raw = subscribed();
        raw.ask(Session.MODE, new Session.Mode(Session.PULL));
        raw.nextAnswer();
        publish(1);
        raw.ask(Session.DEVICES);
        assertThat(x(raw.next())).isEqualTo(1);
        assertThat(raw.next().header().subtype()).isEqualTo(Session.DEVICES);
        publish(2);
        raw.socket.setSoTimeout(300);
        assertThatThrownBy(raw::next).isInstanceOf(java.net.SocketTimeoutException.class);
    }

    @Test
    void whatIsTooMuchIsDroppedAndReported() throws IOException {
        Raw raw = subscribed();
        raw.ask(Session.MODE, new Session.Mode(Session.PULL));
        raw.nextAnswer();
        for (int i = 0; i < OutQueue.MOST + 76; i++) {
            publish(i);
        }
        raw.ask(Session.DATA);
        raw.next();
        for (int i = 0; i < OutQueue.MOST; i++) {
            assertThat(x(raw.next())).isEqualTo(i);
        }
        assertThat(raw.next().body(Session.Lost.class).messages()).isEqualTo(76);
    }

    @Test
    void whoIsGoneWantsNothingMore() throws Exception {
        Raw raw = subscribed();
        raw.ask(Session.DEVICE, new Session.Subscription(BASE, Session.OPEN, new byte[0]));
        raw.nextAnswer();
        assertThat(base.users).as("a client counts once").hasValue(1);
        raw.close();
        await().untilAsserted(() -> {
            assertThat(base.users).hasValue(0);
            assertThat(port.clients()).isZero();
        });
    }

    @Test
    void whoOnlyCommandsUsesADeviceUntilItIsGone() throws Exception {
        var raw = new Raw();
        var velocity = new Position2d.Velocity(new Pose(0.3, 0, 0.1), 1);
        for (int i = 0; i < 3; i++) {
            raw.send(Packet.of(BASE, MessageKind.COMMAND, Position2d.VELOCITY, 0, velocity)
                    .bytes());
            base.commands.poll(10, TimeUnit.SECONDS);
        }
        assertThat(base.users).hasValue(1);
        raw.close();
        assertThat(base.left.poll(10, TimeUnit.SECONDS)).isZero();
    }

    @Test
    void whoUnsubscribesUsesADeviceNoMoreThoughItCommandedIt() throws Exception {
        Raw raw = subscribed();
        raw.send(MessageKind.COMMAND, Position2d.VELOCITY, new byte[28]);
        base.commands.poll(10, TimeUnit.SECONDS);
        raw.ask(Session.DEVICE, new Session.Subscription(BASE, Session.CLOSE, new byte[0]));
        assertThat(raw.next().body(Session.Subscription.class).access()).isEqualTo(Session.CLOSE);
        assertThat(base.users).hasValue(0);
        raw.send(MessageKind.COMMAND, Position2d.VELOCITY, new byte[28]); // changes its mind
        base.commands.poll(10, TimeUnit.SECONDS);
        assertThat(base.users).hasValue(1);
    }

    @Test
    void whatIsUnknownOfTheServerIsRefused() throws IOException {
        var raw = new Raw();
        raw.ask(77);
        assertThat(raw.next().header().kind()).isEqualTo(MessageKind.NACK);
        raw.send(Packet.of(PLAYER, MessageKind.REQUEST, Session.DEVICES, 0)
                .withSequence(9)
                .bytes());
        assertThat(raw.next().header().sequence())
                .as("answers of the server repeat it")
                .isEqualTo(9);
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5})
    void aHostileClientDisturbsNobody(long seed) throws Exception {
        Raw good = subscribed();
        var random = new SplittableRandom(seed);
        for (int client = 0; client < 20; client++) {
            var bad = new Raw();
            var noise = new byte[1 + random.nextInt(5000)];
            random.nextBytes(noise);
            if (random.nextBoolean()) { // a header that is right, and what is not
                byte[] header = Packet.of(
                                BASE, MessageKind.REQUEST, random.nextInt(12), 0, new Session.Mode(random.nextInt()))
                        .bytes();
                bad.send(header);
                bad.ask(1 + random.nextInt(10), new Session.Lost(random.nextInt()));
            }
            bad.send(noise);
            bad.close();
        }
        publish(1);
        assertThat(x(good.next())).isEqualTo(1);
    }

    @Test
    void aClientThatAsksAndNeverReadsFillsNothing() throws Exception {
        Raw good = subscribed();
        var bad = new Raw();
        bad.socket.setSoTimeout(1000);
        var asked = new AtomicInteger();
        Thread flood = Thread.ofVirtual().start(() -> {
            try {
                while (!bad.socket.isClosed()) {
                    bad.ask(Session.DEVICES);
                    asked.incrementAndGet();
                }
            } catch (IOException e) {
                // closed
            }
        });
        var before = new AtomicInteger(-1);
        await().pollInterval(200, TimeUnit.MILLISECONDS)
                .until(() -> before.getAndSet(asked.get()) == asked.get() && asked.get() > 0); // nothing more is taken
        publish(1);
        assertThat(x(good.next())).isEqualTo(1);
        bad.close();
        flood.join();
    }

    @Test
    void whoOnlyHoldsAPlaceLosesItToSomebodyNewAndWhoUsesADeviceDoesNot() throws Exception {
        Raw user = subscribed();
        var first = new Raw();
        now.incrementAndGet(); // it is silent longest
        while (port.clients() < 64) {
            new Raw();
        }
        assertThat(isServed()).as("all have just come").isFalse();
        now.addAndGet(SILENT_FOR_LONG);
        assertThat(isServed()).isTrue();
        assertThat(port.clients()).isEqualTo(64);
        assertThat(first.in.read())
                .as("the one that was silent longest goes first")
                .isEqualTo(-1);
        publish(1);
        assertThat(x(user.next())).isEqualTo(1);
    }

    @Test
    void whoOnlyLooksLosesItsPlaceAfterThoseWhoDoNotAndWhoCommandsKeepsIt() throws Exception {
        Raw driver = subscribed();
        var velocity = new Position2d.Velocity(new Pose(0.3, 0, 0.1), 1);
        driver.send(Packet.of(BASE, MessageKind.COMMAND, Position2d.VELOCITY, 0, velocity)
                .bytes());
        assertThat(base.commands.poll(10, TimeUnit.SECONDS)).isNotNull();
        Raw viewer = subscribed();
        now.incrementAndGet(); // it is silent longest
        var idle = new Raw();
        now.incrementAndGet();
        while (port.clients() < 64) {
            subscribed();
        }
        now.addAndGet(SILENT_FOR_LONG);
        assertThat(isServed()).isTrue();
        assertThat(idle.in.read()).as("it uses no device").isEqualTo(-1);
        now.addAndGet(SILENT_FOR_LONG);
        new Raw(); // takes the place of the one that was served, which uses no device either
        assertThat(isServed()).isTrue();
        publish(1);
        assertThat(x(driver.next())).isEqualTo(1);
        assertThat(port.clients()).isEqualTo(64);
        assertThat(viewer.in.read()).as("the viewer that was silent longest").isEqualTo(-1);
    }

    private boolean isServed() throws IOException {
        var socket = new Socket();
        open.add(socket);
        socket.connect(address());
        socket.setSoTimeout(10_000);
        return socket.getInputStream().read() == 'P';
    }

    @Test
    void whoComesOnceItIsClosedIsNotServed() throws IOException {
        for (int round = 0; round < 100; round++) {
            listen();
            InetSocketAddress at = address();
            port.close();
            try (var socket = new Socket()) {
                socket.connect(at);
                socket.setSoTimeout(10_000);
                assertThat(socket.getInputStream().read()).isEqualTo(-1);
            } catch (SocketException e) {
                assertThat(e).hasMessageMatching("(?i)connection (refused|reset).*");
            }
        }
    }

    @Test
    void twoDevicesOfOneAddressAreRefused() {
        assertThatThrownBy(() -> new Port(
                        new InetSocketAddress(InetAddress.getLoopbackAddress(), 0),
                        List.of(base, new Base()),
                        Protocol.V3_1,
                        () -> 0,
                        now::get,
                        Runnable::run))
                .hasMessageContaining("two devices 'position2d:0'");
    }
}
