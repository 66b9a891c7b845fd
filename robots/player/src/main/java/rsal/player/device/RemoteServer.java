package rsal.player.device;

import java.io.IOException;
import java.time.Duration;
import java.time.Instant;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import rsal.device.Listeners;
import rsal.device.Subscription;
import rsal.player.client.Connection;
import rsal.player.client.Delivery;
import rsal.player.client.ServerLink;
import rsal.player.wire.Address;
import rsal.player.wire.MalformedException;
import rsal.player.wire.MessageKind;
import rsal.player.wire.Packet;
import rsal.time.Scheduler;

/// A Player server as those here know it who stand for its devices: they are told what is new, and have what
/// they want sent, as long as there is a connection. All on the scheduler's thread, where of each kind of data
/// the newest counts that was not looked at yet: however slow that is, nothing grows and nothing is old.
public final class RemoteServer implements AutoCloseable {
    private static final System.Logger LOG = System.getLogger(RemoteServer.class.getName());
    private static final Duration SETUP = Duration.ofSeconds(10); // drivers may take seconds to begin
    private static final Duration PATIENCE = Duration.ofSeconds(2); // with answers

    /// How often [#look] is called.
    public static final Duration LOOK = Duration.ofMillis(50);

    private final String name;
    private final Scheduler scheduler;
    private final ServerLink link;
    private volatile ServerClock clock = new ServerClock(); // of this connection: each server has a time of its own
    private final Map<Address, List<Member>> members = new ConcurrentHashMap<>(); // robots may share a device
    private final Map<Key, DeviceData> newest = new LinkedHashMap<>(); // guarded by itself
    private final CompletableFuture<ServerOffer> offer = new CompletableFuture<>();
    private final Listeners<Optional<String>> listeners =
            new Listeners<>(e -> LOG.log(System.Logger.Level.ERROR, "A listener of a Player server failed.", e));
    private volatile @Nullable Connection connection; // set on the scheduler's thread
    private String reason = "Nobody has answered yet.";

    private record Key(Member member, int subtype) {}

    private record DeviceData(Member member, Instant time, Record body) {}

    /// A device with whether it gets data.
    private static final class Member {
        private final Remote device;
        private volatile boolean ready;

        Member(Remote device) {
            this.device = device;
        }
    }

    /// Begins to look for the server.
    public RemoteServer(String host, int port, Delivery delivery, Scheduler scheduler) {
        this.name = host + ":" + port;
        this.scheduler = scheduler;
        this.link = new ServerLink(host, port, delivery, new Line());
        link.start();
    }

    /// `localhost:6665`
    public String name() {
        return name;
    }

    /// What it has; only once that is [known][#known].
    ServerOffer offer() {
        return offer.join();
    }

    /// Completes when it is known what the server has, which is so from the first connection on; exceptionally
    /// when there is none for too long.
    public CompletionStage<Void> known(Duration patience) {
        return scheduler.within(patience, offer).handle((_, error) -> {
            if (error != null) {
                throw new CompletionException(new IOException(
                        "There is no Player server at '%s': %s. Start the robot's server; or serve simulated robots: rsal bridge player SCENARIO --no-agents."
                                .formatted(name, reason),
                        error));
            }
            return null;
        });
    }

    /// Completes when it is known what the server has, whenever that is.
    public CompletionStage<Void> known() {
        return offer.thenAccept(_ -> {});
    }

    /// Why there is no connection, when there is none.
    String reason() {
        return reason;
    }

    public boolean isConnected() {
        return connection != null;
    }

    /// Tells of each change: why it is lost, or empty when there is a connection.
    public Subscription onChange(Consumer<Optional<String>> listener) {
        return listeners.add(listener);
    }

    /// Has a device get its data from now on, and again each time when the connection is back.
    ///
    /// @return when it does first; exceptionally when the server has no such device, or its driver does not
    /// start
    CompletionStage<Void> add(Remote device) {
        var member = new Member(device);
        members.computeIfAbsent(device.address(), _ -> new CopyOnWriteArrayList<>())
                .add(member);
        Connection now = connection;
        return now == null ? CompletableFuture.failedStage(new IOException(reason)) : connect(member, now);
    }

    private Stream<Member> members() {
        return members.values().stream().flatMap(List::stream);
    }

    private CompletionStage<Void> connect(Member member, Connection over) {
        Remote device = member.device;
        return scheduler
                .within(SETUP, over.subscribe(device.address()))
                .thenCompose(_ -> ask(device, over))
                .whenComplete((_, error) -> {
                    if (over.equals(connection)) {
                        member.ready = error == null;
                        if (error == null) {
                            device.connected();
                        } else {
                            device.lost(words(error));
                        }
                    }
                });
    }

    /// Asks one question after the other; a server need not answer them.
    private CompletionStage<Void> ask(Remote device, Connection over) {
        CompletionStage<Void> asked = CompletableFuture.completedStage(null);
        for (int question : device.questions()) {
            Packet request = Packet.of(device.address(), MessageKind.REQUEST, question, 0);
            asked = asked.thenCompose(_ -> scheduler.within(PATIENCE, over.ask(request)))
                    .handle((answer, error) -> {
                        if (error == null) {
                            read(over, answer).ifPresent(device::answered);
                        }
                        return null;
                    });
        }
        return asked;
    }

    private static Optional<Record> read(Connection over, Packet packet) {
        try {
            return over.protocol().readAsNewest(packet);
        } catch (MalformedException e) {
            LOG.log(System.Logger.Level.DEBUG, "A message of a Player server is ignored.", e);
            return Optional.empty();
        }
    }

    /// What went wrong, for people.
    public static String words(Throwable error) {
        Throwable cause = error instanceof CompletionException && error.getCause() != null ? error.getCause() : error;
        return String.valueOf(cause.getMessage());
    }

    /// Asks something of a device.
    ///
    /// @param body in the words of the newest version of the protocol; empty when there is none
    /// @return the answer's body, if it has any; exceptionally when the server refuses, has no connection or
    /// says nothing
    CompletionStage<Optional<Record>> ask(Address device, int subtype, Optional<Record> body) {
        return ask(device, subtype, body, PATIENCE);
    }

    /// The same with something that may take longer.
    CompletionStage<Optional<Record>> ask(Address device, int subtype, Optional<Record> body, Duration patience) {
        Connection now = connection;
        if (now == null) {
            return CompletableFuture.failedStage(new IOException(reason));
        }
        Packet request = body.map(said -> packet(now, device, MessageKind.REQUEST, subtype, said))
                .orElseGet(() -> Packet.of(device, MessageKind.REQUEST, subtype, 0));
        return scheduler.within(patience, now.ask(request)).thenApply(answer -> read(now, answer));
    }

    /// Sends a command, if there is a connection.
    ///
    /// @param body in the words of the newest version of the protocol
    void command(Address device, int subtype, Record body) {
        Connection now = connection;
        if (now != null) {
            now.command(packet(now, device, MessageKind.COMMAND, subtype, body));
        }
    }

    /// Sends a command that says no more, if there is a connection.
    void command(Address device, int subtype) {
        Connection now = connection;
        if (now != null) {
            now.command(Packet.of(device, MessageKind.COMMAND, subtype, 0));
        }
    }

    /// What is to be done with a device.
    ///
    /// @param body in the words of the newest version of the protocol; empty when the command says no more
    record Order(int subtype, Optional<Record> body) {}

    /// Sends commands that make sense together only, if there is a connection.
    void commands(Address device, List<Order> together) {
        Connection now = connection;
        if (now != null) {
            now.commands(
                    device,
                    together.stream()
                            .map(order -> order.body()
                                    .map(said -> packet(now, device, MessageKind.COMMAND, order.subtype(), said))
                                    .orElseGet(() -> Packet.of(device, MessageKind.COMMAND, order.subtype(), 0)))
                            .toList());
        }
    }

    private static Packet packet(Connection over, Address device, MessageKind kind, int subtype, Record body) {
        return Packet.of(device, kind, subtype, 0, over.protocol().worded(body));
    }

    /// Time has passed.
    public void look(Instant now) {
        members().forEach(member -> member.device.look(now));
    }

    /// Completes when the server has got all that was sent, and what it had sent is waiting for the scheduler's
    /// thread; at once when there is no connection.
    public CompletionStage<Void> settled() {
        Connection now = connection;
        return now == null ? CompletableFuture.completedStage(null) : now.settled();
    }

    private void connected(Connection now, ServerOffer found) {
        connection = now;
        offer.complete(found);
        members().forEach(member -> connect(member, now));
        listeners.publish(Optional.empty());
    }

    private void lost(String why) {
        boolean was = connection != null;
        connection = null;
        reason = why;
        if (was) { // else they know, and why at first
            members().forEach(member -> {
                member.ready = false;
                member.device.lost(why);
            });
            listeners.publish(Optional.of(why));
        }
    }

    private void deliver() {
        List<DeviceData> all;
        synchronized (newest) {
            all = List.copyOf(newest.values());
            newest.clear();
        }
        var touched = new LinkedHashSet<Remote>();
        for (DeviceData one : all) {
            if (one.member.ready) {
                one.member.device.take(one.time, one.body);
                touched.add(one.member.device);
            }
        }
        touched.forEach(Remote::delivered);
    }

    /// Lets go of the server; what was commanded before still goes out. Nothing is told any more.
    @Override
    public void close() {
        link.close();
        connection = null;
        reason = "It was closed.";
        members().forEach(member -> member.device.lost(reason));
        members.clear();
    }

    /// What comes over the network, on its threads.
    private final class Line implements ServerLink.Listener {
        @Override
        public void connected(Connection now) throws IOException {
            clock = new ServerClock();
            ServerOffer found = ServerInspection.of(now);
            scheduler.execute(() -> RemoteServer.this.connected(now, found));
        }

        @Override
        public void lost(String why) {
            scheduler.execute(() -> RemoteServer.this.lost(why));
        }

        @Override
        public void data(Packet packet) {
            Address from = packet.header().address();
            List<Member> wanting = members.getOrDefault(Address.of(from.interf(), from.index()), List.of()).stream()
                    .filter(member -> member.ready)
                    .toList();
            Connection over = connection;
            if (wanting.isEmpty() || over == null) {
                return;
            }
            read(over, packet).ifPresent(body -> {
                Instant taken = clock.taken(packet.header().time(), scheduler.instant());
                boolean first;
                synchronized (newest) {
                    first = newest.isEmpty();
                    wanting.forEach(member -> newest.put(
                            new Key(member, packet.header().subtype()), new DeviceData(member, taken, body)));
                }
                if (first) {
                    scheduler.execute(RemoteServer.this::deliver);
                }
            });
        }
    }
}
