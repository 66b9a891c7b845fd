package rsal.player.bridge;

import java.io.IOException;
import java.net.InetSocketAddress;
import rsal.player.message.Protocol;
import rsal.player.message.Session;
import rsal.system.Bridge;
import rsal.system.BridgeContext;
import rsal.system.BridgeProvider;
import rsal.time.Scheduler;

/// Offers robots to clients of Player 3.1 and later, and to those of 3.0 that show it early enough.
public final class PlayerBridgeProvider implements BridgeProvider {
    @Override
    public String key() {
        return "player";
    }

    @Override
    public String description() {
        return "Serves robots to clients of Player 3, such as playerprint, playerv and programs with libplayerc.";
    }

    @Override
    public int defaultPort() {
        return Session.USUAL_PORT;
    }

    @Override
    public Bridge open(InetSocketAddress at, BridgeContext context, Scheduler scheduler) throws IOException {
        return PlayerBridge.open(at, context, Protocol.V3_1, scheduler);
    }
}
