package rsal.agent.message;

import java.util.Optional;
import rsal.agent.MessageContent;
import rsal.agent.Topic;
import rsal.data.Pose2d;

/// A robot's drive to a goal has ended.
///
/// @param robot its id
/// @param mapFromGoal the goal, in the map frame
/// @param ending `reached`; `unsure` when the robot believes to be there, but is not localized; `cancelled`,
/// `no path` or `stuck`; `silent` if the robot does not answer, as another agent reports
/// @param why why the goal was not reached, for people; empty when it was reached or cancelled
public record GoalReached(String robot, Pose2d mapFromGoal, String ending, String why) implements MessageContent {
    public static final Topic<GoalReached> TOPIC = new Topic<>("goal-reached", GoalReached.class);

    public GoalReached {
        MessageCheck.given("robot", robot);
        MessageCheck.somewhere("goal", mapFromGoal);
        MessageCheck.given("ending", ending);
        MessageCheck.given("why", why);
    }

    public boolean reached() {
        return ending.equals("reached");
    }

    /// Whether it stands there as far as it knows, localized or not.
    public boolean there() {
        return reached() || ending.equals("unsure");
    }

    public boolean cancelled() {
        return ending.equals("cancelled");
    }

    /// Another says it: nothing is heard of the robot. What becomes of its drive may be heard yet.
    public boolean silent() {
        return ending.equals("silent");
    }

    @Override
    public String words() {
        return "%s at %s: %s".formatted(robot, mapFromGoal.rounded(), outcome());
    }

    /// `stuck. A box is ahead.`
    public String outcome() {
        return why.isEmpty() ? ending : ending + ". " + why;
    }

    @Override
    public Optional<String> eventKind() {
        return Optional.of("goal");
    }
}
