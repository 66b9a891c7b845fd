package rsal.agent.platform;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import rsal.time.WallScheduler;

@Timeout(60)
class ThreadLaneTest {
    private final WallScheduler run = new WallScheduler("tested", Runnable::run);
    private final ExecutorService thread = Executors.newSingleThreadExecutor();
    private final ThreadLane lane = new ThreadLane(run, thread);
    private final List<String> log = new ArrayList<>(); // written in turn
    private final CountDownLatch done = new CountDownLatch(1);

    @AfterEach
    void end() {
        run.close();
        thread.shutdown();
    }

    @Test
    void whatIsDueAtOnceIsDoneBeforeWhatIsHandedInLater() throws InterruptedException {
        run.exclusively(() -> {
            lane.after(Duration.ZERO, () -> log.add("due"));
            lane.execute(() -> log.add("handed in"));
            lane.execute(done::countDown);
        });
        done.await();
        assertThat(log).containsExactly("due", "handed in");
    }

    @Test
    void whatIsDueAtOnceMayBeCancelled() throws InterruptedException {
        run.exclusively(() -> {
            lane.after(Duration.ZERO, () -> log.add("due")).cancel();
            lane.execute(done::countDown);
        });
        done.await();
        assertThat(log).isEmpty();
    }
}
