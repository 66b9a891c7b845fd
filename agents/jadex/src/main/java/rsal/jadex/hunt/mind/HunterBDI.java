package rsal.jadex.hunt.mind;

import jadex.bdiv3.annotation.Belief;
import jadex.bdiv3.annotation.ExcludeMode;
import jadex.bdiv3.annotation.Goal;
import jadex.bdiv3.annotation.GoalContextCondition;
import jadex.bdiv3.annotation.GoalTargetCondition;
import jadex.bdiv3.annotation.Plan;
import jadex.bdiv3.annotation.PlanBody;
import jadex.bdiv3.annotation.PlanFailed;
import jadex.bdiv3.annotation.Trigger;
import jadex.bdiv3.features.IBDIAgentFeature;
import jadex.bdiv3.runtime.IGoal;
import jadex.bridge.ComponentTerminatedException;
import jadex.bridge.IInternalAccess;
import jadex.bridge.component.IArgumentsResultsFeature;
import jadex.bridge.service.annotation.OnStart;
import jadex.commons.future.Future;
import jadex.commons.future.IFuture;
import jadex.micro.annotation.Agent;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;

/// The mind of a hunter: two goals, of which its beliefs say which is active. Jadex finds it by the end of its name.
@Agent(type = "bdi")
public class HunterBDI implements Thinking {
    /// Where Jadex finds it. Jadex must be the first to load this class, as it rewrites it: nobody else may use more of
    /// it than constants, which the compiler copies.
    public static final String FILE = "rsal/jadex/hunt/mind/HunterBDI.class";

    public static final String BODY = "body"; // its argument

    @Agent
    @SuppressWarnings("NullAway.Init") // Jadex fills it in
    protected IInternalAccess agent;

    @Belief
    protected boolean known; // where the prey is

    @Belief
    protected boolean caught;

    @SuppressWarnings("NullAway.Init") // when it starts
    private Hunting hunting;

    @OnStart
    protected void begin() {
        var arguments = agent.getFeature(IArgumentsResultsFeature.class).getArguments();
        hunting = (Hunting) Objects.requireNonNull(arguments.get(BODY));
        agent.getFeature(IBDIAgentFeature.class).dispatchTopLevelGoal(new Find());
        agent.getFeature(IBDIAgentFeature.class).dispatchTopLevelGoal(new Catch());
        hunting.begun(this);
    }

    @Override
    public void knowsPrey(boolean now) {
        think(() -> known = now);
    }

    @Override
    public void preyIsCaught() {
        think(() -> caught = true);
    }

    /// In a step of its own, as its beliefs, goals and plans are its thread's alone. Dropped when it has ended; what
    /// else goes wrong is told.
    private void think(Runnable thought) {
        agent.getExternalAccess()
                .scheduleStep(component -> {
                    thought.run();
                    publish();
                    return IFuture.DONE;
                })
                .catchEx(fault -> {
                    if (!(fault instanceof ComponentTerminatedException)) {
                        hunting.failed(fault);
                    }
                });
    }

    /// To know where the prey is. As soon as it is known Jadex suspends it, and its plan.
    @Goal(retry = true, excludemode = ExcludeMode.Never)
    public class Find {
        @GoalContextCondition(beliefs = "known")
        protected boolean isWanted() {
            return !known;
        }

        @GoalTargetCondition(beliefs = "caught")
        protected boolean isOver() {
            return caught;
        }
    }

    /// That the prey has been caught, while it is known where it is.
    @Goal(retry = true, excludemode = ExcludeMode.Never)
    public class Catch {
        @GoalContextCondition(beliefs = "known")
        protected boolean isWanted() {
            return known;
        }

        @GoalTargetCondition(beliefs = "caught")
        protected boolean isReached() {
            return caught;
        }
    }

    @Plan(trigger = @Trigger(goals = Find.class))
    public class LookOut {
        @PlanBody
        protected IFuture<Void> act() {
            hunting.lookOut();
            return new Future<>(); // until it is known
        }

        @PlanFailed // by a fault; Jadex would try it again without end
        protected void failed(Exception fault) {
            hunting.failed(fault);
        }
    }

    /// Jadex tries it again and again, until the goal is reached or suspended.
    @Plan(trigger = @Trigger(goals = Catch.class))
    public class Approach {
        @PlanBody
        protected IFuture<Void> act() {
            Future<Void> over = new Future<>();
            hunting.approach(() -> think(() -> over.setResultIfUndone(null)));
            return over;
        }

        @PlanFailed // by a fault; Jadex would try it again without end
        protected void failed(Exception fault) {
            hunting.failed(fault);
        }
    }

    private void publish() {
        List<Hunting.Desire> desires = new ArrayList<>();
        for (IGoal goal : agent.getFeature(IBDIAgentFeature.class).getGoals()) {
            boolean finds = goal.getId().contains("Find");
            desires.add(new Hunting.Desire(
                    finds ? "find" : "catch", goal.getLifecycleState().name(), finds ? "look out" : "approach"));
        }
        hunting.wants(desires);
    }
}
