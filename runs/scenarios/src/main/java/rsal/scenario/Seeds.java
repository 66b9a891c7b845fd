package rsal.scenario;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;

/// Seeds for the parts of a run, from the run's own seed and each part's name: those of one part do not depend on
/// which other parts there are.
final class Seeds {
    private final long seed;

    Seeds(long seed) {
        this.seed = seed;
    }

    /// The first 8 bytes of SHA-256 over seed and name.
    long of(String name) {
        try {
            var digest = MessageDigest.getInstance("SHA-256");
            digest.update(ByteBuffer.allocate(Long.BYTES).putLong(seed).flip());
            digest.update(name.getBytes(StandardCharsets.UTF_8));
            return ByteBuffer.wrap(digest.digest()).getLong();
        } catch (NoSuchAlgorithmException e) {
            throw new AssertionError("Every Java has SHA-256.", e);
        }
    }
}
