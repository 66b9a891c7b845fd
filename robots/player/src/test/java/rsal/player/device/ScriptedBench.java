package rsal.player.device;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import java.util.function.Supplier;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import rsal.device.DeviceInfo;
import rsal.player.Waiting;
import rsal.player.client.Delivery;
import rsal.player.client.ScriptedServer;
import rsal.player.message.Session;
import rsal.player.wire.Address;
import rsal.player.wire.Packet;
import rsal.time.WallScheduler;

/// Our side of a server that says what a test has it say.
abstract class ScriptedBench {
    static final String IDENT = "Player v.3.1.0";

    private final List<Throwable> failures = new ArrayList<>();
    final WallScheduler time = new WallScheduler("test", Runnable::run, failures::add);
    private final List<Address> devices;
    private ScriptedServer server;
    ScriptedServer.Client client;
    RemoteServer remote;

    /// @param devices that the server has
    ScriptedBench(Address... devices) {
        this.devices = List.of(devices);
    }

    @BeforeEach
    final void connect() throws IOException {
        server = new ScriptedServer();
        remote = new RemoteServer("localhost", server.address().getPort(), Delivery.PUSH, time);
        time.every(RemoteServer.LOOK, () -> remote.look(time.instant()));
    }

    @AfterEach
    final void close() throws IOException {
        remote.close();
        client.close();
        server.close();
        time.close();
        assertThat(failures).isEmpty();
    }

    /// Waits for whoever connects.
    final void accept(String ident) throws IOException {
        client = server.accept(ident);
    }

    /// Tells whoever connects which devices there are.
    final void meet(String ident) throws IOException {
        accept(ident);
        client.acknowledge(client.next(Session.SERVER, Session.DEVICES), new Session.Devices(devices));
    }

    /// Waits until it is known on our side which devices there are.
    final void awaitKnown() {
        remote.known(Duration.ofSeconds(10)).toCompletableFuture().join();
    }

    /// Lets whoever asks have the data of the first device.
    final void start() throws IOException {
        Packet asked = client.next(Session.SERVER, Session.DEVICE);
        client.acknowledge(asked, new Session.Subscription(devices.getFirst(), Session.OPEN, new byte[0]));
    }

    static DeviceInfo info(String name) {
        return new DeviceInfo("r1", name, "player");
    }

    /// What comes of something that is done on the scheduler's thread.
    final <T> T on(Supplier<T> work) {
        return CompletableFuture.supplyAsync(work, time)
                .orTimeout(20, TimeUnit.SECONDS)
                .join();
    }

    /// The first value that holds.
    final <T> T until(Supplier<T> value, Predicate<T> holds) {
        return Waiting.until(time, value, holds);
    }

    final void run(Runnable work) {
        on(() -> {
            work.run();
            return true;
        });
    }
}
