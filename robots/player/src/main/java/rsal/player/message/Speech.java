package rsal.player.message;

/// Interface `speech`.
public final class Speech {
    public static final int SAY = 1;

    private Speech() {}

    /// @param text [Chars]
    public record Say(byte[] text) {}
}
