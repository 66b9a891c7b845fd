package rsal.engine;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.Test;
import rsal.engine.report.Answer;

class RequestsTest {
    private static final Answer LATE = new Answer.Refused("The run has ended.");

    private final CompletableFuture<Answer> tooLate = new CompletableFuture<>();
    private final Requests requests = new Requests(tooLate);

    @Test
    void areAnsweredWhenTheRunComesToThem() {
        var answer = requests.ask(Answer.Done::new).toCompletableFuture();
        assertThat(answer).isNotDone();
        requests.take();
        assertThat(answer).isCompletedWithValue(new Answer.Done());
    }

    @Test
    void leaveNothingBehindThatGrowsAsLongAsTheRunGoesOn() {
        for (int asked = 0; asked < 1000; asked++) {
            requests.ask(Answer.Done::new);
            requests.take();
        }
        assertThat(tooLate.getNumberOfDependents()).isLessThan(5);
    }

    @Test
    void areRefusedWhenTheRunEnds() {
        var waiting = requests.ask(Answer.Done::new).toCompletableFuture();
        tooLate.complete(LATE);
        assertThat(waiting).isCompletedWithValue(LATE);
        assertThat(requests.ask(() -> {
                    throw new AssertionError("asked after the end");
                }))
                .isCompletedWithValue(LATE);
        requests.take();
    }
}
