package rsal.player.client;

import java.net.InetAddress;

/// How a server sends its data. Either way only the newest of each kind waits in it.
public enum Delivery {
    /// Pushed by servers on this machine, pulled from others.
    AUTO,

    /// As soon as there is something new, which costs about half of what pulling does. A network that is too slow
    /// holds much that is old then.
    PUSH,

    /// In rounds, each asked for when the one before is here: nothing is on its way for longer than the network needs.
    PULL;

    /// @param server where it is
    boolean pulls(InetAddress server) {
        return this == PULL || (this == AUTO && !server.isLoopbackAddress());
    }
}
