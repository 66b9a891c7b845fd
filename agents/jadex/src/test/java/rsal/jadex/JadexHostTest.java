package rsal.jadex;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.lang.reflect.Field;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import rsal.agent.AgentHostProvider;
import rsal.settings.Arguments;
import rsal.testkit.contract.AgentHostContract;
import rsal.time.LockstepScheduler;

class JadexHostTest extends AgentHostContract {
    private static final String PATIENCE = "jadex.bridge.TimeoutResultListener";

    @Override
    protected AgentHostProvider provider() {
        return new JadexHostProvider();
    }

    @Test
    void writesNoFiles() throws IOException {
        Set<Path> before = files();
        var host = new JadexHostProvider().create(Arguments.defaults(List.of()), new LockstepScheduler());
        host.close();
        assertThat(files()).isEqualTo(before);
    }

    private static Set<Path> files() throws IOException {
        try (Stream<Path> here = Files.list(Path.of(""))) {
            return here.collect(Collectors.toSet());
        }
    }

    /// Jadex waits for some answers half a minute long when it ends, each with a timer of its own. No other timer is
    /// let
    /// off: not that of its pool of threads, nor one of ours.
    @Override
    protected boolean endsLater(Thread thread) {
        List<Object> due = tasks(thread);
        return !due.isEmpty()
                && due.stream().allMatch(task -> task.getClass().getName().startsWith(PATIENCE + "$"));
    }

    /// Of a [java.util.Timer], if it is the thread of one.
    private static List<Object> tasks(Thread thread) {
        if (!thread.getClass().getName().equals("java.util.TimerThread")) {
            return List.of();
        }
        try {
            Object queue = get(thread, "queue");
            synchronized (queue) {
                return Arrays.stream((Object[]) get(queue, "queue"))
                        .filter(Objects::nonNull)
                        .toList();
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
