package rsal.jason;

import jason.asSemantics.ActionExec;
import jason.asSyntax.ASSyntax;
import jason.asSyntax.Structure;
import jason.asSyntax.Term;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import rsal.agent.AgentContext;
import rsal.agent.Topic;
import rsal.agent.Topics;
import rsal.behavior.PioneerStack;
import rsal.data.Pose2d;
import rsal.data.Twist2d;
import rsal.device.GoalHandle;
import rsal.device.Gripper;
import rsal.device.Navigator;
import rsal.device.Navigator.Tolerance;
import rsal.robot.Robot;
import rsal.settings.Suggestion;

/// Does what intentions of an agent want done. Each waits until its own is done or has failed, the others go on.
final class ExternalActions {
    private final AgentContext self;
    private final AgentSpeakAgent agent;
    private final Optional<Robot> robot;
    private final Optional<DriveActions> wheels;
    private final List<InProgress> inProgress = new ArrayList<>();

    /// Of two intentions that want the same, each has its own: Jason's deeds are equal when their terms are.
    @SuppressWarnings("ReferenceEquality")
    private record InProgress(ActionExec deed, GoalHandle<?, ?> handle) {
        boolean is(@Nullable ActionExec other) {
            return deed == other;
        }
    }

    ExternalActions(AgentContext self, AgentSpeakAgent agent) {
        this.self = self;
        this.agent = agent;
        this.robot = self.robot();
        this.wheels = robot.map(own -> new DriveActions(self, own));
    }

    /// Begins one. What can't be begun has failed.
    void begin(ActionExec deed) {
        Structure term = deed.getActionTerm();
        try {
            Action action = Action.of(term.getFunctor())
                    .filter(known -> known.takes(term.getArity()))
                    .orElseThrow(() -> new IllegalArgumentException("There is no action (%s/%d). %s"
                            .formatted(
                                    term.getFunctor(),
                                    term.getArity(),
                                    Suggestion.among(term.getFunctor(), Action.names()))));
            begin(deed, action, term.getTerms() == null ? List.of() : term.getTerms());
        } catch (IllegalArgumentException e) {
            fail(deed, "wrong", String.valueOf(e.getMessage()));
        }
    }

    private void begin(ActionExec deed, Action action, List<Term> terms) {
        switch (action) {
            case GOTO -> {
                boolean looks = terms.size() == 3;
                goTo(
                        deed,
                        place(terms, looks ? Terms.number(terms.get(2)) : 0),
                        looks ? Tolerance.DEFAULT : Tolerance.position(Tolerance.DEFAULT.distance()));
            }
            case GOTO_NEAR -> goTo(deed, place(terms, 0), Tolerance.position(Terms.number(terms.get(2))));
            case GRIP -> grip(deed);
            case RELEASE -> release(deed);
            case DRIVE -> done(deed, () -> wheels().drive(twist(terms)));
            case FOLLOW_WALL -> done(deed, () -> wheels().behave(PioneerStack.followLeftWall(robot().model())));
            case WANDER -> done(deed, () -> wheels().behave(PioneerStack.wander(robot().model())));
            case STOP -> done(deed, () -> wheels().stop());
            case PUBLISH -> done(deed, () -> publish(terms));
            case STATE -> done(deed, () -> agent.state(Terms.words(terms)));
            case SHOW -> done(deed, () -> self.show(Terms.words(terms.getFirst()), Terms.words(terms.getLast())));
        }
    }

    private static Twist2d twist(List<Term> terms) {
        var twist = Twist2d.drive(Terms.number(terms.getFirst()), Terms.number(terms.getLast()));
        if (!twist.isFinite()) {
            throw new IllegalArgumentException("'%s' is not a drive.".formatted(twist));
        }
        return twist;
    }

    private static Pose2d place(List<Term> terms, double theta) {
        return new Pose2d(Terms.number(terms.get(0)), Terms.number(terms.get(1)), theta);
    }

    private void goTo(ActionExec deed, Pose2d mapFromGoal, Tolerance tolerance) {
        inProgress.add(new InProgress(deed, wheels().goTo(mapFromGoal, tolerance, result -> {
            switch (result) {
                case Navigator.Result.Reached reached when reached.isSure() -> succeed(deed);
                case Navigator.Result.Reached(var _, String doubt) -> fail(deed, "unsure", doubt);
                case Navigator.Result.Cancelled _ -> fail(deed, "cancelled", "Something else drives the robot.");
                case Navigator.Result.NoPath(String why) -> fail(deed, "no_path", why);
                case Navigator.Result.Stuck stuck -> fail(deed, "stuck", stuck.why());
            }
        })));
    }

    private void grip(ActionExec deed) {
        wait(deed, robot().require(Gripper.class).closeAndLift(), result -> {
            if (result instanceof Gripper.Result.Reached(var state) && !state.holding()) {
                fail(deed, "empty", "The gripper holds nothing.");
            } else {
                end(deed, result);
            }
        });
    }

    private void release(ActionExec deed) {
        wait(deed, robot().require(Gripper.class).lowerAndOpen(), result -> end(deed, result));
    }

    private <R> void wait(ActionExec deed, GoalHandle<?, R> handle, Consumer<R> onEnd) {
        inProgress.add(new InProgress(deed, handle));
        handle.result().thenAccept(result -> self.scheduler().execute(() -> onEnd.accept(result)));
    }

    private void end(ActionExec deed, Gripper.Result result) {
        switch (result) {
            case Gripper.Result.Reached _ -> succeed(deed);
            case Gripper.Result.Cancelled _ -> fail(deed, "cancelled", "Something else moves the gripper.");
            case Gripper.Result.Stuck(var _, String why) -> fail(deed, "stuck", why);
        }
    }

    private void publish(List<Term> terms) {
        String name = Terms.words(terms.getFirst());
        Topic<?> topic = TopicEvents.topic(name)
                .orElseThrow(() -> new IllegalArgumentException("There is no topic '%s'. %s"
                        .formatted(
                                name,
                                Suggestion.among(
                                        name,
                                        Topics.installed().stream()
                                                .map(TopicEvents::name)
                                                .toList()))));
        publish(topic, terms.subList(1, terms.size()));
    }

    private <M> void publish(Topic<M> topic, List<Term> terms) {
        self.publish(topic, Terms.record(topic.type(), terms));
    }

    /// Gives up what no intention waits for any more.
    void check() {
        Map<Integer, ActionExec> pending = agent.reasoner().getTS().getC().getPendingActions();
        for (InProgress one : List.copyOf(inProgress)) {
            if (!one.is(pending.get(one.deed.getIntention().getId()))) {
                inProgress.remove(one);
                one.handle.cancel();
            }
        }
    }

    private void done(ActionExec deed, Runnable action) {
        action.run();
        succeed(deed);
    }

    private void succeed(ActionExec deed) {
        deed.setResult(true);
        end(deed);
    }

    /// @param reason an atom, for plans
    /// @param why for people
    private void fail(ActionExec deed, String reason, String why) {
        deed.setResult(false);
        deed.setFailureReason(ASSyntax.createLiteral("reason", Terms.atom(reason)), why);
        end(deed);
    }

    private void end(ActionExec deed) {
        inProgress.removeIf(one -> one.is(deed));
        agent.reasoner().getTS().getC().addFeedbackAction(deed);
        agent.wake();
    }

    private Robot robot() {
        return robot.orElseThrow(() -> new IllegalArgumentException("This agent has no robot."));
    }

    private DriveActions wheels() {
        return wheels.orElseThrow(() -> new IllegalArgumentException("This agent has no robot."));
    }
}
