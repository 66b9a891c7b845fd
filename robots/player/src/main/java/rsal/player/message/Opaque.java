package rsal.player.message;

/// Interface `opaque`: what drivers agree upon.
public final class Opaque {
    public static final int DATA = 1;

    private Opaque() {}

    public record Bytes(byte[] data) {}
}
