package rsal.server.http;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.util.List;
import org.jspecify.annotations.Nullable;
import rsal.server.message.Refusal;
import rsal.time.AllowedToReadWallClock;

/// Who may come in. A page of another site, opened in the same browser, can reach a loopback port: by its own
/// name made to point here (foreign `Host`), or by sending requests across sites (foreign or `null` `Origin`).
/// Neither gets an answer. Those that may look still need the token to change anything.
///
/// Of those who have it, one may have the [#lease].
@AllowedToReadWallClock("Control is given back when nobody is heard of.")
public final class AccessControl {
    /// Header by which who asks is told from others; see [Lease].
    public static final String OPERATOR = "RSAL-Operator";

    private final Lease lease = new Lease(System::nanoTime);
    private final List<String> hosts;
    private final byte[] token;

    public AccessControl(int port, String token) {
        hosts = List.of("127.0.0.1:" + port, "localhost:" + port, "[::1]:" + port);
        this.token = token.getBytes(StandardCharsets.UTF_8);
    }

    /// For every request, upgrades to WebSocket too.
    ///
    /// @throws Refusal when it is not meant for us, or sent by a page that is not ours
    ///
    /// @param site what a browser says of who asks (`Sec-Fetch-Site`); null from other programs
    void admit(@Nullable String host, @Nullable String origin, @Nullable String site) {
        if (host == null || !hosts.contains(host)) {
            throw new Refusal(421, "This server answers only as one of %s, not as '%s'.".formatted(hosts, host));
        }
        if (origin != null && !origin.equals("http://" + host)) {
            throw new Refusal(403, "Pages of '%s' may not talk to this server.".formatted(origin));
        }
        if ("cross-site".equals(site)) {
            throw new Refusal(403, "Pages of other sites may not talk to this server. Open its address by itself.");
        }
    }

    /// Who alone may change anything for now.
    public Lease lease() {
        return lease;
    }

    /// For every request that changes something, but for those that all may make at any time.
    ///
    /// @param operator as [#OPERATOR] says; empty when it doesn't
    /// @throws Refusal without the token, or while somebody else has control
    public void authorize(@Nullable String authorization, String operator) {
        authorize(authorization);
        lease.check(operator);
    }

    /// For requests that all who have the token may make at any time.
    ///
    /// @throws Refusal without the token
    public void authorize(@Nullable String authorization) {
        if (!isToken(authorization)) {
            throw new Refusal(401, """
                    This needs the run's token. Open the page by the address that was printed at start, the one \
                    that ends in #token=…; or send the header "Authorization: Bearer <token>".""");
        }
    }

    /// Whether that is the token, as headers have it.
    public boolean isToken(@Nullable String authorization) {
        return authorization != null
                && authorization.startsWith("Bearer ")
                && MessageDigest.isEqual(
                        token, authorization.substring("Bearer ".length()).getBytes(StandardCharsets.UTF_8));
    }
}
