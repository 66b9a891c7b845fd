package rsal.player.client;

import static java.nio.charset.StandardCharsets.UTF_8;

import java.io.BufferedInputStream;
import java.io.BufferedOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.time.Duration;
import java.util.ArrayDeque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Queue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Consumer;
import rsal.player.message.Chars;
import rsal.player.message.Interface;
import rsal.player.message.Protocol;
import rsal.player.message.Session;
import rsal.player.wire.Address;
import rsal.player.wire.MalformedException;
import rsal.player.wire.MessageKind;
import rsal.player.wire.Packet;
import rsal.time.AllowedToReadWallClock;

/// A connection to a Player server, which keeps the newest data of each kind only for us: so a slow reader is
/// never behind. One thread reads and one writes; nobody else waits for the network. It ends, too, when
/// [nothing comes any more][Silence]. May be used on any thread.
@AllowedToReadWallClock("It waits for a network.")
public final class Connection implements AutoCloseable {
    private static final String CLOSED = "The connection was closed.";
    private static final Duration PARTING = Duration.ofMillis(500); // to send what is left

    private static final Duration ROUND = Duration.ofMillis(20); // from one to the next, at least
    private static final int MOST_ASKED = 16; // of a kind, without an answer yet

    private final Socket socket;
    private final boolean pulls;
    private final String ident;
    private final Protocol protocol;
    private final Consumer<? super Packet> onData;
    private final Outbox outbox = new Outbox();
    private final CompletableFuture<String> lost = new CompletableFuture<>();
    private final Map<Signature, Queue<CompletableFuture<Packet>>> asked = new HashMap<>(); // guarded by itself

    private final AtomicBoolean awaiting = new AtomicBoolean(); // the time for the next round
    private volatile long roundBegan;
    private volatile boolean closed;

    private Connection(Socket socket, boolean pulls, String ident, Consumer<? super Packet> onData) {
        this.socket = socket;
        this.pulls = pulls;
        this.ident = ident;
        this.protocol = Protocol.of(ident);
        this.onData = onData;
    }

    /// Connects; waits for the server.
    ///
    /// @param patience until there must be an answer
    /// @param onData told of all data, on the thread that reads
    /// @throws IOException when there is no server, or none of Player's
    public static Connection open(
            InetSocketAddress server, Delivery delivery, Duration patience, Consumer<? super Packet> onData)
            throws IOException {
        return open(server, delivery, patience, Silence.USUAL, onData);
    }

    static Connection open(
            InetSocketAddress server,
            Delivery delivery,
            Duration patience,
            Silence silence,
            Consumer<? super Packet> onData)
            throws IOException {
        var socket = new Socket();
        try {
            int millis = Math.toIntExact(patience.toMillis());
            socket.setTcpNoDelay(true);
            socket.connect(server, millis);
            socket.setSoTimeout(millis);
            byte[] introduction = socket.getInputStream().readNBytes(Session.IDENT);
            String ident = Chars.text(introduction);
            if (introduction.length < Session.IDENT || !ident.startsWith("Player")) {
                throw new MalformedException(
                        "'%s' is not a Player server; it begins with '%s'.".formatted(server, printable(introduction)));
            }
            var connection = new Connection(socket, delivery.pulls(socket.getInetAddress()), ident, onData);
            socket.setSoTimeout(0);
            connection.start(new Overheard(socket.getInputStream()), socket.getOutputStream(), silence);
            return connection;
        } catch (IOException | RuntimeException e) {
            socket.close();
            throw e;
        }
    }

    private static String printable(byte[] bytes) {
        return new String(bytes, UTF_8).replaceAll("[^\\x20-\\x7e]", "?");
    }

    private void start(Overheard in, OutputStream out, Silence silence) {
        ask(Session.MODE, new Session.Mode(pulls ? Session.PULL : Session.PUSH));
        ask(
                Session.REPLACE_RULE,
                new Session.ReplaceRule(
                        Session.ANY, Session.ANY, MessageKind.DATA.code(), Session.ANY, Session.REPLACE));
        if (pulls) {
            nextRound();
        }
        Thread.ofVirtual().name("player read").start(() -> read(new BufferedInputStream(in)));
        Thread.ofVirtual().name("player write").start(() -> write(out));
        Thread.ofVirtual().name("player watch").start(() -> watch(in, silence));
    }

    /// A network that breaks says nothing. So who is silent is asked for something, and is gone when nothing comes even
    /// then. Who takes long over one thing may still be there: nobody is given up soon.
    private void watch(Overheard in, Silence silence) {
        int heard = in.times();
        int silent = 0;
        while (!isLostWithin(silence.asked())) {
            silent = in.times() == heard ? silent + 1 : 0;
            heard = in.times();
            if (silent >= silence.times()) {
                end("Nothing came for %s.".formatted(silence.words()));
            } else if (silent > 0) {
                settled();
            }
        }
    }

    private boolean isLostWithin(Duration time) {
        try {
            lost.get(time.toMillis(), TimeUnit.MILLISECONDS);
            return true;
        } catch (TimeoutException e) {
            return false;
        } catch (InterruptedException | ExecutionException e) {
            throw new AssertionError("Nobody interrupts it, and it never fails.", e);
        }
    }

    /// How long nothing may come.
    ///
    /// @param asked then the server is asked something, again and again
    /// @param times how often in vain until it is gone
    record Silence(Duration asked, int times) {
        static final Silence USUAL = new Silence(Duration.ofSeconds(2), 5);

        String words() {
            Duration all = asked.multipliedBy(times);
            return all.toMillis() < 1000 ? all.toMillis() + " ms" : all.toSeconds() + " s";
        }
    }

    /// How the server introduced itself.
    public String ident() {
        return ident;
    }

    public Protocol protocol() {
        return protocol;
    }

    /// Why the connection has ended, once it has; told on the thread that noticed.
    public CompletionStage<String> lost() {
        return lost.minimalCompletionStage();
    }

    /// All devices of the server's port.
    public CompletionStage<List<Address>> devices() {
        return ask(Packet.of(Session.SERVER, MessageKind.REQUEST, Session.DEVICES, 0))
                .thenCompose(answer -> body(answer, Session.Devices.class))
                .thenApply(Session.Devices::devices);
    }

    /// What drives a device.
    public CompletionStage<String> driver(Address device) {
        return ask(Session.DRIVER, new Session.Driver(device, new byte[0]))
                .thenCompose(answer -> body(answer, Session.Driver.class))
                .thenApply(driver -> Chars.text(driver.name()));
    }

    /// Has a device's data sent, and starts it if nobody else uses it, which may take seconds.
    ///
    /// @return what drives it
    public CompletionStage<String> subscribe(Address device) {
        var request = new Session.Subscription(device, Session.OPEN, new byte[0]);
        return ask(Session.DEVICE, request)
                .thenCompose(answer -> body(answer, Session.Subscription.class))
                .thenCompose(granted -> granted.access() == Session.OPEN
                        ? CompletableFuture.completedStage(Chars.text(granted.driver()))
                        : CompletableFuture.failedStage(new RefusedException(
                                "The driver of '%s' did not start.".formatted(Interface.words(device)))));
    }

    /// Asks something of a device, or of the server.
    ///
    /// @return the answer, on the thread that reads; a [RefusedException] when the server refuses, an
    /// [IOException] when the connection is lost before, or when sixteen more of its kind are asked before.
    /// There is none when the server has no such device.
    public CompletionStage<Packet> ask(Packet request) {
        var answer = new CompletableFuture<Packet>();
        Signature signature = Signature.of(request.header());
        CompletableFuture<Packet> given = null; // up
        synchronized (asked) {
            if (outbox.request(request)) {
                Queue<CompletableFuture<Packet>> waiting = asked.computeIfAbsent(signature, _ -> new ArrayDeque<>());
                waiting.add(answer);
                given = waiting.size() > MOST_ASKED ? waiting.poll() : null;
            } else {
                answer.completeExceptionally(
                        new IOException(lost.isDone() ? lost.join() : "It is closed, or has too many requests."));
            }
        }
        if (given != null) {
            given.completeExceptionally(new IOException("The server does not answer."));
        }
        return answer.minimalCompletionStage();
    }

    private CompletionStage<Packet> ask(int subtype, Record body) {
        return ask(Packet.of(Session.SERVER, MessageKind.REQUEST, subtype, 0, body));
    }

    private static <T extends Record> CompletionStage<T> body(Packet answer, Class<T> type) {
        try {
            return CompletableFuture.completedStage(answer.body(type));
        } catch (MalformedException e) {
            return CompletableFuture.failedStage(e);
        }
    }

    /// Has a device's data sent no more; it ends when nobody else uses it.
    public void unsubscribe(Address device) {
        ask(Session.DEVICE, new Session.Subscription(device, Session.CLOSE, new byte[0]));
    }

    /// Completes when the server has got all that was sent before, and all that it had sent before is here.
    public CompletionStage<Void> settled() {
        return devices().thenAccept(_ -> {});
    }

    /// Sends a command, in place of one of its kind that was not sent yet.
    public void command(Packet command) {
        outbox.command(command);
    }

    /// Sends commands that make sense together only, in place of such for the same device that were not sent
    /// yet.
    public void commands(Address device, List<Packet> together) {
        outbox.commands(device, together);
    }

    /// A server whose simulation goes on with each message would race if the next round began at once.
    private void roundOver() {
        if (!pulls || !awaiting.compareAndSet(false, true)) {
            return; // it was not asked for
        }
        long wait = roundBegan + ROUND.toNanos() - System.nanoTime();
        if (wait <= 0) {
            nextRound();
        } else {
            Thread.ofVirtual().name("player round").start(() -> {
                LockSupport.parkNanos(wait);
                nextRound();
            });
        }
    }

    private void nextRound() {
        awaiting.set(false);
        if (closed) {
            return;
        }
        roundBegan = System.nanoTime();
        if (!outbox.request(Packet.of(Session.SERVER, MessageKind.REQUEST, Session.DATA, 0)) && !lost.isDone()) {
            end("The server accepts nothing: too many messages wait for it.");
        }
    }

    private void read(InputStream in) {
        try {
            while (true) {
                take(Packet.read(in).orElseThrow(() -> new EOFException("The server has closed the connection.")));
            }
        } catch (IOException | RuntimeException e) {
            end(reason(e));
        }
    }

    private void take(Packet packet) {
        switch (packet.header().kind()) {
            case DATA -> onData.accept(packet);
            case ACK, NACK -> answered(packet);
            case SYNCH -> roundOver();
            case COMMAND, REQUEST, UNKNOWN -> {} // not for a client
        }
    }

    private void answered(Packet packet) {
        CompletableFuture<Packet> answer;
        synchronized (asked) {
            Queue<CompletableFuture<Packet>> waiting = asked.get(Signature.of(packet.header()));
            answer = waiting == null ? null : waiting.poll();
        }
        if (answer == null) {
            return; // to a request for data, or to nobody
        }
        if (packet.header().kind() == MessageKind.ACK) {
            answer.complete(packet);
        } else {
            answer.completeExceptionally(new RefusedException("The server refuses request %d of '%s'."
                    .formatted(
                            packet.header().subtype(),
                            Interface.words(packet.header().address()))));
        }
    }

    /// What waits at the same time goes out at once.
    private void write(OutputStream network) {
        var out = new BufferedOutputStream(network);
        try {
            Optional<List<Packet>> next = outbox.take();
            while (next.isPresent()) {
                for (Packet packet : next.get()) {
                    out.write(packet.bytes());
                }
                if (outbox.isEmpty()) {
                    out.flush();
                }
                next = outbox.take();
            }
            end(CLOSED);
        } catch (IOException e) {
            end(reason(e));
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            end("The writer was interrupted.");
        }
    }

    static String reason(Exception e) {
        String message = e.getMessage();
        return message == null ? e.getClass().getSimpleName() : message;
    }

    /// Ends the connection once all that was commanded and asked before is on its way, at once for those who
    /// wait for an answer.
    @Override
    public void close() {
        closed = true;
        outbox.close();
        unanswered(CLOSED);
        Thread.ofVirtual().name("player close").start(() -> {
            if (!isLostWithin(PARTING)) {
                end(CLOSED); // the server takes nothing more
            }
        });
    }

    private void end(String reason) {
        if (!lost.complete(reason)) {
            return;
        }
        outbox.close();
        try {
            socket.close();
        } catch (IOException e) {
            // it is of no more use either way
        }
        unanswered(reason);
    }

    private void unanswered(String reason) {
        List<CompletableFuture<Packet>> waiting;
        synchronized (asked) {
            waiting = asked.values().stream().flatMap(Queue::stream).toList();
            asked.clear();
        }
        waiting.forEach(answer -> answer.completeExceptionally(new IOException(reason)));
    }
}
