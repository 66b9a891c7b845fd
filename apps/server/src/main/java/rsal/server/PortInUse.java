package rsal.server;

import java.io.IOException;
import java.net.BindException;
import java.nio.channels.ServerSocketChannel;
import rsal.server.http.PageServer;

/// Another program listens on the port already. Nothing was started.
public final class PortInUse extends Exception {
    private static final long serialVersionUID = 1;

    static ServerSocketChannel open(int port) throws IOException, PortInUse {
        try {
            return PageServer.open(port);
        } catch (BindException e) {
            throw new PortInUse(port);
        }
    }

    public PortInUse(int port) {
        super("Port %d is in use, maybe by another run. Choose another one: --port %d; or --port 0 for any."
                .formatted(port, port == 65535 ? port - 1 : port + 1));
    }
}
