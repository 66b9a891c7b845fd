package rsal.engine;

import java.util.List;
import java.util.concurrent.CompletionStage;
import java.util.function.BiFunction;
import java.util.function.Predicate;
import rsal.engine.report.Answer;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// A command that people give to a run. It is declared once, in [OperatorCommands]: its HTTP route, the page's
/// types, `rsal tell` and the reference follow from that.
///
/// @param name of few words with hyphens: `add-robot`
/// @param description a sentence for people
/// @param answer what it is answered by, unless it is refused
/// @param isSafe whether it may be given while somebody else has control, as it stops robots
/// @param isForAll whether a server carries it out in all its runs
/// @param execution has a run carry it out, on any thread
public record OperatorCommand(
        String name,
        String description,
        List<Parameter<?>> parameters,
        Class<? extends Answer> answer,
        Predicate<Arguments> isSafe,
        boolean isForAll,
        BiFunction<LiveRun, Arguments, CompletionStage<Answer>> execution) {
    public OperatorCommand {
        parameters = List.copyOf(parameters);
    }

    /// @return the result, on the run's thread
    public CompletionStage<Answer> execute(LiveRun run, Arguments arguments) {
        return execution.apply(run, arguments);
    }
}
