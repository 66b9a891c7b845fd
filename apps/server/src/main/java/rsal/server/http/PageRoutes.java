package rsal.server.http;

import io.javalin.config.RoutesConfig;
import io.javalin.http.Context;
import io.javalin.http.Header;
import io.javalin.http.HttpResponseException;
import java.io.IOException;
import java.util.Arrays;
import java.util.concurrent.CancellationException;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import rsal.server.http.Page.Asset;
import rsal.server.message.Messages.Refused;
import rsal.server.message.Refusal;

/// Serves the page, and says why requests are refused.
public final class PageRoutes {
    private static final Logger LOG = LoggerFactory.getLogger(PageRoutes.class);
    private static final String REFUSED = "refused"; // of a request

    private PageRoutes() {}

    /// After all else: the page, and refusals.
    ///
    /// @param isLate what is told nothing where it would be refused as things are
    public static void serve(RoutesConfig routes, Page page, Predicate<Context> isLate) {
        routes.get("/*", request -> asset(request, page, request.path()));

        routes.exception(Refusal.class, (refusal, request) -> {
            if (refusal.status() == 409 && isLate.test(request)) {
                request.status(204);
            } else {
                refuse(request, refusal);
            }
        });
        routes.exception(
                HttpResponseException.class,
                (e, request) -> refuse(request, new Refusal(e.getStatus(), String.valueOf(e.getMessage()))));
        // what takes too long (PageServer) Javalin ends as an error of which it says nothing, then it cancels it; what
        // is there of an answer, or comes just then, is none
        routes.error(500, request -> {
            if (request.attribute(REFUSED) == null) {
                refuseLate(request);
            }
        });
        routes.exception(CancellationException.class, (_, request) -> refuseLate(request));
        routes.exception(IOException.class, (e, request) -> { // the client closed the connection, or sent no more
            LOG.debug("Could not answer {} {}.", request.method(), request.path(), e);
            refuse(request, new Refusal(400, "The request is incomplete."));
        });
        routes.exception(Exception.class, (e, request) -> {
            LOG.error("Could not answer {} {}.", request.method(), request.path(), e);
            refuse(request, new Refusal(500, "The server failed. Its log says why."));
        });
    }

    public static void asset(Context request, Page page, String path) {
        Asset asset = page.find(path)
                .orElseThrow(
                        () -> new Refusal(404, "There is no '%s' here.".formatted(Refusal.shortened(request.path()))));
        if (asset.hashed()) {
            request.header(Header.CACHE_CONTROL, "max-age=31536000, immutable");
        }
        request.header(Header.VARY, Header.ACCEPT_ENCODING);
        boolean packed = asset.packed().isPresent() && takesGzip(request.header(Header.ACCEPT_ENCODING));
        if (packed) {
            request.header(Header.CONTENT_ENCODING, "gzip");
        }
        request.contentType(asset.type()).result(packed ? asset.packed().orElseThrow() : asset.content());
    }

    /// @param accepted as RFC 9110, 12.5.3, has it: `gzip, deflate, br;q=0.5`
    private static boolean takesGzip(@Nullable String accepted) {
        return accepted != null
                && Arrays.stream(accepted.split(",", -1))
                        .map(String::strip)
                        .anyMatch(one -> one.matches("gzip(\\s*;\\s*q=(1(\\.0*)?|0?\\.\\d*[1-9]\\d*))?"));
    }

    private static void refuseLate(Context request) {
        refuse(request, new Refusal(503, "The run did not answer in time. Maybe this machine is busy."));
    }

    private static void refuse(Context request, Refusal refusal) {
        request.attribute(REFUSED, true);
        request.status(refusal.status());
        Http.answer(request, new Refused(refusal.sentence(), refusal.problems()));
    }
}
