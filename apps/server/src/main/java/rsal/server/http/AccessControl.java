package rsal.server.http;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import rsal.server.access.Listening;
import rsal.server.access.Role;
import rsal.server.message.Refusal;
import rsal.time.AllowedToReadWallClock;

/// Who may come in. A page of another site, opened in the same browser, can reach a loopback port: by its own
/// name made to point here (foreign `Host`), or by sending requests across sites (foreign or `null` `Origin`).
/// Neither gets an answer. Those that may look still need the token to change anything.
///
/// From other machines, where the server listens for them ([Listening]), all but the page's own files needs a
/// token, which says by its [Role] what its owner may do. Browsers show it once ([#session]) and keep a cookie, by
/// which they may watch and nothing else: so no other site can have them do anything.
///
/// Of those who have it, one may have the [#lease].
@AllowedToReadWallClock("Control is given back when nobody is heard of.")
public final class AccessControl {
    /// Header by which who asks is told from others; see [Lease].
    public static final String OPERATOR = "RSAL-Operator";

    private static final String COOKIE = "rsal";

    /// The page's own files, and what browsers show their token to.
    private static final Pattern OPEN_TO_ALL =
            Pattern.compile("/healthz|/api/session|/(beside/\\d+/)?((assets/)?[\\w@-][\\w@.-]*\\.\\w+)?");
    private static final String BEARER = "Bearer ";
    private static final String NEEDS_TOKEN = """
            This needs the run's token. Open the page by the address that was printed at start, the one \
            that ends in #token=…; or send the header "Authorization: Bearer <token>".""";

    private final Lease lease = new Lease(System::nanoTime);
    private final List<String> hosts;
    private final List<Key> keys;
    private final List<String> origins;
    private final boolean framed;

    /// @param token as bytes, to be compared in constant time
    private record Key(byte[] token, Role role) {}

    public AccessControl(int port, String token) {
        this(port, token, Optional.empty(), false);
    }

    /// @param port of the loopback address
    /// @param token of the one who started the server, who may do all
    /// @param framed whether pages of other programs on this machine may show its page in frames
    public AccessControl(int port, String token, Optional<Listening> listening, boolean framed) {
        this.framed = framed;
        hosts = List.of("127.0.0.1:" + port, "localhost:" + port, "[::1]:" + port);
        keys = Stream.concat(
                        Stream.of(new Key(bytes(token), Role.ADMIN)),
                        listening.stream()
                                .flatMap(each -> each.tokens().entrySet().stream())
                                .map(each -> new Key(bytes(each.getKey()), each.getValue())))
                .toList();
        origins = listening.map(Listening::origins).orElse(List.of());
    }

    private static byte[] bytes(String token) {
        return token.getBytes(StandardCharsets.UTF_8);
    }

    /// Whether pages of other programs on this machine may show this server's page in frames.
    boolean isFramed() {
        return framed;
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

    /// For every request from another machine.
    ///
    /// @param path what is asked for, decoded
    /// @param authorization the header; null without one
    /// @param cookies the header; null without one
    /// @throws Refusal when it has no token, or was sent by a page that is not ours
    void admitRemote(
            @Nullable String host,
            @Nullable String origin,
            @Nullable String site,
            String path,
            @Nullable String authorization,
            @Nullable String cookies) {
        if (origin != null && !origin.equals("https://" + host) && !origins.contains(origin)) {
            throw new Refusal(403, "Pages of '%s' may not talk to this server.".formatted(origin));
        }
        if ("cross-site".equals(site) && !path.equals("/")) { // a link to the page is no harm
            throw new Refusal(403, "Pages of other sites may not talk to this server. Open its address by itself.");
        }
        if (!OPEN_TO_ALL.matcher(path).matches()
                && role(authorization).or(() -> role(cookie(cookies))).isEmpty()) {
            throw new Refusal(401, NEEDS_TOKEN);
        }
    }

    /// The token that a cookie has, as the header `Authorization` would have it.
    private static @Nullable String cookie(@Nullable String cookies) {
        return cookies == null
                ? null
                : Arrays.stream(cookies.split(";", -1))
                        .map(String::strip)
                        .filter(each -> each.startsWith(COOKIE + "="))
                        .map(each -> BEARER + each.substring(COOKIE.length() + 1))
                        .findFirst()
                        .orElse(null);
    }

    /// Lets a browser of another machine in, as it can't send its token along with all that it asks for.
    ///
    /// @return the header `Set-Cookie`
    /// @throws Refusal without a token
    String session(@Nullable String authorization) {
        if (authorization == null || role(authorization).isEmpty()) {
            throw new Refusal(401, NEEDS_TOKEN);
        }
        return "%s=%s; Path=/; Secure; HttpOnly; SameSite=Strict"
                .formatted(COOKIE, authorization.substring(BEARER.length()));
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

    /// For requests that all who may operate may make at any time.
    ///
    /// @throws Refusal without a token of such
    public void authorize(@Nullable String authorization) {
        require(Role.OPERATE, authorization);
    }

    /// For requests that only few may make.
    ///
    /// @throws Refusal without a token of such
    public void authorizeAdmin(@Nullable String authorization) {
        require(Role.ADMIN, authorization);
    }

    private void require(Role needed, @Nullable String authorization) {
        Role has = role(authorization).orElseThrow(() -> new Refusal(401, NEEDS_TOKEN));
        if (!has.includes(needed)) {
            throw new Refusal(
                    403, "This needs a token of the role '%s'. Yours has '%s'.".formatted(word(needed), word(has)));
        }
    }

    private static String word(Role role) {
        return role.name().toLowerCase(Locale.ROOT);
    }

    /// Whether that is the token of one who may operate, as headers have it.
    public boolean isToken(@Nullable String authorization) {
        return role(authorization).filter(role -> role.includes(Role.OPERATE)).isPresent();
    }

    /// All are compared, so that time says nothing of them.
    private Optional<Role> role(@Nullable String authorization) {
        if (authorization == null || !authorization.startsWith(BEARER)) {
            return Optional.empty();
        }
        byte[] shown = bytes(authorization.substring(BEARER.length()));
        return keys.stream()
                .filter(key -> MessageDigest.isEqual(key.token, shown))
                .map(Key::role)
                .max(Comparator.naturalOrder());
    }
}
