package rsal.rtps.wire;

import java.nio.ByteBuffer;

/// Times on the wire: seconds and a fraction of 2⁻³² s (DDSI-RTPS 2.5, 9.3.2.1). Nanoseconds survive both ways.
public final class Timestamp {
    public static final int BYTES = 8;

    /// Of a duration that never ends.
    public static final long INFINITE = Long.MAX_VALUE;

    private static final long SECOND = 1_000_000_000; // ns
    private static final int INFINITE_SECONDS = 0x7fff_ffff;

    private Timestamp() {}

    /// @return [ns] since 1970
    static long readTime(ByteBuffer bytes) {
        return nanoseconds(bytes.getInt() & 0xffff_ffffL, bytes.getInt());
    }

    /// @param time [ns] since 1970
    static void writeTime(ByteBuffer bytes, long time) {
        bytes.putInt((int) (time / SECOND)).putInt(fraction(time));
    }

    /// @return [ns]; [#INFINITE] for no end, 0 for what is negative
    public static long readDuration(ByteBuffer bytes) {
        int seconds = bytes.getInt();
        int fraction = bytes.getInt();
        return seconds == INFINITE_SECONDS ? INFINITE : seconds < 0 ? 0 : nanoseconds(seconds, fraction);
    }

    /// @param duration [ns], or [#INFINITE]
    public static void writeDuration(ByteBuffer bytes, long duration) {
        if (duration / SECOND >= INFINITE_SECONDS) {
            bytes.putInt(INFINITE_SECONDS).putInt(-1);
        } else {
            writeTime(bytes, duration);
        }
    }

    private static long nanoseconds(long seconds, int fraction) {
        return seconds * SECOND + (((fraction & 0xffff_ffffL) * SECOND) >>> 32);
    }

    private static int fraction(long time) {
        return (int) ((((time % SECOND) << 32) + SECOND - 1) / SECOND);
    }
}
