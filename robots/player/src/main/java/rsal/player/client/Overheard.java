package rsal.player.client;

import java.io.FilterInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.util.concurrent.atomic.AtomicInteger;

/// What comes over a socket, with how often something came. Limits of time on reads would tell that, too, but begin a
/// timer with each.
final class Overheard extends FilterInputStream {
    private final AtomicInteger times = new AtomicInteger(); // written by the thread that reads

    Overheard(InputStream in) {
        super(in);
    }

    /// How often something came. Any thread.
    int times() {
        return times.get();
    }

    @Override
    public int read() throws IOException {
        var one = new byte[1];
        return read(one, 0, 1) < 0 ? -1 : Byte.toUnsignedInt(one[0]);
    }

    @Override
    public int read(byte[] into, int from, int most) throws IOException {
        int read = in.read(into, from, most);
        times.lazySet(times.getPlain() + 1);
        return read;
    }
}
