package rsal.player.bridge;

import java.io.IOException;
import java.net.InetSocketAddress;
import rsal.player.message.Protocol;
import rsal.player.message.Session;
import rsal.system.Bridge;
import rsal.system.BridgeContext;
import rsal.system.BridgeProvider;
import rsal.time.Scheduler;

/// Offers robots to clients of Player 3.0 and before: with the messages that have changed since as they were.
public final class Player30BridgeProvider implements BridgeProvider {
    @Override
    public String key() {
        return "player-3.0";
    }

    @Override
    public String description() {
        return "Serves robots to programs that were built for Player 3.0, such as those with javaclient3.";
    }

    @Override
    public int defaultPort() {
        return Session.USUAL_PORT;
    }

    @Override
    public Bridge open(InetSocketAddress at, BridgeContext context, Scheduler scheduler) throws IOException {
        return PlayerBridge.open(at, context, Protocol.V3_0, scheduler);
    }
}
