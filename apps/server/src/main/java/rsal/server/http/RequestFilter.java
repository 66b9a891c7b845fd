package rsal.server.http;

import java.nio.ByteBuffer;
import java.util.Map;
import java.util.regex.Pattern;
import org.eclipse.jetty.http.HttpHeader;
import org.eclipse.jetty.http.HttpHeaderValue;
import org.eclipse.jetty.io.Content;
import org.eclipse.jetty.server.Handler;
import org.eclipse.jetty.server.Request;
import org.eclipse.jetty.server.Response;
import org.eclipse.jetty.util.Callback;
import rsal.server.message.Json;
import rsal.server.message.Messages;
import rsal.server.message.Refusal;

/// What each request passes first, whatever it asks for and in whatever way: pages, commands, upgrades to
/// WebSocket, and what is not there. Nothing behind it sees a request that the [AccessControl] refuses.
///
/// Jetty calls it on threads of its own, several at once.
final class RequestFilter extends Handler.Wrapper {
    /// What answers have that a browser shows.
    static final Map<String, String> SECURITY_HEADERS = Map.of(
            "Content-Security-Policy",
                    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data:; connect-src 'self';"
                            + " frame-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'self'",
            "X-Content-Type-Options", "nosniff",
            "X-Frame-Options", "SAMEORIGIN",
            "Referrer-Policy", "no-referrer",
            "Cross-Origin-Opener-Policy", "same-origin",
            "Cross-Origin-Resource-Policy", "same-origin");

    /// The policy of [#SECURITY_HEADERS], but with frames in pages of other programs on this machine.
    private static final String FRAMED_POLICY = SECURITY_HEADERS
            .getOrDefault("Content-Security-Policy", "")
            .replace("frame-ancestors 'self'", "frame-ancestors 'self' http://127.0.0.1:* http://localhost:*");

    private static final String SITE = "Sec-Fetch-Site";
    private static final Pattern LIVE = Pattern.compile("(/beside/[^/]+)?/api/live");

    private final AccessControl gate;
    private final Connections connections;

    RequestFilter(AccessControl gate, Connections connections) {
        this.gate = gate;
        this.connections = connections;
    }

    @Override
    public boolean handle(Request request, Response plain, Callback callback) throws Exception {
        var response = new Answer(request, plain);
        SECURITY_HEADERS.forEach(response.getHeaders()::put);
        if (gate.isFramed() && !isRemote(request)) {
            response.getHeaders().put("Content-Security-Policy", FRAMED_POLICY);
            response.getHeaders().remove("X-Frame-Options"); // it knows no list of pages
        }
        response.getHeaders().put(HttpHeader.CACHE_CONTROL, "no-store");
        try {
            admit(request);
        } catch (Refusal refusal) {
            refuse(refusal, response, callback);
            return true;
        }
        return super.handle(request, response, callback);
    }

    private void admit(Request request) {
        var headers = request.getHeaders();
        if (isRemote(request)) {
            gate.admitRemote(
                    headers.get(HttpHeader.HOST),
                    headers.get(HttpHeader.ORIGIN),
                    headers.get(SITE),
                    request.getHttpURI().getCanonicalPath(),
                    headers.get(HttpHeader.AUTHORIZATION),
                    headers.get(HttpHeader.COOKIE));
        } else {
            gate.admit(headers.get(HttpHeader.HOST), headers.get(HttpHeader.ORIGIN), headers.get(SITE));
        }
        if (gate.isToken(headers.get(HttpHeader.AUTHORIZATION))) {
            connections.trust(request.getConnectionMetaData().getConnection().getEndPoint());
        }
        if ("websocket".equalsIgnoreCase(headers.get(HttpHeader.UPGRADE))
                && !LIVE.matcher(request.getHttpURI().getPath()).matches()) {
            throw new Refusal(
                    404,
                    "There is no WebSocket at '%s'."
                            .formatted(Refusal.shortened(request.getHttpURI().getPath())));
        }
    }

    private static boolean isRemote(Request request) {
        return PageServer.REMOTE.equals(
                request.getConnectionMetaData().getConnector().getName());
    }

    /// What is answered. Where a request's body has not come in whole when the answer begins, the answer says that the
    /// connection closes, as Jetty closes it then: a client that is not told so fails with its next request.
    private static final class Answer extends Response.Wrapper {
        Answer(Request request, Response wrapped) {
            super(request, wrapped);
        }

        @Override
        public void write(boolean last, ByteBuffer content, Callback callback) {
            if (!isCommitted() && !getRequest().consumeAvailable()) {
                getHeaders().put(HttpHeader.CONNECTION, HttpHeaderValue.CLOSE);
            }
            super.write(last, content, callback);
        }
    }

    private static void refuse(Refusal refusal, Response response, Callback callback) {
        response.setStatus(refusal.status());
        response.getHeaders().put(HttpHeader.CONTENT_TYPE, "application/json");
        String body = Json.write(new Messages.Refused(refusal.sentence(), refusal.problems()));
        Content.Sink.write(response, true, body, callback);
    }
}
