package rsal.engine;

import java.time.Duration;
import java.util.List;
import java.util.concurrent.CompletionStage;
import rsal.engine.report.Answer;

/// What people ask a run about its robots and agents. Looking changes nothing in the run. Any thread may call;
/// a stage completes on the run's thread. What nobody knows, and what is asked after the end of a run that does
/// not [remember][LiveRun#remember] it, is answered by [Answer.Refused].
public final class RunInspector {
    private final RunLoop loop;

    RunInspector(RunLoop loop) {
        this.loop = loop;
    }

    /// What a robot can be told to do, as [Answer.Able].
    public CompletionStage<Answer> abilities(String robot) {
        return loop.ask(run -> run.robotCommands().abilities(robot));
    }

    /// What a robot's devices have told last, as [Answer.Read]; nothing of one that is gone, or from where it
    /// was before it was placed elsewhere.
    public CompletionStage<Answer> readings(String robot) {
        return loop.askOrRecall(run -> run.readings(robot, loop.elapsed()), last -> last.readings(robot));
    }

    /// What places cost a robot's navigator, as [Answer.Costed].
    public CompletionStage<Answer> costs(String robot) {
        return loop.ask(run -> run.costs(robot));
    }

    /// Who heard what so far, as [Answer.Heard]; afterwards the result tells, too.
    public CompletionStage<Answer> communication() {
        return loop.askOrRecall(run -> new Answer.Heard(run.hearings()), FinalState::communication);
    }

    /// How much was said so far, and what became of it, as [Answer.Counted]; afterwards the result tells, too.
    public CompletionStage<Answer> topics() {
        return loop.askOrRecall(run -> new Answer.Counted(run.topics()), FinalState::topics);
    }

    /// What agents say so often that it is no event each time, as where they are: see [Answer.Repeated].
    ///
    /// @param topic of which all is told; of the others, that they are there
    public CompletionStage<Answer> routine(String topic) {
        return loop.askOrRecall(
                run -> new Answer.Repeated(run.routine().of(topic)),
                last -> new Answer.Repeated(last.routine().of(topic)));
    }

    /// The same of what was said by a time: not long before it, or as far back as is needed to know of each
    /// agent what it had said last. Runs that [remember][LiveRun#remember] know of more.
    ///
    /// @param until since the run's start
    /// @param shortly how long before that, where that is enough
    public CompletionStage<Answer> routine(String topic, Duration until, Duration shortly) {
        return loop.askOrRecall(
                run -> new Answer.Repeated(run.routine().of(topic, until, shortly)),
                last -> new Answer.Repeated(last.routine().of(topic, until, shortly)));
    }

    /// What an agent believes, wants and says now, as [Answer.Seen]. Looking changes nothing in the run, but
    /// costs it a little for the seconds after: what changes in the agent meanwhile is noted at each step.
    public CompletionStage<Answer> inside(String agent) {
        return loop.askOrRecall(run -> run.inside(agent, loop.operatorTime()), last -> last.agent(agent));
    }

    /// What some agents believe and want now, as [Answer.Minded]; nothing of those that don't run, or don't
    /// show it.
    public CompletionStage<Answer> minds(List<String> agents) {
        return loop.ask(run -> new Answer.Minded(loop.elapsed(), run.minds(agents)));
    }

    /// Which robots' agents hear each other now, as [Answer.Linked]. Looking changes nothing in the run, but
    /// costs it a little for the seconds after: what is heard meanwhile is noted. So it is while snapshots are
    /// made of a run of at most 50 robots.
    ///
    /// @param chosen the robot whose links are told when there are more than 50 robots; empty, or unknown, for
    ///         none
    public CompletionStage<Answer> links(String chosen) {
        long now = loop.operatorTime();
        return loop.ask(run -> run.links(chosen, now));
    }
}
