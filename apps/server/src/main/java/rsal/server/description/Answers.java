package rsal.server.description;

import io.javalin.http.Context;
import java.util.Map;
import java.util.concurrent.CompletionStage;
import java.util.function.Function;
import rsal.engine.report.Answer;
import rsal.server.http.Grids;
import rsal.server.http.Http;
import rsal.server.message.Messages.Added;
import rsal.server.message.Messages.Armed;
import rsal.server.message.Messages.Sent;
import rsal.server.message.Messages.Stopped;
import rsal.server.message.Refusal;

/// Answers requests with what a run answers, when that is there.
public final class Answers {
    private Answers() {}

    public static void whenDone(Context request, CompletionStage<Answer> stage) {
        whenDone(request, stage, reported -> ReadingWords.of(reported.readings()));
    }

    /// @param reported how readings are answered
    public static void whenDone(
            Context request, CompletionStage<Answer> stage, Function<Answer.Read, Record> reported) {
        // not on the run's thread, which has better to do than to write
        request.future(() -> stage.thenAcceptAsync(
                        answer -> {
                            switch (answer) {
                                case Answer.Done _ -> Http.answer(request, Map.of());
                                case Answer.Added(String name) -> Http.answer(request, new Added(name));
                                case Answer.Sent(int goal) -> Http.answer(request, new Sent(goal));
                                case Answer.Stopped(int robots) -> Http.answer(request, new Stopped(robots));
                                case Answer.Armed(int on, var off) -> Http.answer(request, new Armed(on, off));
                                case Answer.Able(var abilities) -> Http.answer(request, RobotAbilities.of(abilities));
                                case Answer.Read read -> Http.answer(request, reported.apply(read));
                                case Answer.Heard(var all) -> Http.answer(request, Descriptions.communication(all));
                                case Answer.Counted(var topics) -> Http.answer(request, Descriptions.topics(topics));
                                case Answer.Bridged _ -> throw new IllegalStateException("No page asks for a bridge.");
                                case Answer.Repeated(var all) ->
                                    Http.answer(request, Descriptions.routine(all, Http.parameter(request, "topic")));
                                case Answer.Linked linked -> Http.answer(request, Descriptions.links(linked));
                                case Answer.Costed(var grid) ->
                                    grid.ifPresentOrElse(
                                            costs -> Grids.answer(request, costs), () -> request.status(204));
                                case Answer.Minded _ ->
                                    throw new IllegalStateException("No page asks for minds alone.");
                                case Answer.Seen(var agent) -> Http.answer(request, Descriptions.inside(agent));
                                case Answer.Refused(String why) -> throw new Refusal(409, why);
                            }
                        },
                        Thread::startVirtualThread)
                .toCompletableFuture());
    }
}
