package rsal.player.client;

import static java.nio.charset.StandardCharsets.US_ASCII;

import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.Arrays;
import rsal.player.wire.Address;
import rsal.player.wire.MessageKind;
import rsal.player.wire.Packet;

/// A server that says what a test has it say, to one client after the other.
public final class ScriptedServer implements AutoCloseable {
    private final ServerSocket listening;

    public ScriptedServer() throws IOException {
        listening = new ServerSocket(0, 1, InetAddress.getLoopbackAddress());
    }

    public InetSocketAddress address() {
        return (InetSocketAddress) listening.getLocalSocketAddress();
    }

    /// Waits for the next client and introduces itself.
    public Client accept(String ident) throws IOException {
        Socket socket = listening.accept();
        socket.setSoTimeout(10_000); // a test that waits for ever says nothing
        var client = new Client(socket, new BufferedInputStream(socket.getInputStream()));
        client.send(Arrays.copyOf(ident.getBytes(US_ASCII), 32));
        return client;
    }

    @Override
    public void close() throws IOException {
        listening.close();
    }

    public record Client(Socket socket, InputStream in) implements AutoCloseable {
        public void send(byte[] bytes) throws IOException {
            socket.getOutputStream().write(bytes);
        }

        public void send(Packet packet) throws IOException {
            send(packet.bytes());
        }

        public Packet next() throws IOException {
            return Packet.read(in).orElseThrow();
        }

        /// Waits for a request, and says yes to all others before it.
        public Packet next(Address device, int subtype) throws IOException {
            while (true) {
                Packet packet = next();
                if (packet.header().address().equals(device) && packet.header().subtype() == subtype) {
                    return packet;
                }
                acknowledge(packet);
            }
        }

        public void acknowledge(Packet request) throws IOException {
            send(Packet.of(
                    request.header().address(),
                    MessageKind.ACK,
                    request.header().subtype(),
                    0));
        }

        public void acknowledge(Packet request, Record body) throws IOException {
            send(Packet.of(
                    request.header().address(),
                    MessageKind.ACK,
                    request.header().subtype(),
                    0,
                    body));
        }

        public void refuse(Packet request) throws IOException {
            send(Packet.of(
                    request.header().address(),
                    MessageKind.NACK,
                    request.header().subtype(),
                    0));
        }

        @Override
        public void close() throws IOException {
            socket.close();
        }
    }
}
