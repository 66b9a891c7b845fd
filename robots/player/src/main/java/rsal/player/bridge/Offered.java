package rsal.player.bridge;

import java.time.Instant;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import org.jspecify.annotations.Nullable;
import rsal.device.DeviceInfo;
import rsal.device.Subscription;
import rsal.player.message.Box3;
import rsal.player.message.Interface;
import rsal.player.server.Port;
import rsal.player.server.ServedDevice;
import rsal.player.wire.MalformedException;
import rsal.player.wire.MessageKind;
import rsal.player.wire.Packet;
import rsal.time.Scheduler;

/// A device of one of our robots under one interface of Player's. All of it but what is handed over by
/// [ServedDevice] lives on the scheduler's thread.
abstract class Offered implements ServedDevice {
    /// Stands for a size that is not known.
    static final Box3 NO_SIZE = new Box3(0, 0, 0);

    private final Interface interf;
    private final int index;
    private final DeviceInfo device;
    private final Scheduler scheduler;
    private final Map<Integer, Packet> commands = new LinkedHashMap<>(); // by subtype, newest last; guarded by itself
    private String driver;
    private @Nullable Port port;
    private int users;

    Offered(Interface interf, int index, DeviceInfo device, Scheduler scheduler) {
        this.interf = interf;
        this.index = index;
        this.device = device;
        this.driver = device.driver();
        this.scheduler = scheduler;
    }

    /// The same, of which clients are told that another drives it. Before it has any.
    final Offered drivenBy(String other) {
        driver = other;
        return this;
    }

    /// Tells a port's clients of its data from now on.
    final Subscription begin(Port on) {
        port = on;
        return listen();
    }

    /// Publishes whatever its device tells.
    abstract Subscription listen();

    /// What it answers to a request; empty when it does not know such.
    abstract Optional<Answer> answer(Packet request) throws MalformedException;

    /// Does what a client wants.
    void obey(Packet command) throws MalformedException {}

    /// A command came from a client; it is obeyed later. On the thread that reads.
    void heard(Packet command) {}

    /// No client wants it any more, or the one that commanded it last does not: nobody is there to mind what it does.
    void idle() {}

    /// Ours.
    final String device() {
        return device.id();
    }

    final Scheduler scheduler() {
        return scheduler;
    }

    final void publish(int subtype, Instant time, Record body) {
        if (port != null) {
            port.publish(this, subtype, seconds(time), body);
        }
    }

    static double seconds(Instant time) {
        return time.getEpochSecond() + time.getNano() / 1e9;
    }

    @Override
    public final Interface interf() {
        return interf;
    }

    @Override
    public final int index() {
        return index;
    }

    @Override
    public final String driver() {
        return driver;
    }

    @Override
    public final CompletionStage<Boolean> open() {
        var works = new CompletableFuture<Boolean>();
        scheduler.execute(() -> {
            users++;
            starts().thenAccept(works::complete);
        });
        return works;
    }

    /// Whether it works, once that is known.
    CompletionStage<Boolean> starts() {
        return CompletableFuture.completedStage(true);
    }

    @Override
    public final void close() {
        scheduler.execute(() -> {
            users--;
            if (users == 0) {
                idle();
            }
        });
    }

    @Override
    public final void forsaken() {
        scheduler.execute(this::idle);
    }

    @Override
    public CompletionStage<Answer> ask(Packet request) {
        var result = new CompletableFuture<Answer>();
        scheduler.execute(() -> {
            try {
                result.complete(answer(request).orElseGet(Answer.Refused::new));
            } catch (MalformedException | RuntimeException e) {
                result.complete(new Answer.Refused());
            }
        });
        return result;
    }

    /// Of those that were not done yet the newest of each kind counts, so that nothing grows however many come.
    @Override
    public final void command(Packet command) {
        heard(command);
        boolean first;
        synchronized (commands) {
            first = commands.isEmpty();
            commands.remove(command.header().subtype()); // it stands behind older ones of other kinds
            commands.put(command.header().subtype(), command);
        }
        if (first) {
            scheduler.execute(this::obey);
        }
    }

    private void obey() {
        List<Packet> wanted;
        synchronized (commands) {
            wanted = List.copyOf(commands.values());
            commands.clear();
        }
        for (Packet command : wanted) {
            try {
                obey(command);
            } catch (MalformedException | IllegalArgumentException e) {
                // a client's error is nobody else's: as Player does, it is left out
            }
        }
    }

    @Override
    public boolean understands(MessageKind kind, int subtype) {
        return false;
    }
}
