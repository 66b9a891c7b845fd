package rsal.testkit.time;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.junit.jupiter.api.AfterEach;
import rsal.testkit.contract.SchedulerContract;
import rsal.time.Scheduler;
import rsal.time.WallScheduler;

/// By the time of the machine. What else it does is tested beside it.
class WallSchedulerContractTest extends SchedulerContract {
    private final List<Throwable> failures = new CopyOnWriteArrayList<>();
    private final ExecutorService workers = Executors.newFixedThreadPool(2);
    private final WallScheduler scheduler = new WallScheduler("run-test", workers, failures::add);

    @AfterEach
    void tearDown() {
        scheduler.close();
        workers.close();
        assertThat(failures).isEmpty();
    }

    @Override
    protected Scheduler scheduler() {
        return scheduler;
    }

    @Override
    protected <T> T await(CompletableFuture<T> future) {
        try {
            return future.get(10, TimeUnit.SECONDS);
        } catch (InterruptedException | ExecutionException | TimeoutException e) {
            throw new AssertionError(e);
        }
    }
}
