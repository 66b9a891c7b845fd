package rsal.server.description;

import rsal.robot.RobotModel;
import rsal.server.message.Messages.Abilities;

/// What a robot can be told to do, for the page.
final class RobotAbilities {
    private RobotAbilities() {}

    static Abilities of(rsal.engine.report.Abilities robot) {
        RobotModel.Drive drive = robot.drive();
        return new Abilities(
                drive.forward().speed().most(),
                -drive.forward().speed().least(),
                drive.sideways().speed().most(),
                drive.turn().speed().most(),
                robot.behaviors(),
                robot.noBehavior(),
                robot.noGoal());
    }
}
