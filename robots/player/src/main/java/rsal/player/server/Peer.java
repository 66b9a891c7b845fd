package rsal.player.server;

import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.Socket;
import java.util.HashSet;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.Semaphore;
import java.util.concurrent.atomic.AtomicBoolean;
import org.jspecify.annotations.Nullable;
import rsal.player.message.Chars;
import rsal.player.message.Interface;
import rsal.player.message.Protocol;
import rsal.player.message.Session;
import rsal.player.server.Served.Answer;
import rsal.player.wire.Address;
import rsal.player.wire.Header;
import rsal.player.wire.Kind;
import rsal.player.wire.MalformedException;
import rsal.player.wire.Packet;

/// A client of one port. One thread reads what it wants, one writes what it gets. Whatever it does wrong is its own
/// loss: what can't be understood is left out, and what is no message ends the connection.
final class Peer {
    private static final int LARGEST = 1 << 20; // bytes of a body; no client has more to say
    private static final int CAPABILITY = 255; // a request to any device
    private static final int MOST_ASKED = 64; // of devices, without an answer yet; then it has to wait

    private final Socket socket;
    private final Port port;
    private final OutQueue out = new OutQueue();
    private final Set<Served> subscribed = new HashSet<>(); // guarded by itself
    private final Set<Served> commanded = new HashSet<>(); // of the thread that reads
    private final Semaphore asking = new Semaphore(MOST_ASKED);
    private final AtomicBoolean over = new AtomicBoolean();

    Peer(Socket socket, Port port) {
        this.socket = socket;
        this.port = port;
    }

    /// Serves it on threads of its own.
    void start() {
        Thread.ofVirtual().name("player peer reads").start(this::read);
        Thread.ofVirtual().name("player peer writes").start(this::write);
    }

    /// New data of a device, for whoever wants it.
    void data(Served device, Packet packet) {
        synchronized (subscribed) {
            if (!subscribed.contains(device)) {
                return;
            }
        }
        out.data(packet);
    }

    private void read() {
        try (InputStream in = new BufferedInputStream(socket.getInputStream())) {
            Optional<Packet> packet = Packet.read(in, LARGEST);
            while (packet.isPresent()) {
                out.awaitRoom();
                take(packet.get());
                packet = Packet.read(in, LARGEST);
            }
        } catch (IOException e) {
            // it has gone, or says what is no message: the same to us
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        } finally {
            end();
            commanded.forEach(Served::close);
        }
    }

    private void write() {
        try (OutputStream to = socket.getOutputStream()) {
            to.write(port.ident());
            Optional<Packet> next = out.take(port::time);
            while (next.isPresent()) {
                to.write(next.get().bytes());
                next = out.take(port::time);
            }
        } catch (IOException e) {
            // it has gone
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        } finally {
            end();
        }
    }

    void end() {
        if (!over.compareAndSet(false, true)) {
            return;
        }
        port.remove(this);
        out.close();
        asking.release(MOST_ASKED); // whoever reads does not wait for answers any more
        try {
            socket.close();
        } catch (IOException e) {
            // it is of no more use either way
        }
        Set<Served> left;
        synchronized (subscribed) {
            left = Set.copyOf(subscribed);
            subscribed.clear();
        }
        left.forEach(Served::close);
    }

    private void take(Packet packet) throws InterruptedException {
        Header header = packet.header();
        if (header.address().interf() == Interface.PLAYER.code()) {
            ask(packet);
            return;
        }
        Served device = port.device(header.address()).orElse(null);
        if (device == null || !isWhole(packet)) {
            return; // as Player does
        }
        if (header.kind() == Kind.COMMAND) {
            if (commanded.add(device)) {
                device.open(); // it is used until the client is gone, whether it wants its data or not
            }
            device.command(packet);
        } else if (header.kind() == Kind.REQUEST && header.subtype() == CAPABILITY) {
            reply(packet, device, capability(device, packet));
        } else if (header.kind() == Kind.REQUEST) {
            asking.acquire();
            device.ask(packet).whenComplete((answer, error) -> {
                reply(packet, device, error == null ? answer : null);
                asking.release();
            });
        }
    }

    private static boolean isWhole(Packet packet) {
        if (packet.body().length == 0 || packet.header().subtype() == CAPABILITY) {
            return true;
        }
        try {
            return Protocol.V3_1.read(packet).isPresent();
        } catch (MalformedException e) {
            return false;
        }
    }

    private static Answer capability(Served device, Packet packet) {
        try {
            var asked = packet.body(Session.Capability.class);
            return device.understands(Kind.of(asked.type()), asked.subtype())
                    ? new Answer.Done()
                    : new Answer.Refused();
        } catch (MalformedException e) {
            return new Answer.Refused();
        }
    }

    private void reply(Packet request, Served device, @Nullable Answer answer) {
        Address address = port.address(device);
        int subtype = request.header().subtype();
        out.answer(
                switch (answer) {
                    case Answer.Done _ -> Packet.of(address, Kind.ACK, subtype, port.time());
                    case Answer.Told(Record body) -> Packet.of(address, Kind.ACK, subtype, port.time(), body);
                    case Answer.Refused _ -> Packet.of(address, Kind.NACK, subtype, port.time());
                    case null -> Packet.of(address, Kind.NACK, subtype, port.time());
                });
    }

    /// Something of the server itself.
    private void ask(Packet request) {
        try {
            if (request.header().kind() != Kind.REQUEST) {
                answer(request, Kind.NACK, null);
                return;
            }
            switch (request.header().subtype()) {
                case Session.DEVICES -> answer(request, Kind.ACK, new Session.Devices(port.addresses()));
                case Session.DRIVER ->
                    driver(request, request.body(Session.Driver.class).device());
                case Session.DEVICE -> subscribe(request, request.body(Session.Subscription.class));
                case Session.DATA -> out.round(packet(request, Kind.ACK, null));
                case Session.MODE -> {
                    out.mode(request.body(Session.Mode.class).mode() == Session.PULL);
                    answer(request, Kind.ACK, null);
                }
                case Session.REPLACE_RULE ->
                    answer(request, out.add(request.body(Session.ReplaceRule.class)) ? Kind.ACK : Kind.NACK, null);
                default -> answer(request, Kind.NACK, null);
            }
        } catch (MalformedException e) {
            answer(request, Kind.NACK, null);
        }
    }

    private void driver(Packet request, Address asked) {
        Optional<Served> device = port.device(asked);
        if (device.isPresent()) {
            Address address = port.address(device.get());
            answer(
                    request,
                    Kind.ACK,
                    new Session.Driver(address, Chars.of(device.get().driver())));
        } else {
            answer(request, Kind.NACK, new Session.Driver(asked, new byte[0]));
        }
    }

    private void subscribe(Packet request, Session.Subscription asked) {
        Served device = port.device(asked.device()).orElse(null);
        if (device == null) {
            answer(request, Kind.NACK, new Session.Subscription(asked.device(), Session.ERROR, new byte[0]));
        } else if (asked.access() == Session.OPEN) {
            device.open().whenComplete((works, error) -> opened(request, device, error == null && works));
        } else {
            boolean was;
            synchronized (subscribed) {
                was = subscribed.remove(device);
            }
            if (was) {
                device.close();
            }
            grant(request, device, Session.CLOSE);
        }
    }

    private void opened(Packet request, Served device, boolean works) {
        boolean more;
        synchronized (subscribed) {
            more = works && !over.get() && subscribed.add(device);
        }
        if (works && !more) {
            device.close(); // it wants it already, or is gone
        }
        grant(request, device, works ? Session.OPEN : Session.ERROR);
    }

    private void grant(Packet request, Served device, int access) {
        Address address = port.address(device);
        answer(request, Kind.ACK, new Session.Subscription(address, access, Chars.of(device.driver())));
    }

    private void answer(Packet request, Kind kind, @Nullable Record body) {
        out.answer(packet(request, kind, body));
    }

    private Packet packet(Packet request, Kind kind, @Nullable Record body) {
        Address address = port.address(Interface.PLAYER, 0);
        int subtype = request.header().subtype();
        Packet packet = body == null
                ? Packet.of(address, kind, subtype, port.time())
                : Packet.of(address, kind, subtype, port.time(), body);
        return packet.withSequence(request.header().sequence());
    }
}
