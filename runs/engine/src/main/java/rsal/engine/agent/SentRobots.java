package rsal.engine.agent;

import java.util.HashMap;
import java.util.Map;
import java.util.function.Consumer;
import rsal.agent.message.GoalReached;
import rsal.data.Pose2d;
import rsal.engine.event.EventLog;

/// Where the operator has sent robots, until each has ended its way. All calls on the run's thread.
final class SentRobots {
    private final EventLog eventLog;
    private final Map<String, Goal> goals = new HashMap<>(); // by robot

    /// @param again whether the robot was on its way there when it was sent; an end of that way is none of this one
    private record Goal(Pose2d mapFromGoal, boolean again, Consumer<GoalReached> onEnd) {
        Goal withoutAgain() {
            return new Goal(mapFromGoal, false, onEnd);
        }
    }

    SentRobots(EventLog eventLog) {
        this.eventLog = eventLog;
    }

    /// @param onEnd is called with how that ended, unless the robot is sent elsewhere before
    void send(String robot, Pose2d mapFromGoal, Consumer<GoalReached> onEnd) {
        Goal before = goals.get(robot);
        boolean again = before != null && before.mapFromGoal().equals(mapFromGoal);
        goals.put(robot, new Goal(mapFromGoal, again, onEnd));
    }

    void forget(String robot) {
        goals.remove(robot);
    }

    /// The operator hears when a robot did not get where it was sent last. A goal that is cancelled may have given
    /// way to the same place again; of one that is silent more may be heard.
    void ended(GoalReached end) {
        Goal goal = goals.get(end.robot());
        if (goal == null || !end.mapFromGoal().equals(goal.mapFromGoal())) {
            return;
        }
        if (end.cancelled() && goal.again()) {
            goals.put(end.robot(), goal.withoutAgain());
            return;
        }
        if (!end.silent()) {
            goals.remove(end.robot());
            goal.onEnd().accept(end);
        }
        if (!end.reached() && !end.cancelled()) {
            eventLog.event(
                    "unreached",
                    end.robot(),
                    "can't get to %s: %s".formatted(end.mapFromGoal().rounded(), end.outcome()));
        }
    }
}
