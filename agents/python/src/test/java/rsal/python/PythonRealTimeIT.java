package rsal.python;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import rsal.agent.AgentSpec;
import rsal.agent.AgentType;
import rsal.agent.Topic;
import rsal.agent.platform.AgentPlatform;
import rsal.agent.platform.PlainHost;
import rsal.settings.Arguments;
import rsal.testkit.fake.TestedType;
import rsal.time.WallScheduler;

/// Agents in Python, in real time: a slow one never holds up the run.
@SuppressWarnings("rawtypes") // contents are told by a class, which has no parameters
class PythonRealTimeIT {
    private static final Topic<Map> NUMBERS = new Topic<>("numbers", Map.class);

    private final WallScheduler run = new WallScheduler("run", Runnable::run);
    private final AgentPlatform platform = new AgentPlatform(run, new PlainHost(run), Optional.empty());
    private final List<String> lines = new CopyOnWriteArrayList<>();

    @AfterEach
    void close() {
        run.exclusively(platform::close);
        run.close();
    }

    private void start(String name, String body) {
        String text = "import time\nimport rsal\nNUMBERS = rsal.Topic('numbers', dict)\nclass A(rsal.Agent):\n"
                + body.indent(4);
        AgentType type = Texts.type(name + ".py", Map.of(name + ".py", text));
        run.exclusively(() -> {
            platform.onPrint(print -> lines.add(print.agent() + ": " + print.line()));
            platform.start(new AgentSpec(name, "tested", type, Arguments.defaults(List.of()), Optional.empty(), 1));
        });
    }

    private static void await(BooleanSupplier done) throws InterruptedException {
        for (int i = 0; i < 2000 && !done.getAsBoolean(); i++) {
            TimeUnit.MILLISECONDS.sleep(10);
        }
        assertThat(done.getAsBoolean()).isTrue();
    }

    @Test
    void aSlowOneKeepsMessagesAndHoldsUpNobody() throws InterruptedException {
        var beats = new AtomicInteger();
        start("slow", """
                def on_start(self):
                    self.heard = []
                    self.ticks = 0
                    self.subscribe(NUMBERS, self.on_number)
                    self.every(0.01, self.tick)
                    print("ready")
                def tick(self):
                    self.ticks += 1
                def on_number(self, message):
                    self.heard.append(message.content["n"])
                    if message.content["n"] == 0:
                        time.sleep(1.0)
                    if message.content["n"] == 49:
                        print(self.heard == list(range(50)), self.ticks < 60, self.agents()[0].name)
                """);
        await(() -> lines.contains("slow: ready"));
        run.exclusively(() -> platform.start(new AgentSpec(
                "java",
                "tested",
                new TestedType(self -> self.scheduler().every(Duration.ofMillis(10), () -> {
                    int n = beats.getAndIncrement();
                    if (n < 50) {
                        self.publish(NUMBERS, Map.of("n", n));
                    }
                })),
                Arguments.defaults(List.of()),
                Optional.empty(),
                1)));
        await(() -> beats.get() >= 50);
        assertThat(lines).containsExactly("slow: ready"); // it sleeps, and the run goes on
        await(() -> lines.stream().anyMatch(line -> line.endsWith(" slow")));
        assertThat(lines).contains("slow: True True slow");
    }

    @Test
    void latenessIsAMetricAndAnEvent() throws InterruptedException {
        var worst = new AtomicReference<>(0.0);
        run.exclusively(() -> platform.onMetric(metric -> worst.accumulateAndGet(metric.value(), Math::max)));
        start("slow", """
                def on_start(self):
                    self.every(0.02, self.tick)
                    self.after(0.1, time.sleep, 0.8)
                def tick(self):
                    pass
                """);
        await(() -> !lines.isEmpty());
        assertThat(lines.getFirst()).matches("slow: is late: what happens waits up to [01]\\.\\d s for Python");
        assertThat(worst.get()).isBetween(0.7, 1.9);
    }

    @Test
    void onesThatWaitForACallThatDoesNotReturnSayWhereThatIs() throws InterruptedException {
        start("slow", """
                def on_start(self):
                    self.after(0.1, self.rest)
                def rest(self):
                    for _ in range(300):
                        time.sleep(0.01)
                """);
        start("bob", """
                def on_start(self):
                    self.every(0.05, self.tick)
                def tick(self):
                    pass
                """);
        await(() -> !lines.isEmpty());
        assertThat(lines.getFirst())
                .matches(
                        "bob: waits: Python has not returned for 2\\.\\d s; it is at slow.py:[89] in rest of agent 'slow'");
    }

    @Test
    void anErrorEndsItAndItsLastWordsAreHeard() throws InterruptedException {
        start("amy", """
                def on_start(self):
                    self.after(0.05, self.fail)
                def fail(self):
                    raise ValueError("so")
                """);
        start("bob", """
                def on_start(self):
                    print("begins")
                def on_stop(self):
                    print("bye")
                """);
        await(() -> platform.view("amy").orElseThrow().status() == AgentPlatform.Status.FAILED);
        assertThat(platform.view("amy").orElseThrow().state()).isEqualTo("amy.py:8 in fail: ValueError: so");
        await(() -> lines.contains("bob: begins"));
        run.exclusively(() -> platform.stop("bob"));
        await(() -> lines.contains("bob: bye"));
    }

    @Test
    void oneThatIsStoppedHoldsUpNobodyAndItsLastWordsAreHeard() throws Exception {
        Path wait = Files.createTempFile("wait", "");
        start("bob", """
                def on_start(self):
                    self.every(0.01, self.tick)
                    self.ticks = 0
                    print("begins")
                def tick(self):
                    self.ticks += 1
                def on_stop(self):
                    import os
                    ticks = self.ticks
                    while os.path.exists('%s'):
                        time.sleep(0.01)
                    print("bye", self.ticks == ticks)
                """.formatted(wait.toString().replace('\\', '/')));
        await(() -> lines.contains("bob: begins"));
        run.exclusively(() -> platform.stop("bob"));
        run.exclusively(
                () -> assertThat(platform.view("bob").orElseThrow().status()).isEqualTo(AgentPlatform.Status.RUNNING));
        Files.delete(wait); // only now it can end
        await(() -> platform.view("bob").orElseThrow().status() == AgentPlatform.Status.ENDED);
        assertThat(lines).contains("bob: bye True");
    }

    @Test
    void lastWordsAreHeardAtTheEndOfTheRun() throws InterruptedException {
        start("bob", """
                def on_start(self):
                    print("begins")
                def on_stop(self):
                    print("bye")
                """);
        await(() -> lines.contains("bob: begins"));
        run.exclusively(platform::close);
        assertThat(lines).contains("bob: bye");
    }

    @Test
    void oneForWhichTooMuchWaitsEnds() throws Exception {
        Path wait = Files.createTempFile("wait", "");
        start("slow", """
                def on_start(self):
                    self.subscribe(NUMBERS, self.on_number)
                    self.after(0.01, self.block)
                    print("begins")
                def on_number(self, message):
                    pass
                def block(self):
                    import os
                    print("blocks")
                    self.agents()
                    while os.path.exists('%s'):
                        time.sleep(0.01)
                """.formatted(wait.toString().replace('\\', '/')));
        await(() -> lines.contains("slow: blocks"));
        run.exclusively(() -> {
            for (int i = 0; i < 10_010; i++) {
                platform.publish("test", NUMBERS, Map.of("n", i));
            }
        });
        await(() -> platform.view("slow").orElseThrow().status() == AgentPlatform.Status.FAILED);
        Files.delete(wait);
        assertThat(platform.view("slow").orElseThrow().state()).startsWith("More than 10000 events wait for it");
    }
}
