package rsal.agent.platform;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import rsal.agent.AgentContext;
import rsal.agent.OutsideAgent;

/// Of agents whose code runs elsewhere.
class LastWordsTest {
    private final Run run = new Run();
    private final List<String> log = new ArrayList<>();
    private final CompletableFuture<Runnable> words = new CompletableFuture<>();

    private void start() {
        run.startListener("amy", heard -> log.add("amy heard " + heard));
        run.start("far", new OutsideAgent() {
            @Override
            public void start(AgentContext self) {
                self.atEnd(() -> log.add("ended"));
            }

            @Override
            public CompletionStage<Runnable> lastWords(AgentContext self) {
                log.add("stopped");
                return words.thenApply(said -> () -> {
                    said.run();
                    self.publish(Run.WORDS, "bye");
                });
            }
        });
        run.advance(0.1);
    }

    private AgentPlatform.Status status() {
        return run.view("far").status();
    }

    @Test
    void itLivesUntilTheyAreThere() {
        start();
        run.stop("far");
        run.stop("far");
        run.advance(1);
        assertThat(status()).isEqualTo(AgentPlatform.Status.RUNNING);
        words.complete(() -> {});
        run.advance(0.1);
        assertThat(status()).isEqualTo(AgentPlatform.Status.ENDED);
        run.advance(5);
        assertThat(log).containsExactly("stopped", "ended", "amy heard far: bye");
    }

    @Test
    void itEndsWithoutThemAfterTwoSeconds() {
        start();
        run.stop("far");
        run.advance(2.1);
        assertThat(status()).isEqualTo(AgentPlatform.Status.ENDED);
        words.complete(() -> {});
        run.advance(1);
        assertThat(log).containsExactly("stopped", "ended");
    }

    @Test
    void whatTheyThrowIsItsFailure() {
        start();
        run.stop("far");
        words.complete(() -> {
            throw new IllegalStateException("no words");
        });
        run.advance(0.1);
        assertThat(status()).isEqualTo(AgentPlatform.Status.FAILED);
        assertThat(run.view("far").state()).isEqualTo("no words");
    }

    @Test
    void theEndOfTheRunWaitsForThem() {
        start();
        var _ = words.completeAsync(
                () -> () -> log.add("says"), CompletableFuture.delayedExecutor(50, TimeUnit.MILLISECONDS));
        run.platform.close();
        assertThat(log).containsExactly("stopped", "says", "ended");
    }

    @Test
    void butNotForLong() {
        start();
        run.platform.close();
        assertThat(log).containsExactly("stopped", "ended");
    }
}
