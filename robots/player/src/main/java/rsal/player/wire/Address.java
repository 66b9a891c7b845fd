package rsal.player.wire;

/// A device of a server.
///
/// @param host that of the server as it packs it; clients may leave it 0, as they may the robot
/// @param robot the server's port
/// @param interf code of its interface
/// @param index which of those with that interface
public record Address(int host, int robot, int interf, int index) {
    /// As a client names it to the server it is connected to.
    public static Address of(int interf, int index) {
        return new Address(0, 0, interf, index);
    }
}
