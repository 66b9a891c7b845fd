package rsal.navigation.recovery;

import rsal.data.Point2d;
import rsal.data.Twist2d;
import rsal.navigation.avoid.Controller.Target;
import rsal.settings.Arguments;

/// Drives about where there is room, and turns where there is none: a localizer learns nothing while the robot
/// stands. It goes on until the robot knows where it is.
public final class LookAroundRecoveryType implements RecoveryType {
    @Override
    public String key() {
        return "lookAround";
    }

    @Override
    public String description() {
        return "Drives straight on if there is room, otherwise turns, so that the localizer gets new readings.";
    }

    @Override
    public Recovery create(Arguments arguments, Driven driven) {
        return new Recovery() {
            private final Target onward = Target.at(new Point2d(driven.lookahead(), 0), false);

            @Override
            public boolean isDue(Situation situation) {
                return true;
            }

            @Override
            public void begin(Situation situation) {}

            @Override
            public State state(Situation situation) {
                return State.RUNNING;
            }

            @Override
            public Twist2d command(Situation situation) {
                Twist2d ahead = driven.controller().drive(situation.obstacles(), onward, situation.motion());
                return ahead.equals(Twist2d.STOP)
                        ? driven.controller().turn(situation.obstacles(), Math.PI / 2, situation.motion())
                        : ahead;
            }
        };
    }
}
