package rsal.player.bridge;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import rsal.device.DriveBase;
import rsal.player.client.Connection;
import rsal.player.client.Delivery;
import rsal.player.client.RefusedException;
import rsal.player.message.Interface;
import rsal.player.message.Protocol;
import rsal.player.wire.Address;
import rsal.player.wire.Header;
import rsal.player.wire.MessageKind;
import rsal.player.wire.Packet;
import rsal.scene.RobotService;
import rsal.system.BridgeContext;
import rsal.system.CommandTimeout;
import rsal.system.ExportedDevice;
import rsal.testkit.contract.RobotBench;

/// A robot that is offered, and a Player client on the other side of a socket.
abstract class BridgeBench extends RobotBench {
    static final Address BASE = Address.of(Interface.POSITION2D.code(), 0);

    private static final int BABBLE = 3000; // messages
    private static final int[] SIZES = {0, 4, 8, 16, 20, 24, 28, 32, 36, 52, 72, 76, 100
    }; // of bodies; of most there are
    private static final double[] NUMBERS = {
        0,
        1,
        -1,
        3,
        1e-300,
        1e9,
        1e300,
        -1e300,
        Double.MAX_VALUE,
        Double.NaN,
        Double.POSITIVE_INFINITY,
        Double.NEGATIVE_INFINITY
    };

    private final Map<Integer, Packet> newest = new ConcurrentHashMap<>(); // by interface
    private final Map<Address, Packet> newestOf = new ConcurrentHashMap<>();
    private PlayerBridge bridge;
    private Connection client;

    /// What is offered; empty for all.
    List<RobotService> services() {
        return List.of();
    }

    /// That its clients are taken to speak.
    Protocol protocol() {
        return Protocol.V3_1;
    }

    final Connection client() {
        return client;
    }

    final PlayerBridge bridge() {
        return bridge;
    }

    final List<ExportedDevice> offers() {
        return bridge.offers();
    }

    /// For how long clients' commands hold.
    protected CommandTimeout timeout() {
        return CommandTimeout.none();
    }

    final int port() {
        return bridge.offers().getFirst().port();
    }

    @BeforeEach
    final void open() throws IOException {
        bridge = PlayerBridge.open(
                new InetSocketAddress(InetAddress.getLoopbackAddress(), 0),
                new BridgeContext(List.of(robot()), WORLD.grid(), system().simulation(), services(), timeout()),
                protocol(),
                run);
        client = Connection.open(
                new InetSocketAddress(
                        InetAddress.getLoopbackAddress(),
                        bridge.offers().getFirst().port()),
                Delivery.PULL,
                Duration.ofSeconds(5),
                this::hear);
    }

    private void hear(Packet packet) {
        newest.put(packet.header().address().interf(), packet);
        newestOf.put(
                Address.of(
                        packet.header().address().interf(),
                        packet.header().address().index()),
                packet);
    }

    /// What a device has told last.
    final <T extends Record> Optional<T> newestOf(Address device, Class<T> type) {
        return Optional.ofNullable(newestOf.get(device)).map(packet -> {
            try {
                return packet.body(type);
            } catch (IOException e) {
                throw new AssertionError(e);
            }
        });
    }

    @AfterEach
    final void close() {
        client.close();
        bridge.close();
    }

    /// Lets simulated time pass until something is so.
    final void until(BooleanSupplier isSo) throws InterruptedException {
        for (int step = 0; step < 3000 && !isSo.getAsBoolean(); step++) {
            run.advance(STEP);
            TimeUnit.MILLISECONDS.sleep(2); // for the network
        }
        assertThat(isSo.getAsBoolean()).isTrue();
    }

    final <T> T answer(CompletionStage<T> stage) throws InterruptedException {
        var future = stage.toCompletableFuture();
        until(future::isDone);
        return future.join();
    }

    final void subscribe(Interface interf) throws InterruptedException {
        answer(client.subscribe(Address.of(interf.code(), 0)));
        until(() -> newest.containsKey(interf.code()));
    }

    final <T extends Record> T reported(Interface interf, Class<T> type) throws IOException, InterruptedException {
        if (!newest.containsKey(interf.code())) {
            subscribe(interf);
        }
        return newest.get(interf.code()).body(type);
    }

    final <T extends Record> T asked(Interface interf, int subtype, Class<T> type)
            throws IOException, InterruptedException {
        Packet request = Packet.of(Address.of(interf.code(), 0), MessageKind.REQUEST, subtype, 0);
        return answer(client.ask(request)).body(type);
    }

    final void command(int subtype, Record body) {
        client.command(Packet.of(BASE, MessageKind.COMMAND, subtype, 0, body));
    }

    /// What it was told last, subscribing first.
    final <T extends Record> T newest(Interface interf, Class<T> type) {
        try {
            return reported(interf, type);
        } catch (IOException e) {
            throw new AssertionError(e);
        } catch (InterruptedException e) {
            throw new AssertionError("Nobody interrupts a test.", e);
        }
    }

    final <T extends Record> Packet ask(Interface interf, int subtype, T body) throws InterruptedException {
        return answer(client.ask(Packet.of(Address.of(interf.code(), 0), MessageKind.REQUEST, subtype, 0, body)));
    }

    final <T extends Record> void refused(Interface interf, int subtype, T body) {
        assertThatThrownBy(() -> ask(interf, subtype, body)).hasCauseInstanceOf(RefusedException.class);
    }

    /// @param driver that it should have all the same
    final void assertBabbleDisturbsNobody(long seed, String driver) throws Exception {
        subscribe(Interface.POSITION2D);
        babble(seed);
        assertThat(truth().isFinite()).isTrue();
        robot().require(DriveBase.class).enable(true);
        assertThat(answer(client.driver(BASE))).isEqualTo(driver);
        run.advance(STEP);
        robot().devices()
                .forEach(device -> assertThat(device.health().isOk())
                        .as(device.info().id())
                        .isTrue());
    }

    /// Says all kinds of things to all devices, with bodies that are as they should be but for what is in them.
    final void babble(long seed) throws IOException, InterruptedException {
        var random = new SplittableRandom(seed);
        var devices = answer(client.devices());
        try (var socket = new Socket(InetAddress.getLoopbackAddress(), port())) {
            OutputStream out = socket.getOutputStream();
            for (int i = 0; i < BABBLE; i++) {
                Address device = devices.get(random.nextInt(devices.size()));
                MessageKind kind = random.nextBoolean() ? MessageKind.COMMAND : MessageKind.REQUEST;
                byte[] body = body(random);
                var header = new Header(
                        Address.of(device.interf(), device.index()), kind, random.nextInt(10), 0, 0, body.length);
                out.write(new Packet(header, body).bytes());
                if (i % 100 == 0) {
                    run.advance(STEP);
                    socket.getInputStream().skipNBytes(socket.getInputStream().available());
                }
            }
            socket.shutdownOutput();
        }
        answer(client.devices());
    }

    private static byte[] body(SplittableRandom random) {
        var body = ByteBuffer.allocate(SIZES[random.nextInt(SIZES.length)]);
        while (body.remaining() >= Double.BYTES) {
            switch (random.nextInt(3)) {
                case 0 -> body.putDouble(NUMBERS[random.nextInt(NUMBERS.length)]);
                case 1 -> body.putInt(random.nextInt(4)).putInt(random.nextInt(-1, 4));
                default -> body.putLong(random.nextLong());
            }
        }
        return body.array();
    }
}
