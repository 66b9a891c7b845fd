package rsal.rtps;

/// How much a participant keeps of what others send, or do not take, so that no peer can exhaust its memory.
///
/// @param participants known at a time
/// @param endpoints of each of them: a bridge of a hundred robots has some thousands
/// @param allEndpoints of all of them together
/// @param sample longest one [B]
/// @param assembly of samples in fragments that are not complete, together [B]
/// @param early samples of one writer that wait for one before them
/// @param earlyBytes the same [B]
/// @param kept samples of one of our writers
/// @param keptBytes the same of one that keeps all until its readers have them [B]
public record RtpsLimits(
        int participants,
        int endpoints,
        int allEndpoints,
        int sample,
        long assembly,
        int early,
        int earlyBytes,
        int kept,
        int keptBytes) {
    public static final RtpsLimits DEFAULT =
            new RtpsLimits(512, 16_000, 100_000, 64 << 20, 192 << 20, 256, 16 << 20, 1_000, 64 << 20);

    /// The same with other limits of what our writers keep.
    RtpsLimits keeping(int samples, int bytes) {
        return new RtpsLimits(
                participants, endpoints, allEndpoints, sample, assembly, early, earlyBytes, samples, bytes);
    }
}
