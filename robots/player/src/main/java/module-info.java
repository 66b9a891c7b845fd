/// Player (playerproject.github.io), a server of robots' devices: its protocol. Knows nothing of agents, scenarios or
/// navigation.
module rsal.player {
    requires rsal.devices;
    requires static org.jspecify;
}
