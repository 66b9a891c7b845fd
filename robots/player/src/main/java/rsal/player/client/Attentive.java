package rsal.player.client;

import java.io.FilterInputStream;
import java.io.IOException;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.time.Duration;

/// What comes over a socket from somebody who is asked something when nothing came for a while, and who is gone
/// when nothing comes even then: a network that breaks says nothing. Who takes long over one thing may still be
/// there, so that nobody is given up soon.
final class Attentive extends FilterInputStream {
    private final Silence silence;
    private final Runnable ask;

    /// How long nothing may come.
    ///
    /// @param asked then the other one is asked something, again and again
    /// @param times how often without an answer until it is gone
    record Silence(Duration asked, int times) {
        static final Silence USUAL = new Silence(Duration.ofSeconds(2), 5);

        Duration longest() {
            return asked.multipliedBy(times);
        }
    }

    /// @param ask has the other one say something
    Attentive(Socket socket, Silence silence, Runnable ask) throws IOException {
        super(socket.getInputStream());
        socket.setSoTimeout(Math.toIntExact(silence.asked().toMillis()));
        this.silence = silence;
        this.ask = ask;
    }

    @Override
    public int read() throws IOException {
        var one = new byte[1];
        return read(one, 0, 1) < 0 ? -1 : Byte.toUnsignedInt(one[0]);
    }

    @Override
    public int read(byte[] into, int from, int most) throws IOException {
        for (int asked = 0; ; asked++) {
            try {
                return in.read(into, from, most);
            } catch (SocketTimeoutException e) {
                if (asked + 1 >= silence.times()) {
                    throw new IOException("Nothing came for %s.".formatted(words(silence.longest())), e);
                }
                ask.run();
            }
        }
    }

    private static String words(Duration time) {
        return time.toMillis() < 1000 ? time.toMillis() + " ms" : time.toSeconds() + " s";
    }
}
