package rsal.jadex.hunt;

import jadex.bridge.IInternalAccess;
import jadex.bridge.service.types.cms.CreationInfo;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.concurrent.atomic.AtomicBoolean;
import org.jspecify.annotations.Nullable;
import rsal.agent.AgentContext;
import rsal.agent.bdi.Mind.GoalState;
import rsal.agent.bdi.Mind.GoalView;
import rsal.agent.bdi.Mind.View;
import rsal.agent.message.PoseReport;
import rsal.agents.pursuit.Caught;
import rsal.data.Pose2d;
import rsal.device.GoalHandle;
import rsal.device.Localizer;
import rsal.device.Navigator;
import rsal.device.Navigator.Tolerance;
import rsal.jadex.hunt.mind.HunterBDI;
import rsal.jadex.hunt.mind.Hunting;
import rsal.jadex.hunt.mind.Thinking;
import rsal.robot.Robot;
import rsal.settings.Arguments;

/// A hunter's senses and deeds. Its mind is a Jadex agent within the one that lends this one its lane. Neither
/// waits for the other: the mind is told in steps of its own what to believe, and what it wants done is done on this
/// one's lane.
final class JadexHunt implements Hunting {
    private static final Duration MEMORY = Duration.ofSeconds(10); // of a prey that says nothing any more

    private final AgentContext self;
    private final Robot robot;
    private final Localizer localizer;
    private final Navigator navigator;
    private final String prey; // role or id
    private final Tolerance tolerance;
    private final Duration updateInterval;
    private final Duration period;
    private final AtomicBoolean ends = new AtomicBoolean();
    private @Nullable Thinking mind;
    private @Nullable PoseReport newest; // of the prey
    private Instant heard = Instant.MIN; // when it was
    private @Nullable GoalHandle<?, ?> drive;
    private boolean isCaught;
    private List<Desire> desires = List.of();

    JadexHunt(AgentContext self, Arguments arguments) {
        this.self = self;
        this.robot = self.robot().orElseThrow();
        this.localizer = robot.require(Localizer.class);
        this.navigator = robot.require(Navigator.class);
        this.prey = arguments.get(JadexHunter.PREY);
        this.tolerance = Tolerance.position(arguments.get(JadexHunter.CATCH_DISTANCE) / 2);
        this.updateInterval = arguments.seconds(JadexHunter.UPDATE_INTERVAL);
        this.period = arguments.seconds(JadexHunter.PERIOD);
    }

    /// @param body in which the mind is to live
    void begin(IInternalAccess body) {
        self.reveal(View.class, this::view);
        self.atEnd(this::halt);
        self.subscribe(PoseReport.TOPIC, PoseReport.ofRobots(prey), message -> hear(message.content()));
        self.subscribe(Caught.TOPIC, message -> hear(message.content()));
        self.scheduler().every(period, this::beat);
        body.createComponent(new CreationInfo().setFilename(HunterBDI.FILE).addArgument(HunterBDI.BODY, this))
                .catchEx(e -> end("Jadex could not make the mind of '%s'.".formatted(self.name()), e));
    }

    private void beat() {
        localizer.latest().ifPresent(here -> publish(here.value().mapFromBase()));
        if (newest != null && heard.plus(MEMORY).isBefore(self.scheduler().instant())) {
            newest = null;
        }
        if (mind != null) {
            mind.knowsPrey(newest != null);
        }
    }

    private void publish(Pose2d mapFromBase) {
        self.publish(PoseReport.TOPIC, new PoseReport(robot.id(), robot.role(), mapFromBase));
    }

    private void hear(PoseReport report) {
        newest = report;
        heard = self.scheduler().instant();
    }

    private void hear(Caught caught) {
        if (newest != null && caught.prey().equals(newest.robot())) {
            isCaught = true;
            halt();
            self.state("has caught " + caught.prey());
            if (mind != null) {
                mind.preyIsCaught();
            }
        }
    }

    @Override
    public void begun(Thinking thinking) {
        self.scheduler().execute(() -> mind = thinking);
    }

    @Override
    public void lookOut() {
        self.scheduler().execute(() -> {
            halt();
            self.state("looking out for prey");
        });
    }

    @Override
    public void approach(Runnable over) {
        self.scheduler().execute(() -> {
            PoseReport goal = newest;
            if (goal != null && !isCaught) {
                self.state("hunting " + goal.robot());
                drive = navigator.goTo(goal.mapFromBase(), tolerance);
            }
            self.scheduler().after(updateInterval, over);
        });
    }

    /// Ends the agent, as what it throws itself does.
    @Override
    public void failed(Throwable fault) {
        end("The mind of '%s' failed: %s".formatted(self.name(), fault), fault);
    }

    /// Once, as a plan that fails is tried again and again.
    private void end(String why, Throwable cause) {
        if (ends.getAndSet(true)) {
            return;
        }
        self.scheduler().execute(() -> {
            throw new IllegalStateException(why, cause);
        });
    }

    @Override
    public void wants(List<Desire> now) {
        self.scheduler().execute(() -> desires = now);
    }

    private void halt() {
        if (drive != null) {
            drive.cancel();
            drive = null;
        }
    }

    private View view() {
        return new View(
                Map.of("known", "" + (newest != null), "caught", "" + isCaught),
                desires.stream().map(JadexHunt::view).toList());
    }

    private static GoalView view(Desire desire) {
        GoalState state = switch (desire.state()) {
            case "ACTIVE" -> GoalState.PURSUED;
            case "NEW", "ADOPTED", "OPTION" -> GoalState.WAITING;
            case "SUSPENDED" -> GoalState.NOT_WANTED;
            default -> GoalState.REACHED; // it is dropped when its target holds
        };
        List<String> steps =
                state == GoalState.PURSUED ? List.of("%s: %s".formatted(desire.name(), desire.plan())) : List.of();
        return new GoalView(desire.name(), state, 0, List.of(desire.plan()), steps, "");
    }
}
