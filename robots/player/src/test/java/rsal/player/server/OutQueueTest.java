package rsal.player.server;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import rsal.player.message.Interface;
import rsal.player.message.Maps;
import rsal.player.message.Session;
import rsal.player.wire.Address;
import rsal.player.wire.Kind;
import rsal.player.wire.Packet;

@Timeout(30)
class OutQueueTest {
    private static final Packet ANSWER = Packet.of(Address.of(1, 0), Kind.ACK, Session.DEVICES, 0);

    private final OutQueue queue = new OutQueue();

    private static CompletableFuture<Boolean> waiting(Waiting what) {
        var done = new CompletableFuture<Boolean>();
        Thread.ofVirtual().start(() -> {
            try {
                done.complete(what.isOver());
            } catch (InterruptedException e) {
                done.completeExceptionally(e);
            }
        });
        return done;
    }

    private interface Waiting {
        boolean isOver() throws InterruptedException;
    }

    private CompletableFuture<Boolean> someoneWhoHasToWait() {
        CompletableFuture<Boolean> asking = waiting(() -> {
            queue.awaitRoom();
            return true;
        });
        assertThat(asking.copy()
                        .completeOnTimeout(false, 200, TimeUnit.MILLISECONDS)
                        .join())
                .isFalse();
        return asking;
    }

    @Test
    void whoAsksTooMuchWaitsUntilAnAnswerIsTaken() throws Exception {
        for (int i = 0; i < 256; i++) {
            queue.awaitRoom();
            queue.answer(ANSWER);
        }
        CompletableFuture<Boolean> asking = someoneWhoHasToWait();
        assertThat(queue.take(() -> 0)).contains(ANSWER);
        assertThat(asking.join()).isTrue();
    }

    @Test
    void whoAsksForTooLargeAnswersWaits() throws Exception {
        var tile = new Maps.Tile(0, 0, 1, 1, 1, 1, new byte[1 << 20]);
        Packet large = Packet.of(Address.of(Interface.MAP.code(), 0), Kind.ACK, Maps.TILE, 0, tile);
        for (int i = 0; i < 4; i++) {
            queue.awaitRoom();
            queue.answer(large);
        }
        CompletableFuture<Boolean> asking = someoneWhoHasToWait();
        queue.take(() -> 0);
        assertThat(asking.join()).isTrue();
    }

    @Test
    void nobodyWaitsForAClientThatIsGone() {
        for (int i = 0; i < 256; i++) {
            queue.answer(ANSWER);
        }
        CompletableFuture<Boolean> asking = waiting(() -> {
            queue.awaitRoom();
            return true;
        });
        var empty = new OutQueue();
        CompletableFuture<Boolean> sending = waiting(() -> empty.take(() -> 0).isEmpty());
        queue.close();
        empty.close();
        assertThat(asking.join()).isTrue();
        assertThat(sending.join()).isTrue();
    }
}
