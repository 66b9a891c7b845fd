package rsal.player.device;

import java.io.IOException;
import java.io.InterruptedIOException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import rsal.player.client.Connection;
import rsal.player.client.RefusedException;
import rsal.player.message.Interface;
import rsal.player.message.Ranger;
import rsal.player.wire.Address;
import rsal.player.wire.Kind;
import rsal.player.wire.Packet;
import rsal.time.AllowedToReadWallClock;

/// Finds out what a server has. Blocks.
@AllowedToReadWallClock("It waits for a server, which lives in real time.")
final class Survey {
    private static final Duration PATIENCE = Duration.ofSeconds(5);

    private Survey() {}

    /// Rangers are started for a moment, as only then they tell how they are built.
    static Offer of(Connection connection) throws IOException {
        List<Address> devices = answer(connection.devices(), "which devices it has").stream()
                .map(device -> Address.of(device.interf(), device.index()))
                .toList();
        var scanners = new ArrayList<Address>();
        var rings = new ArrayList<Address>();
        for (Address device : new Offer(devices, List.of(), List.of()).of(Interface.RANGER)) {
            int places = places(connection, device);
            if (places == 1) {
                scanners.add(device);
            } else if (places > 1) {
                rings.add(device);
            }
        }
        return new Offer(devices, scanners, rings);
    }

    /// From how many a ranger measures; 0 when it does not tell.
    private static int places(Connection connection, Address ranger) throws IOException {
        String what = "how its (%s) is built".formatted(Interface.words(ranger));
        try {
            answer(connection.subscribe(ranger), what);
            Packet geometry = answer(connection.ask(Packet.of(ranger, Kind.REQUEST, Ranger.GEOMETRY, 0)), what);
            return geometry.body(Ranger.Geometry.class).poses().size();
        } catch (Refusal e) {
            return 0;
        } finally {
            connection.unsubscribe(ranger);
        }
    }

    private static <T> T answer(CompletionStage<T> asked, String what) throws IOException {
        try {
            return asked.toCompletableFuture().get(PATIENCE.toMillis(), TimeUnit.MILLISECONDS);
        } catch (TimeoutException e) {
            throw new IOException("The server does not tell %s.".formatted(what), e);
        } catch (ExecutionException e) {
            if (e.getCause() instanceof RefusedException refused) {
                throw new Refusal(refused);
            }
            throw e.getCause() instanceof IOException lost ? lost : new IOException(e.getCause());
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new InterruptedIOException();
        }
    }

    private static final class Refusal extends IOException {
        private static final long serialVersionUID = 1;

        Refusal(RefusedException cause) {
            super(cause);
        }
    }
}
