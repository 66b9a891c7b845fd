package rsal.agents.pursuit;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;
import rsal.agent.AgentContext;
import rsal.agent.message.PoseReport;
import rsal.agents.driving.NavigationClient;
import rsal.agents.exploration.Viewpoints;
import rsal.behavior.Pilot;
import rsal.data.Pose2d;
import rsal.device.Device;
import rsal.device.FiducialFinder;
import rsal.device.PlaceFinder;
import rsal.robot.Robot;
import rsal.settings.Arguments;

/// How a hunter learns where prey are. Prey that tell where they are it hears. Those that don't it sees, as
/// other hunters do who tell it; and while there is none to hunt, it goes where it may see some ([Viewpoints]).
final class PreySearch {
    private final AgentContext self;
    private final String hunters;
    private final String prey;
    private final Consumer<PoseReport> onNews;
    private final Optional<MarkerSight> sight; // empty: prey tell
    private final Optional<Viewpoints> lookouts;

    /// @param driver the robot's, which is not used while this is paused
    /// @param onNews told where robots are, hunters and prey
    /// @throws IllegalStateException when the robot lacks what it takes to look
    PreySearch(
            AgentContext self,
            Robot robot,
            NavigationClient driver,
            Supplier<Optional<Pose2d>> mapFromBase,
            Arguments arguments,
            Consumer<PoseReport> onNews) {
        this.self = self;
        this.hunters = robot.role();
        this.prey = arguments.get(Follow.PREY);
        this.onNews = onNews;
        this.sight = MarkerSight.byMarkers(arguments)
                ? Optional.of(new MarkerSight(self, robot, mapFromBase, prey, seen -> onNews.accept(seen.report())))
                : Optional.empty();
        int places = arguments.get(Viewpoints.COUNT);
        this.lookouts = sight.map(eyes -> new Viewpoints(self, robot, driver, mapFromBase, places, eyes::fieldOfView));
    }

    /// Types of devices that it takes to look: to see prey, and to find places to look from and turn there.
    static List<Class<? extends Device>> needs(Arguments arguments) {
        return MarkerSight.byMarkers(arguments)
                ? List.of(FiducialFinder.class, Pilot.class, PlaceFinder.class)
                : List.of();
    }

    void begin() {
        self.subscribe(PoseReport.TOPIC, message -> hear(message.content()));
        if (sight.isPresent()) {
            self.subscribe(Sighting.TOPIC, message -> hear(message.content()));
            sight.get().begin();
        }
        lookouts.ifPresent(Viewpoints::begin);
    }

    private void hear(PoseReport report) {
        if (sight.isEmpty() || report.isFrom(hunters)) {
            onNews.accept(report);
        }
    }

    private void hear(Sighting sighting) {
        if (sighting.isOf(prey)) {
            onNews.accept(sighting.report());
        }
    }

    /// Lets others drive the robot.
    void pause() {
        lookouts.ifPresent(Viewpoints::pause);
    }

    /// Drives the robot again, if it does at all.
    void goOn() {
        lookouts.ifPresent(Viewpoints::goOn);
    }

    /// How far the robot sees prey [m]; 0 where prey report their poses, and before its first look.
    double sight() {
        return sight.map(MarkerSight::range).orElse(0.0);
    }

    /// Whether it drives the robot when nobody else does.
    boolean roams() {
        return lookouts.isPresent();
    }
}
