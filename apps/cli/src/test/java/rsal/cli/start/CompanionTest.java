package rsal.cli.start;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;

class CompanionTest {
    @Test
    @DisabledOnOs(OS.WINDOWS)
    void itsEndIsNoticedHoweverItEnds() throws IOException, InterruptedException {
        Process other = new ProcessBuilder("sleep", "100").start();
        var ended = new CountDownLatch(1);
        Companion.watch(Long.toString(other.pid()), ProcessHandle::of, ended::countDown);
        assertThat(ended.getCount()).isEqualTo(1);
        other.destroyForcibly();
        assertThat(ended.await(60, TimeUnit.SECONDS)).isTrue();
    }

    @Test
    void oneThatHasEndedBeforeCountsAsWell() {
        var ended = new CountDownLatch(1);
        Companion.watch("7", _ -> Optional.empty(), ended::countDown);
        assertThat(ended.getCount()).isZero();
    }

    @Test
    void whatIsNoNumberIsRefused() {
        assertThatThrownBy(() -> Companion.watch(Map.of("RSAL_END_WITH", "python")))
                .hasMessage("The environment variable RSAL_END_WITH must be the number of a process, not 'python'.");
        Companion.watch(Map.of());
    }
}
