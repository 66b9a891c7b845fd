package rsal.player.message;

/// Interface `dio`: lines that are on or off.
public final class Dio {
    public static final int VALUES = 1;

    private Dio() {}

    /// @param count how many bits count
    public record Values(int count, int bits) {}
}
