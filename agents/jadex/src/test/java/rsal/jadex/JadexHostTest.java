package rsal.jadex;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.tuple;

import jadex.bridge.ComponentIdentifier;
import jadex.bridge.IExternalAccess;
import java.io.IOException;
import java.lang.reflect.Field;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import rsal.agent.Agent;
import rsal.agent.AgentContext;
import rsal.agent.AgentHostProvider;
import rsal.agent.Topic;
import rsal.agent.platform.AgentPlatform.Status;
import rsal.testkit.contract.AgentHostContract;
import rsal.testkit.contract.HostRun;

class JadexHostTest extends AgentHostContract {
    private static final String CLOCK = "jadex.platform.service.clock.ClockService";
    private static final Topic<String> WORDS = new Topic<>("words", String.class);
    private static final Duration BEAT = Duration.ofMillis(20);
    private static final Duration PATIENCE = Duration.ofSeconds(60);

    @Override
    protected AgentHostProvider provider() {
        return new JadexHostProvider();
    }

    @Test
    void writesNoFiles() throws IOException {
        Set<Path> before = files();
        IExternalAccess platform = LonelyPlatform.start();
        var heard = new ArrayList<String>();
        try (var run = HostRun.inRealTime(time -> new JadexHost(time, platform))) {
            run.start("amy", self -> self.subscribe(WORDS, m -> heard.add(m.sender() + ": " + m.content())));
            run.start("bob", self -> self.scheduler().every(BEAT, () -> self.publish(WORDS, "hi")));
            run.until("one has heard the other", () -> heard.contains("bob: hi"));
            run.act(() -> run.platform().stop("bob"));
        }
        platform.waitForTermination().get(PATIENCE.toMillis());
        assertThat(files()).isEqualTo(before);
    }

    @Test
    void whomJadexEndsByItselfEndsHereToo() {
        IExternalAccess platform = LonelyPlatform.start();
        var log = new ArrayList<String>();
        try (var run = HostRun.inRealTime(time -> new JadexHost(time, platform))) {
            run.start(
                    "bob",
                    self -> self.directory()
                            .onDeparture(went -> log.add(went.agent().name() + " went")));
            run.start("amy", new Agent() {
                @Override
                public void start(AgentContext self) {
                    self.scheduler().every(BEAT, () -> log.add("amy lives"));
                }

                @Override
                public void stop(AgentContext self) {
                    log.add("last words");
                }
            });
            run.until("it lives", () -> log.contains("amy lives"));
            platform.getExternalAccess(new ComponentIdentifier("amy", platform.getId()))
                    .killComponent();
            run.until("the other knows", () -> log.contains("amy went"));
            assertThat(log).containsSubsequence("last words", "amy went").endsWith("amy went");
            assertThat(run.ask(() -> run.platform().views()))
                    .extracting(view -> view.agent().name(), view -> view.status())
                    .containsExactly(tuple("bob", Status.RUNNING), tuple("amy", Status.ENDED));
        }
    }

    private static Set<Path> files() throws IOException {
        try (Stream<Path> here = Files.list(Path.of(""))) {
            return here.collect(Collectors.toSet());
        }
    }

    /// Jadex's clock makes a timer for each thread that is among the first to ask for one, and ends only the
    /// last of these; the others wait half a minute for answers. And it has a process started, whose end a
    /// thread of the JDK saw. No other is let off: no timer of something else of Jadex's, none of ours, nor one
    /// that has nothing to do.
    @Override
    protected boolean endsLater(Thread thread) {
        return switch (thread.getClass().getName()) {
            case "java.util.TimerThread" -> {
                List<Object> due = due(thread).toList();
                yield !due.isEmpty()
                        && due.stream()
                                .allMatch(task -> task.getClass().getName().startsWith(CLOCK + "$"));
            }
            default -> thread.getName().equals("process reaper");
        };
    }

    /// What a timer has still to do.
    private static Stream<Object> due(Thread timer) {
        try {
            Object queue = get(timer, "queue");
            synchronized (queue) {
                return Stream.of(((Object[]) get(queue, "queue")).clone()).filter(Objects::nonNull);
            }
        } catch (ReflectiveOperationException e) {
            throw new LinkageError(e.getMessage(), e);
        }
    }

    private static Object get(Object owner, String name) throws ReflectiveOperationException {
        Field field = owner.getClass().getDeclaredField(name);
        field.setAccessible(true);
        return field.get(owner);
    }
}
