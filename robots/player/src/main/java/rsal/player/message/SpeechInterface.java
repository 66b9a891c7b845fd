package rsal.player.message;

/// Interface `speech`.
public final class SpeechInterface {
    public static final int SAY = 1;

    private SpeechInterface() {}

    /// @param text [Chars]
    public record Say(byte[] text) {}
}
