package rsal.bench.rtps;

import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.util.Set;
import java.util.random.RandomGenerator;
import rsal.rtps.Transmitter;
import rsal.time.AllowedToReadWallClock;

/// Loses some of the datagrams that a participant sends, or all from some time on.
@AllowedToReadWallClock("Benchmarks measure real time.")
final class LossyLink implements Transmitter {
    private final Transmitter sockets;
    private final double loss;
    private final RandomGenerator random;
    private volatile boolean isCut;
    private volatile long announced = System.nanoTime(); // when it last said that it is there [ns]

    /// @param loss share of datagrams that get lost
    LossyLink(Transmitter sockets, double loss, RandomGenerator random) {
        this.sockets = sockets;
        this.loss = loss;
        this.random = random;
    }

    /// Loses all from now on, or no more than before.
    void cut(boolean is) {
        isCut = is;
    }

    /// When it last said to all that it is there, and that was not lost [ns].
    long announced() {
        return announced;
    }

    private boolean isLost() {
        return isCut || (loss > 0 && random.nextDouble() < loss);
    }

    @Override
    public void send(ByteBuffer datagram, InetSocketAddress to) {
        if (!isLost()) {
            sockets.send(datagram, to);
        }
    }

    @Override
    public void announce(ByteBuffer datagram, Set<InetSocketAddress> known) {
        if (!isLost()) {
            announced = System.nanoTime();
            sockets.announce(datagram, known);
        }
    }
}
