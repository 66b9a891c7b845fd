package rsal.agents.pursuit;

import java.util.Optional;
import rsal.agent.AgentContext;
import rsal.agent.message.PoseReport;
import rsal.agents.driving.Roaming;
import rsal.agents.parts.PoseReporter;
import rsal.robot.Robot;
import rsal.settings.Arguments;

/// One prey's part of a hunt: follows the wall on its left, or wanders, until it is caught. One that knows hunters by
/// their markers
/// tells nobody where it is.
final class Prey {
    private final AgentContext self;
    private final Roaming roaming;
    private final PoseReporter reporter;
    private final CaptureDetector surrender;
    private final Optional<MarkerSight> sight;

    Prey(AgentContext self, Robot robot, Arguments arguments) {
        this.self = self;
        this.roaming = Escape.wanders(arguments) ? Roaming.anywhere(self, robot) : Roaming.alongWalls(self, robot);
        String hunter = arguments.get(Escape.HUNTER);
        boolean byMarkers = MarkerSight.byMarkers(arguments);
        this.surrender = CaptureDetector.of(self, robot, arguments, roaming::end);
        this.reporter = new PoseReporter(self, robot, arguments, _ -> lookAround(), !byMarkers);
        this.sight = byMarkers
                ? Optional.of(new MarkerSight(self, robot, reporter::mapFromBase, hunter, seen -> hear(seen.report())))
                : Optional.empty();
    }

    void begin() {
        sight.ifPresentOrElse(
                MarkerSight::begin, () -> self.subscribe(PoseReport.TOPIC, message -> hear(message.content())));
        roaming.begin();
        reporter.begin();
    }

    private void hear(PoseReport report) {
        surrender.note(report, reporter.mapFromBase());
    }

    private void lookAround() {
        surrender.lookAround(reporter.mapFromBase());
    }
}
