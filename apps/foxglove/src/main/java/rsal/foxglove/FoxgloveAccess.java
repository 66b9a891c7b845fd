package rsal.foxglove;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;

/// Who may come in. Foxglove is a page of another site, so that its origin tells nothing: all that comes from a
/// page must know the token, as any page in the browser can reach a loopback port. A program of this machine may
/// look without; to change anything, it needs the token, too.
final class FoxgloveAccess {
    private final List<String> hosts;
    private final byte[] token;

    /// @param token letters, digits, `-` and `_`
    FoxgloveAccess(int port, String token) {
        hosts = List.of("127.0.0.1:" + port, "localhost:" + port);
        this.token = token.getBytes(StandardCharsets.UTF_8);
    }

    /// Whether who knows a token is who should.
    boolean knows(@Nullable String reported) {
        return reported != null && MessageDigest.isEqual(token, reported.getBytes(StandardCharsets.UTF_8));
    }

    /// Why somebody may not come in, in a sentence; empty when they may.
    ///
    /// @param reported the token as the address has it
    Optional<String> refuse(@Nullable String host, @Nullable String origin, @Nullable String reported) {
        if (host == null || !hosts.contains(host)) {
            return Optional.of("This server answers only as one of %s, not as '%s'.".formatted(hosts, host));
        }
        if (reported != null && !knows(reported)) {
            return Optional.of("That is not this run's token. Open the address that was printed at start.");
        }
        if (origin != null && reported == null) {
            return Optional.of(
                    "Pages need the run's token. Open the address that was printed at start, with ?token=….");
        }
        return Optional.empty();
    }
}
