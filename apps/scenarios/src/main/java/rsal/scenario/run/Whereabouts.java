package rsal.scenario.run;

import java.util.Optional;
import rsal.data.Pose2d;
import rsal.data.Stamped;
import rsal.device.Localizer;

/// Where robots are, as far as anybody knows. All calls on the run's thread.
final class Whereabouts {
    private final RobotSystems systems;
    private final Team team;

    Whereabouts(RobotSystems systems, Team team) {
        this.systems = systems;
        this.team = team;
    }

    /// Where a simulated robot really is, in the map frame.
    Optional<Pose2d> truth(String robot) {
        return systems.truth(robot);
    }

    /// Where a robot really is, or where a real one believes to be, in the map frame.
    Optional<Pose2d> mapFromBase(String robot) {
        return systems.simulation(robot).isPresent()
                ? systems.truth(robot)
                : belief(robot).map(Stamped::value);
    }

    /// Where a robot believes to be, in the map frame.
    Optional<Stamped<Pose2d>> belief(String robot) {
        return team.robot(robot)
                .flatMap(team::localizer)
                .flatMap(Localizer::latest)
                .filter(estimate -> estimate.frame().equals(RobotRecord.WORLD))
                .map(estimate -> new Stamped<>(
                        estimate.time(), estimate.frame(), estimate.value().mapFromBase()));
    }
}
