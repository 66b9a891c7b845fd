package rsal.player.server;

import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import rsal.player.message.Interface;
import rsal.player.wire.MessageKind;
import rsal.player.wire.Packet;

/// A device that a server offers. Called on the threads of clients, by several at once.
public interface ServedDevice {
    Interface interf();

    /// Which of those with that interface on its port.
    int index();

    /// What drives it, for people; at most 63 bytes.
    String driver();

    /// A client wants its data, or commands it. Called once for each that does either.
    ///
    /// @return whether it works; until then a client that wants its data waits
    default CompletionStage<Boolean> open() {
        return CompletableFuture.completedStage(true);
    }

    /// A client that wanted its data does no more, or one that commanded it has given it back or is gone.
    default void close() {}

    /// The client that commanded it last has given it back, or is gone.
    default void forsaken() {}

    /// Whether it knows such messages.
    boolean understands(MessageKind kind, int subtype);

    /// @param request whose body is as the newest version has it
    CompletionStage<Answer> ask(Packet request);

    /// @param command whose body is as the newest version has it
    void command(Packet command);

    /// To a request.
    sealed interface Answer {
        record Done() implements Answer {}

        /// @param body as requests of its kind have it in the newest version
        record Reported(Record body) implements Answer {}

        record Refused() implements Answer {}
    }
}
