package rsal.bench.measurement;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.function.Function;
import java.util.function.IntConsumer;

/// Does the same with many things, as many at once as there are cores.
public final class AllCores {
    private AllCores() {}

    /// @param name of the threads that do it
    /// @param done told how many are done, one after the other in their order
    /// @return the result of each, in their order
    public static <T, R> List<R> each(
            String name, List<T> things, Function<? super T, ? extends R> work, IntConsumer done) {
        var threads = Thread.ofPlatform().daemon().name(name + "-", 1).factory();
        try (var workers = Executors.newFixedThreadPool(Runtime.getRuntime().availableProcessors(), threads)) {
            var futures = new ArrayList<Future<R>>();
            for (T thing : things) {
                futures.add(workers.submit(() -> work.apply(thing)));
            }
            try {
                var results = new ArrayList<R>();
                for (Future<R> future : futures) {
                    results.add(future.get());
                    done.accept(results.size());
                }
                return results;
            } catch (ExecutionException e) {
                workers.shutdownNow();
                throw new IllegalStateException("A run failed.", e.getCause());
            } catch (InterruptedException e) {
                workers.shutdownNow();
                Thread.currentThread().interrupt();
                throw new IllegalStateException("Measuring was interrupted.", e);
            }
        }
    }
}
