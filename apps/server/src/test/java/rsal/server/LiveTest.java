package rsal.server;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.WebSocket;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Random;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import rsal.scenario.RunOptions;
import rsal.server.frame.FrameEncoder;
import rsal.server.http.Http;
import rsal.server.live.Live;
import rsal.server.live.Viewer;
import rsal.server.live.ViewerCounts;
import rsal.server.live.ViewerCounts.Kind;

class LiveTest {
    @TempDir
    private Path directory;

    private RunServer server;
    private HttpClient http;

    @BeforeEach
    void start() throws Exception {
        server = Errand.serve(directory, 0);
        http = HttpClient.newHttpClient();
    }

    @AfterEach
    void stop() {
        http.shutdownNow();
        server.close();
    }

    @Test
    void sendsAViewerThatComesLateEverything() throws Exception {
        var early = new Browser();
        early.next(Message::isFrame);
        var late = new Browser();
        assertThat(late.next(m -> true).text())
                .startsWith("{\"run\":{\"number\":1,")
                .contains("\"scenario\":\"errand\"");
        assertThat(late.next(m -> true).text()).startsWith("{\"reach\":{\"run\":1");
        assertThat(late.next(m -> true).text()).startsWith("{\"details\":{\"run\":1");
        assertThat(late.next(Message::isFrame).header().getInt(4)).isEqualTo(1);
        assertThat(late.next(m -> m.text().startsWith("{\"events\"")).text()).contains("\"sequence\":1,");
    }

    @Test
    void showsTimeGoingOnToThoseWhoTakeFrames() throws Exception {
        var browser = new Browser();
        double time = 0;
        for (int i = 0; i < 5; i++) {
            double before = time;
            time = browser.next(m -> m.isFrame() && m.header().getDouble(16) > before)
                    .header()
                    .getDouble(16);
        }
        assertThat(time).isPositive();
    }

    @Test
    void showsTheNextRunToThoseWhoWatchedTheLast() throws Exception {
        var browser = new Browser();
        browser.next(Message::isFrame);
        var request = java.net.http.HttpRequest.newBuilder(server.url().resolve("/api/run/restart"))
                .header("Authorization", "Bearer " + Errand.TOKEN)
                .POST(java.net.http.HttpRequest.BodyPublishers.ofString("{\"configuration\":\"pair\"}"))
                .build();
        assertThat(http.send(request, java.net.http.HttpResponse.BodyHandlers.ofString())
                        .statusCode())
                .isEqualTo(200);
        assertThat(browser.next(m -> m.text().startsWith("{\"run\"")).text()).contains("\"number\":2", "\"courier-2\"");
        assertThat(browser.next(m -> m.isFrame() && m.header().getInt(4) == 2)
                        .header()
                        .getInt(32))
                .isEqualTo(2);
    }

    @Test
    void reportsHowTheRunEnded() throws Exception {
        var browser = new Browser();
        server.run().stop();
        assertThat(browser.next(m -> m.text().contains("\"outcome\":\"stopped\""))
                        .text())
                .contains("\"eventHash\":\"");
    }

    @Test
    void doesNotChangeTheRun() throws Exception {
        var plan = Errand.plan()
                .scenario()
                .plan(RunOptions.NONE
                        .withLimit(java.time.Duration.ofSeconds(20))
                        .withSpeed(Double.POSITIVE_INFINITY));
        String unwatched;
        try (var run = rsal.engine.LiveRun.start(plan)) {
            unwatched = run.result().toCompletableFuture().join().eventHash();
        }
        java.nio.file.Files.writeString(directory.resolve("index.html"), "");
        try (var watched = RunServer.start(plan, new RunServer.Options(0, Errand.TOKEN, directory, run -> {}))) {
            var browser = new Browser(watched.url());
            browser.next(m -> m.text().contains("\"outcome\":\"limit\""));
            assertThat(watched.run().result().toCompletableFuture().join().eventHash())
                    .isEqualTo(unwatched);
        }
    }

    @Test
    void endsSocketsThatTalkNonsenseAndServesTheOthers() throws Exception {
        var good = new Browser();
        long seed = 42;
        var random = new Random(seed);
        for (int i = 0; i < 60; i++) {
            var bad = new Browser();
            switch (random.nextInt(3)) {
                case 0 -> bad.socket.sendText(Fuzz.json(random), true).join();
                case 1 ->
                    bad.socket
                            .sendBinary(ByteBuffer.allocate(random.nextInt(100)), true)
                            .join();
                default ->
                    bad.socket.sendText("x".repeat(Http.MAX_MESSAGE + 1), true).join();
            }
            bad.socket.abort();
            byte[] noise = new byte[random.nextInt(1, 300)];
            random.nextBytes(noise);
            int port = server.url().getPort();
            assertThat(RawHttp.upgradeAndSend(port, noise, "Host: 127.0.0.1:" + port)
                            .status())
                    .as("seed %d, round %d", seed, i)
                    .isEqualTo(101);
        }
        assertThat(good.next(Message::isFrame).header().getInt(0)).isEqualTo(FrameEncoder.MAGIC);
        int newest = good.newest;
        good.next(m -> m.isFrame() && m.header().getInt(8) > newest + 3);
    }

    @Test
    void closesSocketsWithAReason() throws Exception {
        var browser = new Browser();
        browser.socket.sendText("{\"frames\":1}", true).join();
        assertThat(browser.next(Message::isEnd).text()).startsWith("1008").contains("receipts");
        var large = new Browser();
        large.socket
                .sendText("{\"frame\":1" + " ".repeat(Http.MAX_MESSAGE) + "}", true)
                .join();
        assertThat(large.next(Message::isEnd).text()).startsWith("1009");
        var bytes = new Browser();
        bytes.socket.sendBinary(ByteBuffer.allocate(8), true).join();
        assertThat(bytes.next(Message::isEnd).text()).startsWith("1003");
    }

    @Test
    void hasRoomForSoManyViewers() throws Exception {
        for (int i = 0; i < Live.MAX_VIEWERS; i++) {
            new Browser().next(m -> true);
        }
        assertThat(new Browser().next(Message::isEnd).text()).startsWith("1013");
    }

    @Test
    void whoeverHasTheTokenEntersAndIsInformed() throws Exception {
        var first = new Browser();
        first.next(m -> true);
        for (int i = 1; i < Live.MAX_VIEWERS; i++) {
            new Browser().next(m -> true);
        }
        var operator = new Browser();
        operator.socket
                .sendText("{\"token\":\"%s\"}".formatted(Errand.TOKEN), true)
                .join();

        assertThat(operator.next(m -> m.text().contains("access")).text()).isEqualTo("{\"access\":{\"control\":true}}");
        assertThat(operator.next(m -> m.text().startsWith("{\"run\"")).text()).contains("errand");
        assertThat(first.next(Message::isEnd).text()).startsWith("1013");
    }

    @Test
    void aTokenOfAnotherServerIsRefused() throws Exception {
        var viewer = new Browser();
        viewer.socket.sendText("{\"token\":\"of-before\"}", true).join();

        assertThat(viewer.next(m -> m.text().contains("access")).text()).isEqualTo("{\"access\":{\"control\":false}}");
    }

    @Test
    @Timeout(60)
    void holdsLittleForAViewerThatNeverReads() throws Exception {
        int port = server.url().getPort();
        ViewerCounts counts = server.seats().first().live().counts();
        try (var mute = new Socket()) {
            mute.setReceiveBufferSize(4096);
            mute.connect(new InetSocketAddress(InetAddress.ofLiteral("127.0.0.1"), port));
            mute.getOutputStream().write("""
                    GET /api/live HTTP/1.1\r
                    Host: 127.0.0.1:%d\r
                    Upgrade: websocket\r
                    Connection: Upgrade\r
                    Sec-WebSocket-Version: 13\r
                    Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r
                    \r
                    """.formatted(port).getBytes(StandardCharsets.ISO_8859_1));
            var good = new Browser(); // which shows that time goes on
            int[] taken = new int[1];
            good.next(m -> m.isFrame() && ++taken[0] > 40);
            assertThat(counts.messages(Kind.FRAME) - taken[0])
                    .as("frames for the mute one, and those that the other has not yet taken")
                    .isBetween(1L, 2L * Viewer.FRAMES);
            assertThat(counts.messages(Kind.EVENTS)).isLessThanOrEqualTo(1 + taken[0]);
        }
    }

    private record Message(String text, byte[] frame) {
        boolean isFrame() {
            return frame.length > 0;
        }

        boolean isEnd() {
            return text.matches("\\d{4} .*");
        }

        ByteBuffer header() {
            return ByteBuffer.wrap(frame).order(ByteOrder.LITTLE_ENDIAN);
        }
    }

    /// Takes what it is sent, as the page does.
    private final class Browser implements WebSocket.Listener {
        private final BlockingQueue<Message> messages = new LinkedBlockingQueue<>();
        private final StringBuilder text = new StringBuilder();
        private final java.io.ByteArrayOutputStream bytes = new java.io.ByteArrayOutputStream();
        private final WebSocket socket;
        private int newest;

        Browser() {
            this(server.url());
        }

        Browser(URI url) {
            socket = http.newWebSocketBuilder()
                    .buildAsync(URI.create("ws://127.0.0.1:" + url.getPort() + "/api/live"), this)
                    .join();
        }

        /// The next message like this; those before it are dropped.
        Message next(Predicate<Message> wanted) throws InterruptedException {
            while (true) {
                Message message = messages.poll(20, TimeUnit.SECONDS);
                assertThat(message).as("message that never came").isNotNull();
                if (message.isFrame()) {
                    newest = message.header().getInt(8);
                    var _ = socket.sendText("{\"frame\":%d}".formatted(newest), true);
                }
                if (wanted.test(message)) {
                    return message;
                }
            }
        }

        @Override
        public @Nullable CompletionStage<?> onText(WebSocket socket, CharSequence part, boolean last) {
            text.append(part);
            if (last) {
                messages.add(new Message(text.toString(), new byte[0]));
                text.setLength(0);
            }
            socket.request(1);
            return null;
        }

        @Override
        public @Nullable CompletionStage<?> onBinary(WebSocket socket, ByteBuffer part, boolean last) {
            byte[] content = new byte[part.remaining()];
            part.get(content);
            bytes.writeBytes(content);
            if (last) {
                messages.add(new Message("", bytes.toByteArray()));
                bytes.reset();
            }
            socket.request(1);
            return null;
        }

        @Override
        public @Nullable CompletionStage<?> onClose(WebSocket socket, int status, String reason) {
            messages.add(new Message(status + " " + reason, new byte[0]));
            return null;
        }
    }
}
