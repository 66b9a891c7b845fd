package rsal.jadex;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import rsal.agent.AgentHostProvider;
import rsal.settings.Arguments;
import rsal.testkit.contract.AgentHostContract;
import rsal.time.LockstepScheduler;

class JadexHostTest extends AgentHostContract {
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

    /// Some answers that it waits for half a minute long when it ends.
    @Override
    protected boolean endsLater(Thread thread) {
        return thread.isDaemon() && thread.getName().startsWith("Timer-");
    }
}
