package rsal.server.http;

import io.javalin.http.Context;
import io.javalin.http.Header;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.zip.GZIPOutputStream;
import rsal.server.message.Json;
import rsal.server.message.Refusal;

/// Reads requests and writes answers.
public final class Http {
    /// Of a WebSocket message or a request's body [B]; all that the page sends is smaller.
    public static final int MAX_MESSAGE = 16 * 1024;

    /// Of a request's body that has the text of a scenario [B], or two of them; the longest built in has 8 kB.
    public static final int MAX_TEXT = 512 * 1024;

    private Http() {}

    /// What was asked for by that name; empty when it was left out.
    public static String parameter(Context request, String name) {
        String asked = request.queryParam(name);
        return asked == null ? "" : asked;
    }

    /// As [AccessControl#OPERATOR] says; empty when it doesn't.
    public static String operator(Context request) {
        String operator = request.header(AccessControl.OPERATOR);
        return operator == null ? "" : operator;
    }

    /// Lets through who may change something now; see [AccessControl#authorize(String, String)].
    public static void authorize(Context request, AccessControl gate) {
        gate.authorize(request.header(Header.AUTHORIZATION), operator(request));
    }

    /// The same for what only few may change; see [AccessControl#authorizeAdmin].
    public static void authorizeAdmin(Context request, AccessControl gate) {
        gate.authorizeAdmin(request.header(Header.AUTHORIZATION));
        gate.lease().check(operator(request));
    }

    public static <T extends Record> T read(Context request, Class<T> type) throws IOException {
        return read(request, type, MAX_MESSAGE);
    }

    /// @param most bytes of the request's body
    public static <T extends Record> T read(Context request, Class<T> type, int most) throws IOException {
        return Json.read(body(request, most), type);
    }

    public static void answer(Context request, Object message) {
        request.contentType("application/json").result(Json.write(message));
    }

    /// @param bytes as [#packed] packs them
    public static void answerPacked(Context request, byte[] bytes) {
        request.header(Header.CONTENT_ENCODING, "gzip");
        request.contentType("application/octet-stream").result(bytes);
    }

    public static byte[] packed(byte[] bytes) {
        var packed = new ByteArrayOutputStream();
        try (var gzip = new GZIPOutputStream(packed)) {
            gzip.write(bytes);
        } catch (IOException e) {
            throw new UncheckedIOException(e); // nothing in memory throws it
        }
        return packed.toByteArray();
    }

    /// An object of values by name.
    ///
    /// @param names that it may have, for people
    public static Map<String, Object> readObject(Context request, List<String> names) throws IOException {
        return Json.readObject(body(request, MAX_MESSAGE), names);
    }

    private static String body(Context request, int most) throws IOException {
        byte[] body = request.bodyInputStream().readNBytes(most + 1);
        if (body.length > most) {
            throw new Refusal(413, "A request has at most %d bytes.".formatted(most));
        }
        return new String(body, StandardCharsets.UTF_8);
    }
}
