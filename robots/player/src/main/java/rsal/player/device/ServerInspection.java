package rsal.player.device;

import java.io.IOException;
import java.io.InterruptedIOException;
import java.time.Duration;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import rsal.player.client.Connection;
import rsal.player.message.Interface;
import rsal.player.message.Ranger;
import rsal.player.wire.Address;
import rsal.player.wire.MalformedException;
import rsal.player.wire.MessageKind;
import rsal.player.wire.Packet;
import rsal.time.AllowedToReadWallClock;

/// Finds out what a server has. Blocks.
@AllowedToReadWallClock("It waits for a server, which lives in real time.")
final class ServerInspection {
    private static final Duration PATIENCE = Duration.ofSeconds(5);

    private ServerInspection() {}

    /// Rangers are started for a moment, all at once, as only then they tell how they are built.
    static ServerOffer of(Connection connection) throws IOException {
        List<Address> devices = answer(connection.devices(), "which devices it has").stream()
                .map(device -> Address.of(device.interf(), device.index()))
                .toList();
        List<Address> rangers = new ServerOffer(devices, List.of(), List.of()).of(Interface.RANGER);
        var places = new LinkedHashMap<Address, CompletableFuture<Integer>>();
        rangers.forEach(ranger -> places.put(ranger, places(connection, ranger).toCompletableFuture()));
        await(places.values());
        if (connection.lost().toCompletableFuture().isDone()) {
            throw new IOException("The connection was lost while it was asked."); // it will be asked again
        }
        rangers.forEach(connection::unsubscribe);
        return new ServerOffer(
                devices,
                rangers.stream().filter(ranger -> reported(places, ranger) == 1).toList(),
                rangers.stream().filter(ranger -> reported(places, ranger) > 1).toList());
    }

    /// From how many places a ranger measures.
    private static CompletionStage<Integer> places(Connection connection, Address ranger) {
        return connection
                .subscribe(ranger)
                .thenCompose(_ -> connection.ask(Packet.of(ranger, MessageKind.REQUEST, Ranger.GEOMETRY, 0)))
                .thenApply(answer -> {
                    try {
                        return answer.body(Ranger.Geometry.class).poses().size();
                    } catch (MalformedException e) {
                        throw new CompletionException(e);
                    }
                });
    }

    /// Waits until all are over, but not for long: one that does not tell, and that perhaps nobody needs, keeps nobody
    /// from the rest.
    private static void await(Collection<CompletableFuture<Integer>> all) throws IOException {
        try {
            CompletableFuture.allOf(all.toArray(CompletableFuture[]::new))
                    .get(PATIENCE.toMillis(), TimeUnit.MILLISECONDS);
        } catch (TimeoutException | ExecutionException e) {
            // those that have told count
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new InterruptedIOException();
        }
    }

    /// 0 when it has not told.
    private static int reported(Map<Address, CompletableFuture<Integer>> places, Address ranger) {
        CompletableFuture<Integer> answer = places.get(ranger);
        return answer != null && answer.state() == Future.State.SUCCESS ? answer.resultNow() : 0;
    }

    private static <T> T answer(CompletionStage<T> asked, String what) throws IOException {
        try {
            return asked.toCompletableFuture().get(PATIENCE.toMillis(), TimeUnit.MILLISECONDS);
        } catch (TimeoutException e) {
            throw new IOException("The server does not report %s.".formatted(what), e);
        } catch (ExecutionException e) {
            throw e.getCause() instanceof IOException lost ? lost : new IOException(e.getCause());
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new InterruptedIOException();
        }
    }
}
