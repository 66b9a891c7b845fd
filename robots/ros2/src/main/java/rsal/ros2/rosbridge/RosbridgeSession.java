package rsal.ros2.rosbridge;

import java.io.IOException;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.nio.ByteBuffer;
import java.time.Duration;
import java.time.Instant;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import rsal.ros2.link.PeerText;
import rsal.ros2.rosbridge.RosbridgeTransport.Connection;
import rsal.ros2.rosbridge.RosbridgeTransport.Receiver;
import rsal.time.Scheduler;
import rsal.time.Task;
import tools.jackson.core.JsonGenerator;

/// A connection to a server that is made again whenever it is lost, and the calls of services that wait for
/// their answers. All of it on the scheduler's thread, except messages of topics, which come on the
/// transport's, and [#send], which any thread may call.
final class RosbridgeSession {
    private static final Logger LOG = System.getLogger(RosbridgeSession.class.getName());
    private static final Duration FIRST_RETRY = Duration.ofMillis(500);
    private static final Duration LAST_RETRY = Duration.ofSeconds(8);
    private static final Duration SILENCE = Duration.ofSeconds(10); // of a server that is asked something all the time
    private static final int MOST_CALLS = 1_000; // that wait for their answers
    private static final Duration ANSWER = Duration.ofSeconds(30); // to a call; some nodes never give one
    private static final int MOST_REPORTED = 100; // different messages of a server

    private final RosbridgeTransport transport;
    private final String address;
    private final Scheduler scheduler;
    private final Listener listener;
    private final AtomicLong numbers = new AtomicLong();
    private final AtomicLong malformed = new AtomicLong();
    private final Map<String, CompletableFuture<WireValue.Fields>> calls = new LinkedHashMap<>();
    private final Set<String> reported = new LinkedHashSet<>();
    private Optional<Attempt> attempt = Optional.empty(); // the newest
    private volatile Optional<Connection> connection = Optional.empty();
    private volatile Optional<String> trouble = Optional.empty();
    private volatile Instant heard; // anything
    private Duration retry = FIRST_RETRY;
    private boolean isClosed;

    /// What comes of it.
    interface Listener {
        void onConnected();

        void onDisconnected();

        /// A message of a topic, on a thread of the transport.
        void onMessage(String topic, WireValue message) throws InvalidMessage;

        /// The server refused an operation that is no call of a service, on the scheduler's thread.
        void onRefused(String id, String why);

        /// Another operation, on the scheduler's thread.
        void onOperation(String operation, WireValue.Fields fields) throws InvalidMessage;
    }

    /// @param address for people
    RosbridgeSession(RosbridgeTransport transport, String address, Scheduler scheduler, Listener listener) {
        this.transport = transport;
        this.address = address;
        this.scheduler = scheduler;
        this.listener = listener;
        this.heard = scheduler.instant();
    }

    /// One connection, or the attempt to have one. What an old one says does not count.
    private final class Attempt implements Receiver {
        @Override
        public void onText(String message) {
            receive(() -> ValueReader.json(message));
        }

        @Override
        public void onBinary(ByteBuffer message) {
            receive(() -> ValueReader.cbor(message));
        }

        private void receive(Reading reading) {
            heard = scheduler.instant();
            try {
                if (!(reading.read() instanceof WireValue.Fields fields)) {
                    throw new InvalidMessage("It is not an object.");
                }
                String operation = fields.text("op").orElseThrow(() -> new InvalidMessage("It has no 'op'."));
                if (operation.equals("publish")) {
                    String topic = fields.text("topic").orElseThrow(() -> new InvalidMessage("It has no 'topic'."));
                    listener.onMessage(topic, fields.find("msg").orElseGet(WireValue.Null::new));
                } else {
                    scheduler.execute(() -> take(this, operation, fields));
                }
            } catch (InvalidMessage e) {
                complain(e);
            }
        }

        @Override
        public void onClosed(String why) {
            scheduler.execute(() -> lose(this, why));
        }
    }

    private interface Reading {
        WireValue read() throws InvalidMessage;
    }

    /// Tells of the first one: there may be many, and they harm no others.
    private void complain(InvalidMessage e) {
        if (malformed.getAndIncrement() == 0) {
            LOG.log(
                    Level.WARNING,
                    () -> "A message of rosbridge at '%s' is malformed and ignored. Further ones are counted only: %s"
                            .formatted(address, PeerText.shown(String.valueOf(e.getMessage()))));
        }
    }

    /// How many messages were malformed.
    long malformed() {
        return malformed.get();
    }

    void open() {
        if (isClosed) {
            return;
        }
        var next = new Attempt();
        attempt = Optional.of(next);
        transport.open(next).whenComplete((made, error) -> scheduler.execute(() -> opened(next, made, error)));
    }

    private boolean isOld(Attempt of) {
        return isClosed || !attempt.equals(Optional.of(of));
    }

    private void opened(Attempt of, @Nullable Connection made, @Nullable Throwable error) {
        if (made == null) {
            lose(
                    of,
                    error == null
                            ? "no connection"
                            : String.valueOf(ResponseMessages.reason(error).getMessage()));
        } else if (isOld(of)) {
            made.abort();
        } else {
            if (trouble.isPresent()) {
                LOG.log(Level.INFO, () -> "rosbridge at '%s' is connected again.".formatted(address));
            }
            trouble = Optional.empty();
            retry = FIRST_RETRY;
            heard = scheduler.instant();
            connection = Optional.of(made);
            listener.onConnected();
        }
    }

    private void lose(Attempt of, String why) {
        if (isOld(of)) {
            return;
        }
        attempt = Optional.empty();
        boolean wasConnected = connection.isPresent();
        connection = Optional.empty();
        String words = "rosbridge at '%s' can't be reached: %s.".formatted(address, PeerText.shown(why));
        if (trouble.isEmpty()) {
            LOG.log(Level.WARNING, () -> words + " It is tried again and again.");
        }
        trouble = Optional.of(words + " Is rosbridge_server running there?");
        failAll(words);
        if (wasConnected) {
            listener.onDisconnected();
        }
        scheduler.after(retry, this::open);
        retry = retry.multipliedBy(2).compareTo(LAST_RETRY) < 0 ? retry.multipliedBy(2) : LAST_RETRY;
    }

    private void failAll(String why) {
        var waiting = List.copyOf(calls.values());
        calls.clear();
        waiting.forEach(call -> call.completeExceptionally(new IOException(why)));
    }

    /// Gives the connection up where nothing at all has come for too long, and makes another one.
    void checkSilence() {
        if (connection.isPresent() && heard.plus(SILENCE).isBefore(scheduler.instant())) {
            Connection silent = connection.get();
            attempt.ifPresent(now -> lose(now, "it has sent nothing for %d s".formatted(SILENCE.toSeconds())));
            silent.abort(); // as nobody reads its last words
        }
    }

    /// What keeps it from hearing others, for people.
    Optional<String> trouble() {
        return trouble;
    }

    void trouble(String words) {
        trouble = Optional.of(words);
    }

    void noTrouble() {
        trouble = Optional.empty();
    }

    String address() {
        return address;
    }

    boolean isConnected() {
        return connection.isPresent();
    }

    /// An id of an operation that no other has.
    String number() {
        return "rsal:" + numbers.incrementAndGet();
    }

    /// Sends an operation, unless there is no connection.
    void send(String operation, Consumer<JsonGenerator> fields) {
        send(number(), operation, fields);
    }

    /// @param key as [Connection#send] has it
    void send(String key, String operation, Consumer<JsonGenerator> fields) {
        connection.ifPresent(to -> to.send(key, OperationWriter.write(out -> {
            out.writeStringProperty("op", operation);
            fields.accept(out);
        })));
    }

    /// Calls a service.
    ///
    /// @param args writes the object that has its request
    /// @return its response; exceptionally when it fails, with what the server says
    CompletionStage<WireValue.Fields> call(String service, Consumer<JsonGenerator> args) {
        return ask(id -> send("call_service", out -> {
            out.writeStringProperty("id", id);
            out.writeStringProperty("service", service);
            out.writeName("args");
            args.accept(out);
        }));
    }

    private CompletionStage<WireValue.Fields> ask(Consumer<String> question) {
        Supplier<CompletionStage<WireValue.Fields>> refusal = () -> CompletableFuture.failedStage(
                new IOException(trouble.orElse("Too many calls of services wait for their answers.")));
        if (connection.isEmpty() || calls.size() >= MOST_CALLS) {
            return refusal.get();
        }
        String id = number();
        var answer = new CompletableFuture<WireValue.Fields>();
        calls.put(id, answer);
        Task limit = scheduler.after(ANSWER, () -> giveUp(id));
        var _ = answer.whenComplete((_, _) -> limit.cancel());
        question.accept(id);
        return answer;
    }

    private void giveUp(String id) {
        CompletableFuture<WireValue.Fields> call = calls.remove(id);
        if (call != null) {
            call.completeExceptionally(new IOException("No answer within %d s.".formatted(ANSWER.toSeconds())));
        }
    }

    private void take(Attempt from, String operation, WireValue.Fields fields) {
        if (isOld(from)) {
            return;
        }
        try {
            switch (operation) {
                case "service_response" -> respond(fields);
                case "status" -> report(fields);
                default -> listener.onOperation(operation, fields);
            }
        } catch (InvalidMessage e) {
            complain(e);
        }
    }

    private void respond(WireValue.Fields fields) throws InvalidMessage {
        String id = fields.text("id").orElseThrow(() -> new InvalidMessage("A response has no 'id'."));
        CompletableFuture<WireValue.Fields> call = calls.remove(id);
        if (call == null) {
            return; // of a service that nobody waits for any more
        }
        WireValue values = fields.find("values").orElseGet(WireValue.Null::new);
        boolean isFailure = fields.find("result").equals(Optional.of(new WireValue.Bool(false)));
        switch (values) {
            case WireValue.Fields response when !isFailure -> call.complete(response);
            case WireValue.Null _ when !isFailure -> call.complete(new WireValue.Fields(Map.of()));
            case WireValue.Text(String why) -> call.completeExceptionally(new IOException(PeerText.shown(why)));
            default -> call.completeExceptionally(new IOException("The service failed: " + values.words()));
        }
    }

    /// A status is what the server thinks of an operation.
    private void report(WireValue.Fields fields) {
        String text = PeerText.shown(fields.text("msg").orElse(""));
        String level = fields.text("level").orElse("");
        boolean isBad = level.equals("error") || level.equals("warning");
        if (isBad && reported.size() < MOST_REPORTED && reported.add(text)) {
            LOG.log(Level.WARNING, () -> "rosbridge at '%s' says: %s".formatted(address, text));
        }
        Optional<String> id = fields.text("id").filter(_ -> level.equals("error"));
        if (id.isPresent()) {
            CompletableFuture<WireValue.Fields> call = calls.remove(id.get());
            if (call == null) {
                listener.onRefused(id.get(), text);
            } else {
                call.completeExceptionally(new IOException(text));
            }
        }
    }

    void close() {
        if (isClosed) {
            return;
        }
        isClosed = true;
        connection.ifPresent(Connection::close);
        connection = Optional.empty();
        failAll("The connection is closed.");
        transport.close();
    }
}
