package rsal.player.message;

import java.util.List;
import rsal.player.wire.Address;

/// Interface `player`: what a client and a server say about their connection.
public final class Session {
    /// Where clients look for servers when they are told nothing else.
    public static final int USUAL_PORT = 6665;

    public static final int LAST_PORT = 65_535;

    /// Bytes by which a server introduces itself, before all messages ([Chars]).
    public static final int IDENT = 32;

    /// The server itself, to its clients.
    public static final Address SERVER = Address.of(Interface.PLAYER.code(), 0);

    public static final int DEVICES = 1;
    public static final int DRIVER = 2;
    public static final int DEVICE = 3;
    public static final int DATA = 4;
    public static final int MODE = 5;
    public static final int AUTHENTICATION = 7;
    public static final int NAME_SERVICE = 8;
    public static final int REPLACE_RULE = 10;

    /// Synch: a round of data has ended, and nothing was lost.
    public static final int COMPLETE = 1;

    /// Synch: the same, and something was lost.
    public static final int OVERFLOW = 2;

    /// [Subscription#access]
    public static final int OPEN = 1;

    public static final int CLOSE = 2;
    public static final int ERROR = 3;

    /// [Mode#mode]: data comes as soon as it is there.
    public static final int PUSH = 1;

    /// Data comes when it is asked for.
    public static final int PULL = 2;

    /// [ReplaceRule#replace]: what was not sent yet is followed by what is newer.
    public static final int QUEUE = 0;

    /// What is newer takes the place of what was not sent yet.
    public static final int REPLACE = 1;

    /// It is not sent.
    public static final int IGNORE = 2;

    /// In [ReplaceRule]: whatever it is.
    public static final int ANY = -1;

    private Session() {}

    /// All that a server has.
    public record Devices(List<Address> devices) {}

    /// @param name [Chars]; none in a request
    public record Driver(Address device, byte[] name) {}

    /// @param access that is wanted, or that was given
    /// @param driver [Chars]
    public record Subscription(Address device, int access, byte[] driver) {}

    public record Mode(int mode) {}

    public record Authentication(byte[] key) {}

    public record NamedService(byte[] name, int port) {}

    /// What becomes of messages of a kind that were not sent yet; the first rule that holds counts.
    public record ReplaceRule(int interf, int index, int type, int subtype, int replace) {}

    /// Whether a device knows messages of a kind; asked of the device itself.
    public record Capability(int type, int subtype) {}

    /// @param messages that were left out since the last round
    public record Lost(int messages) {}
}
