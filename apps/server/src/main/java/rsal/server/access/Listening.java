package rsal.server.access;

import java.net.InetSocketAddress;
import java.security.KeyStore;
import java.util.List;
import java.util.Map;

/// Where the server listens beside the loopback address, by TLS only.
///
/// @param address of this machine, or of all its networks (`0.0.0.0`)
/// @param identity a certificate with its private key, which has no password
/// @param tokens with their roles, beside that of the one who started the server: without one nothing is told or done
/// @param origins of pages that may talk to it beside its own, as `https://robots.example.org` of a reverse proxy
public record Listening(InetSocketAddress address, KeyStore identity, Map<String, Role> tokens, List<String> origins) {
    /// As short tokens are guessed.
    public static final int SHORTEST_TOKEN = 16;

    public Listening {
        tokens = Map.copyOf(tokens);
        origins = List.copyOf(origins);
        if (tokens.keySet().stream().anyMatch(token -> token.length() < SHORTEST_TOKEN)) {
            throw new IllegalArgumentException("a token has at least %d characters".formatted(SHORTEST_TOKEN));
        }
    }
}
