package rsal.player.message;

import static java.nio.charset.StandardCharsets.UTF_8;

/// Player's strings: bytes, most often with a 0 behind them.
public final class Chars {
    private Chars() {}

    /// With a 0 behind it, as Player's own clients send it.
    public static byte[] of(String text) {
        byte[] bytes = text.getBytes(UTF_8);
        return java.util.Arrays.copyOf(bytes, bytes.length + 1);
    }

    /// What stands before the first 0, if there is one.
    public static String text(byte[] chars) {
        int end = 0;
        while (end < chars.length && chars[end] != 0) {
            end++;
        }
        return new String(chars, 0, end, UTF_8);
    }
}
