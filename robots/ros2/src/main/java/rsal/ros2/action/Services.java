package rsal.ros2.action;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.Executor;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Function;
import java.util.function.Supplier;
import rsal.ros2.cdr.CdrReader;
import rsal.ros2.cdr.InvalidCdr;
import rsal.ros2.cdr.MessageCodec;
import rsal.ros2.cdr.RosMessage;
import rsal.ros2.link.Inbox.Decoder;
import rsal.ros2.link.RosLink;
import rsal.ros2.type.TypeLibrary;

/// Services that this program offers: requests are read where they come, and answered on the run's thread.
/// Malformed requests get no answer, as no service of ROS 2 gives one; nor do those that come while too many
/// wait.
public final class Services {
    private static final Logger LOG = System.getLogger(Services.class.getName());
    private static final int MOST_WAITING = 1_000; // requests; as many as parameters' services keep in rcl

    private final RosLink link;
    private final TypeLibrary types;
    private final Executor run;
    private final AtomicInteger waiting = new AtomicInteger();
    private final List<RosLink.Served> served = new ArrayList<>();

    /// Answers a request.
    public interface Handler<R> {
        /// @param responseHash as [RosLink.Server#answer(byte[], Supplier)] has it
        CompletionStage<byte[]> answer(R request, Supplier<Optional<String>> responseHash);
    }

    /// @param run its thread
    public Services(RosLink link, TypeLibrary types, Executor run) {
        this.link = link;
        this.types = types;
        this.run = run;
    }

    /// A service that answers at once.
    ///
    /// @param name with its namespace
    /// @param type `std_srvs/srv/SetBool`
    public void serve(String name, String type, Function<RosMessage, byte[]> answer) {
        serveLater(name, type, request -> CompletableFuture.completedStage(answer.apply(request)));
    }

    public void serveLater(String name, String type, Function<RosMessage, CompletionStage<byte[]>> answer) {
        serve(name, type, codec(type)::read, (request, _) -> answer.apply(request));
    }

    /// How requests of a type are read.
    public MessageCodec codec(String type) {
        return MessageCodec.of(types.get(type + "_Request"), types);
    }

    public <R> void serve(String name, String type, Decoder<R> decoder, Handler<R> handler) {
        served.add(link.serve(name, type, new RosLink.Server() {
            @Override
            public CompletionStage<byte[]> answer(byte[] request) {
                return answer(request, Optional::empty);
            }

            @Override
            public CompletionStage<byte[]> answer(byte[] request, Supplier<Optional<String>> responseHash) {
                try {
                    R message = decoder.read(CdrReader.of(request));
                    return answered(name, () -> handler.answer(message, responseHash));
                } catch (InvalidCdr e) {
                    return CompletableFuture.failedStage(e);
                }
            }
        }));
    }

    private CompletionStage<byte[]> answered(String name, Supplier<CompletionStage<byte[]>> answer) {
        if (waiting.incrementAndGet() > MOST_WAITING) {
            waiting.decrementAndGet();
            return CompletableFuture.failedStage(new IllegalStateException("Too many requests are waiting."));
        }
        return CompletableFuture.completedStage(name)
                .thenComposeAsync(
                        _ -> {
                            waiting.decrementAndGet();
                            return answer.get();
                        },
                        run)
                .whenComplete((_, error) -> {
                    if (error != null) {
                        LOG.log(Level.ERROR, "Service '%s' failed.".formatted(name), error);
                    }
                });
    }

    public void close() {
        served.forEach(RosLink.Served::close);
    }
}
