/// Player (playerproject.github.io), a server of robots' devices: its protocol, and robots of ours that are offered
/// to its clients. Knows nothing of agents, scenarios or
/// navigation.
module rsal.player {
    requires rsal.devices;
    requires static org.jspecify;

    provides rsal.system.BridgeProvider with
            rsal.player.bridge.PlayerBridgeProvider,
            rsal.player.bridge.Player30BridgeProvider;
    provides rsal.system.RobotSystemProvider with
            rsal.player.PlayerProvider;
}
