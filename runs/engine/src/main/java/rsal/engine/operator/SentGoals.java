package rsal.engine.operator;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import rsal.data.Pose2d;
import rsal.engine.report.SentGoal;
import rsal.engine.report.SentGoal.Status;

/// To which places people sent robots. A robot has one goal at a time: the next one cancels it. All calls on the
/// run's thread, but for [#all].
public final class SentGoals {
    private static final int MOST = 200; // older ones that ended are forgotten

    private final Supplier<Duration> time;
    private volatile List<SentGoal> all = List.of();
    private int count;

    /// @param time since the run's start
    public SentGoals(Supplier<Duration> time) {
        this.time = time;
    }

    /// Any thread may ask. Oldest first.
    public List<SentGoal> all() {
        return all;
    }

    /// @return its id
    int send(String robot, Pose2d mapFromGoal) {
        cancel(robot, "Another goal came.");
        var goals = new ArrayList<>(all);
        goals.add(new SentGoal(++count, robot, mapFromGoal, Status.EXECUTING, time.get(), Optional.empty(), ""));
        while (goals.size() > MOST && !goals.getFirst().isInProgress()) {
            goals.removeFirst();
        }
        all = List.copyOf(goals);
        return count;
    }

    /// Nothing happens where it has ended before.
    void end(int id, Status how, String why) {
        all = all.stream()
                .map(goal -> goal.id() == id && goal.isInProgress() ? goal.ended(how, time.get(), why) : goal)
                .toList();
    }

    /// The one under way of a robot, if there is any.
    void cancel(String robot, String why) {
        ofRobot(robot, Status.CANCELED, why);
    }

    /// The same, for a reason that nobody wanted.
    void abort(String robot, String why) {
        ofRobot(robot, Status.ABORTED, why);
    }

    /// The run is over.
    public void close() {
        all.forEach(goal -> end(goal.id(), Status.CANCELED, "The run ended."));
    }

    private void ofRobot(String robot, Status how, String why) {
        all.stream()
                .filter(goal -> goal.robot().equals(robot) && goal.isInProgress())
                .forEach(goal -> end(goal.id(), how, why));
    }
}
