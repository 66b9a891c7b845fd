package rsal.recording;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import rsal.engine.LiveRun;
import rsal.engine.report.RunEvent;
import rsal.engine.report.Snapshot;
import rsal.recording.Backlog.Behind;

@Timeout(60)
class BacklogTest {
    private static final int MORE_THAN_WAIT = 100_100;

    private static RunEvent event(int sequence) {
        return new RunEvent(sequence, Duration.ofSeconds(1), "test", "", "something");
    }

    /// A run goes on when whoever takes has gone, be it after the end or in the middle.
    @ParameterizedTest
    @EnumSource(Behind.class)
    void nobodyWaitsForWhoHasGone(Behind behind) {
        Snapshot state = LiveRun.start(Recorded.plan("hunt-and-prey", 1, 1)).snapshot();
        var ended = new Backlog(behind);
        ended.happened(event(1), "");
        ended.end();
        var abandoned = new Backlog(behind);
        abandoned.abandon();
        for (int i = 0; i < MORE_THAN_WAIT; i++) {
            ended.happened(event(i), "");
            abandoned.happened(event(i), "");
        }
        for (int i = 0; i < 100; i++) {
            ended.sees(state, "");
            abandoned.sees(state, "");
        }
        assertThat(ended.isOver()).isFalse();
        assertThat(ended.take()).isPresent(); // what was told before
        assertThat(ended.isOver()).isTrue();
        assertThat(abandoned.take()).isEmpty();
    }

    @Test
    void theNewestStatesWinAndNoEventIsLost() {
        Snapshot state = LiveRun.start(Recorded.plan("hunt-and-prey", 1, 1)).snapshot();
        var backlog = new Backlog(Behind.DROP);
        for (int i = 0; i < 100; i++) {
            backlog.sees(state, "");
            backlog.happened(event(i), "");
        }
        backlog.end();
        int states = 0;
        int all = 0;
        while (!backlog.isOver()) {
            all++;
            states += backlog.take().orElseThrow().seen().isPresent() ? 1 : 0;
        }
        assertThat(states).isBetween(1, 20);
        assertThat(states + backlog.dropped()).isEqualTo(100);
        assertThat(all - states).isEqualTo(100);
    }
}
