package rsal.player.server;

import java.io.BufferedInputStream;
import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.Socket;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.Semaphore;
import java.util.concurrent.atomic.AtomicBoolean;
import org.jspecify.annotations.Nullable;
import rsal.player.message.Chars;
import rsal.player.message.Interface;
import rsal.player.message.Protocol;
import rsal.player.message.Session;
import rsal.player.server.ServedDevice.Answer;
import rsal.player.wire.Address;
import rsal.player.wire.Header;
import rsal.player.wire.MalformedException;
import rsal.player.wire.MessageKind;
import rsal.player.wire.Packet;

/// A client of one port. One thread reads what it wants, one writes what it gets. Whatever it does wrong is its
/// own loss: what can't be understood is left out, and what is not a message ends the connection.
final class Peer {
    private static final int LARGEST = 1 << 20; // bytes of a body; no client has more to say
    private static final int CAPABILITY = 255; // a request to any device
    private static final int MOST_ASKED = 64; // of devices, without an answer yet; then it has to wait

    private final Socket socket;
    private final Port port;
    private final OutQueue out;
    private final Set<ServedDevice> subscribed = new HashSet<>(); // guarded by itself
    private final Set<ServedDevice> commanded = ConcurrentHashMap.newKeySet(); // changed by the thread that reads
    private final Semaphore asking = new Semaphore(MOST_ASKED);
    private final AtomicBoolean over = new AtomicBoolean();
    private volatile Protocol protocol; // as far as it has shown
    private volatile long heardAt; // last [ns]

    Peer(Socket socket, Port port) {
        this.socket = socket;
        this.port = port;
        this.out = new OutQueue(port::time, port::now);
        this.heardAt = port.now();
        this.protocol = port.protocol();
    }

    /// Serves it on threads of its own.
    void start() {
        Thread.ofVirtual().name("player peer reads").start(this::read);
        Thread.ofVirtual().name("player peer writes").start(this::write);
    }

    /// New data that came about at the same time, for those that want some of it.
    void data(List<DeviceData> data) {
        synchronized (subscribed) {
            out.data(data.stream()
                    .filter(each -> subscribed.contains(each.device()))
                    .map(each -> each.in(protocol))
                    .toList());
        }
    }

    /// How long it has said nothing [ns].
    long silence(long now) {
        return now - heardAt;
    }

    /// Whether it has subscribed to a device.
    boolean uses() {
        synchronized (subscribed) {
            return !subscribed.isEmpty();
        }
    }

    /// Whether it has commanded a device and not given it back.
    boolean commands() {
        return !commanded.isEmpty();
    }

    boolean isBehind() {
        return out.isBehind();
    }

    private void read() {
        try (InputStream in = new BufferedInputStream(socket.getInputStream())) {
            Optional<Packet> packet = Packet.read(in, LARGEST);
            while (packet.isPresent()) {
                heardAt = port.now();
                out.awaitRoom();
                take(packet.get());
                packet = Packet.read(in, LARGEST);
            }
        } catch (IOException e) {
            // it has gone, or says what is not a message: the same to us
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        } finally {
            end();
            commanded.forEach(device -> port.givesBack(this, device));
        }
    }

    /// What waits at the same time goes out at once.
    private void write() {
        try (OutputStream to = new BufferedOutputStream(socket.getOutputStream())) {
            to.write(port.ident());
            to.flush();
            Optional<Packet> next = out.take();
            while (next.isPresent()) {
                to.write(next.get().bytes());
                if (out.isIdle()) {
                    to.flush();
                }
                next = out.take();
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
        asking.release(MOST_ASKED); // the one that reads does not wait for answers any more
        try {
            socket.close();
        } catch (IOException e) {
            // it is of no more use either way
        }
        Set<ServedDevice> left;
        synchronized (subscribed) {
            left = Set.copyOf(subscribed);
            subscribed.clear();
        }
        left.forEach(ServedDevice::close);
    }

    private void take(Packet packet) throws InterruptedException {
        Header header = packet.header();
        if (header.address().interf() == Interface.PLAYER.code()) {
            ask(packet);
            return;
        }
        ServedDevice device = port.device(header.address()).orElse(null);
        if (device == null) {
            return; // as Player does
        }
        if (header.kind() == MessageKind.REQUEST && header.subtype() == CAPABILITY) {
            reply(packet, device, capability(device, packet));
            return;
        }
        protocol = protocol.ofSender(packet);
        try {
            hand(protocol.asNewest(packet), device);
        } catch (MalformedException e) {
            if (header.kind() == MessageKind.REQUEST) { // kinder than Player: there are clients that wait forever
                reply(packet, device, new Answer.Refused());
            }
        }
    }

    private void hand(Packet packet, ServedDevice device) throws InterruptedException {
        if (packet.header().kind() == MessageKind.COMMAND) {
            if (commanded.add(device)) {
                device.open(); // used until the client gives it back, whether it wants its data or not
            }
            port.commands(this, device);
            device.command(packet);
        } else if (packet.header().kind() == MessageKind.REQUEST) {
            asking.acquire();
            device.ask(packet).whenComplete((answer, error) -> {
                reply(packet, device, error == null ? answer : null);
                asking.release();
            });
        }
    }

    private static Answer capability(ServedDevice device, Packet packet) {
        try {
            var asked = packet.start(Session.Capability.class);
            return device.understands(MessageKind.of(asked.type()), asked.subtype())
                    ? new Answer.Done()
                    : new Answer.Refused();
        } catch (MalformedException e) {
            return new Answer.Refused();
        }
    }

    private void reply(Packet request, ServedDevice device, @Nullable Answer answer) {
        Address address = port.address(device);
        int subtype = request.header().subtype();
        out.answer(
                switch (answer) {
                    case Answer.Done _ -> Packet.of(address, MessageKind.ACK, subtype, port.time());
                    case Answer.Reported(Record body) ->
                        Packet.of(address, MessageKind.ACK, subtype, port.time(), protocol.worded(body));
                    case Answer.Refused _ -> Packet.of(address, MessageKind.NACK, subtype, port.time());
                    case null -> Packet.of(address, MessageKind.NACK, subtype, port.time());
                });
    }

    /// Something of the server itself.
    private void ask(Packet request) throws InterruptedException {
        try {
            if (request.header().kind() != MessageKind.REQUEST) {
                answer(request, MessageKind.NACK, null);
                return;
            }
            switch (request.header().subtype()) {
                case Session.DEVICES -> answer(request, MessageKind.ACK, new Session.Devices(port.addresses()));
                case Session.DRIVER ->
                    driver(request, request.start(Session.Driver.class).device());
                case Session.DEVICE -> subscribe(request, request.start(Session.Subscription.class));
                case Session.DATA -> out.round(packet(request, MessageKind.ACK, null));
                case Session.MODE -> {
                    out.mode(request.start(Session.Mode.class).mode() == Session.PULL);
                    answer(request, MessageKind.ACK, null);
                }
                case Session.REPLACE_RULE ->
                    answer(
                            request,
                            out.add(request.start(Session.ReplaceRule.class)) ? MessageKind.ACK : MessageKind.NACK,
                            null);
                default -> answer(request, MessageKind.NACK, null);
            }
        } catch (MalformedException e) {
            answer(request, MessageKind.NACK, null);
        }
    }

    private void driver(Packet request, Address asked) {
        Optional<ServedDevice> device = port.device(asked);
        if (device.isPresent()) {
            Address address = port.address(device.get());
            answer(
                    request,
                    MessageKind.ACK,
                    new Session.Driver(address, Chars.of(device.get().driver())));
        } else {
            answer(request, MessageKind.NACK, null); // as Player has it: javaclient3 does not read a body here
        }
    }

    private void subscribe(Packet request, Session.Subscription asked) throws InterruptedException {
        ServedDevice device = port.device(asked.device()).orElse(null);
        if (device == null) {
            answer(request, MessageKind.NACK, new Session.Subscription(asked.device(), Session.ERROR, new byte[0]));
        } else if (asked.access() == Session.OPEN) {
            asking.acquire();
            device.open().whenComplete((works, error) -> {
                opened(request, device, error == null && works);
                asking.release();
            });
        } else {
            boolean was;
            synchronized (subscribed) {
                was = subscribed.remove(device);
            }
            if (was) {
                device.close();
            }
            if (commanded.remove(device)) {
                port.givesBack(this, device);
            }
            out.answer(granted(request, device, Session.CLOSE));
        }
    }

    /// No data may come before the answer: some clients take whatever comes next for it.
    private void opened(Packet request, ServedDevice device, boolean works) {
        Packet granted = granted(request, device, works ? Session.OPEN : Session.ERROR);
        boolean more;
        synchronized (subscribed) {
            more = works && !over.get() && subscribed.add(device);
            out.answer(granted);
        }
        if (works && !more) {
            device.close(); // it wants it already, or is gone
        }
    }

    private Packet granted(Packet request, ServedDevice device, int access) {
        Address address = port.address(device);
        return packet(request, MessageKind.ACK, new Session.Subscription(address, access, Chars.of(device.driver())));
    }

    private void answer(Packet request, MessageKind kind, @Nullable Record body) {
        out.answer(packet(request, kind, body));
    }

    private Packet packet(Packet request, MessageKind kind, @Nullable Record body) {
        Address address = port.address(Interface.PLAYER, 0);
        int subtype = request.header().subtype();
        Packet packet = body == null
                ? Packet.of(address, kind, subtype, port.time())
                : Packet.of(address, kind, subtype, port.time(), body);
        return packet.withSequence(request.header().sequence());
    }
}
