package rsal.bench.page;

import java.io.BufferedInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.jspecify.annotations.Nullable;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.ObjectMapper;
import tools.jackson.databind.json.JsonMapper;

/// Questions to a browser and its answers, by its DevTools protocol over a pipe
/// (https://chromedevtools.github.io/devtools-protocol): each is a text of JSON that a byte of zero ends. What nobody
/// asked is left out.
///
/// One thread asks, and waits for the answer; another one reads, until there is no more.
final class DevTools {
    private static final int PATIENCE_SECONDS = 30;
    private static final ObjectMapper JSON = new JsonMapper();

    private final OutputStream questions;
    private final Map<Integer, CompletableFuture<JsonNode>> asked = new ConcurrentHashMap<>();
    private int last; // number of the newest question
    private volatile @Nullable Exception end; // why no more answers come

    /// @param answers read to their end by a thread of its own
    DevTools(OutputStream questions, InputStream answers) {
        this.questions = questions;
        Thread.ofPlatform().daemon().name("devtools").start(() -> read(new BufferedInputStream(answers)));
    }

    /// @param session whom it is for: empty is the browser itself
    /// @throws IllegalStateException when it refuses, has gone, or says nothing for half a minute
    JsonNode ask(String session, String method, Map<String, Object> parameters) {
        int id = ++last;
        var answer = new CompletableFuture<JsonNode>();
        asked.put(id, answer);
        Exception ended = end;
        if (ended != null) {
            answer.completeExceptionally(ended);
        }
        try {
            questions.write(JSON.writeValueAsBytes(
                    session.isEmpty()
                            ? Map.of("id", id, "method", method, "params", parameters)
                            : Map.of("id", id, "method", method, "params", parameters, "sessionId", session)));
            questions.write(0);
            questions.flush();
            JsonNode whole = answer.get(PATIENCE_SECONDS, TimeUnit.SECONDS);
            if (whole.has("error")) {
                throw new IllegalStateException("The browser refuses '%s': %s".formatted(method, whole.path("error")));
            }
            return whole.path("result");
        } catch (IOException | ExecutionException | TimeoutException e) {
            throw new IllegalStateException("The browser does not answer '%s'.".formatted(method), e);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new IllegalStateException("Interrupted while the browser was asked.", e);
        } finally {
            asked.remove(id);
        }
    }

    private void read(InputStream answers) {
        var text = new ByteArrayOutputStream();
        try (answers) {
            for (int next = answers.read(); next >= 0; next = answers.read()) {
                if (next != 0) {
                    text.write(next);
                    continue;
                }
                JsonNode whole = JSON.readTree(text.toByteArray());
                text.reset();
                CompletableFuture<JsonNode> answer = asked.get(whole.path("id").asInt(0));
                if (answer != null) {
                    answer.complete(whole);
                }
            }
            giveUp(new IOException("It has ended."));
        } catch (IOException | RuntimeException e) {
            giveUp(e);
        }
    }

    private void giveUp(Exception why) {
        end = why;
        asked.values().forEach(answer -> answer.completeExceptionally(why));
    }
}
