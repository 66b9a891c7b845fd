package rsal.cli;

import java.io.DataOutputStream;
import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.time.Duration;

/// A client of a Player server, a process of its own, which commands a base ten times a second for ever.
final class DrivingClient {
    private static final Duration PERIOD = Duration.ofMillis(100);

    private DrivingClient() {}

    /// @param arguments the port
    public static void main(String[] arguments) throws IOException, InterruptedException {
        try (var socket = new Socket(InetAddress.getLoopbackAddress(), Integer.parseInt(arguments[0]))) {
            var to = new DataOutputStream(socket.getOutputStream());
            Thread.ofPlatform().daemon().start(() -> {
                try {
                    socket.getInputStream().transferTo(java.io.OutputStream.nullOutputStream());
                } catch (IOException _) {
                    // the server has gone
                }
            });
            BridgeIT.subscribe(to, BridgeIT.POSITION2D);
            while (true) {
                BridgeIT.turn(to);
                Thread.sleep(PERIOD);
            }
        }
    }
}
