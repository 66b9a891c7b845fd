package rsal.navigation.recovery;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import rsal.data.Angles;
import rsal.data.Point2d;
import rsal.data.Twist2d;
import rsal.navigation.avoid.Controller.Target;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// Turns around, drives back a bit the way that the robot sees then, and turns to the path again. For robots that
/// don't see behind, where somebody may stand. Where it has no room to turn it fails.
public final class TurnAroundRecoveryType implements RecoveryType {
    private static final Parameter<Double> MAX_DURATION =
            Parameter.number("maxDuration", 12, 1, 60, "s", "maximum time of the turn");

    @Override
    public String key() {
        return "turnAround";
    }

    @Override
    public String description() {
        return "Turns around, drives back, and turns to the path again, if the robot does not see behind.";
    }

    @Override
    public List<Parameter<?>> parameters() {
        return List.of(BackUpRecoveryType.AFTER, MAX_DURATION);
    }

    @Override
    public Recovery create(Arguments arguments, Driven driven) {
        return new TurnAround(driven, arguments.seconds(BackUpRecoveryType.AFTER), arguments.seconds(MAX_DURATION));
    }

    private static final class TurnAround implements Recovery {
        private static final double TURNED = Math.toRadians(45); // missing; so it sees where it drives

        private final Driven driven;
        private final Duration after;
        private final Duration longestTurn;
        private final TurnToPath turn;
        private double back; // heading that leads back where it came from [rad], in the map
        private Instant until = Instant.MIN;
        private Stage stage = Stage.TURN_AROUND;

        private enum Stage {
            TURN_AROUND,
            DRIVE_BACK,
            TURN_TO_PATH,
            NO_ROOM
        }

        TurnAround(Driven driven, Duration after, Duration longestTurn) {
            this.driven = driven;
            this.after = after;
            this.longestTurn = longestTurn;
            this.turn = new TurnToPath(driven);
        }

        @Override
        public boolean isDue(Situation situation) {
            return situation.isStuck(after) && !situation.stalled() && !situation.seesBehind() && !situation.atGoal();
        }

        @Override
        public void begin(Situation situation) {
            back = situation.mapFromBase().theta() + Math.PI;
            begin(Stage.TURN_AROUND, longestTurn, situation);
        }

        private void begin(Stage next, Duration atMost, Situation situation) {
            stage = next;
            until = situation.now().plus(driven.partOf(atMost));
        }

        @Override
        public State state(Situation situation) {
            boolean late = situation.now().isAfter(until);
            return switch (stage) {
                case TURN_AROUND -> late || situation.atGoal() ? State.DONE : State.RUNNING;
                case DRIVE_BACK -> situation.atGoal() ? State.DONE : State.RUNNING;
                case TURN_TO_PATH -> turn.state(situation);
                case NO_ROOM -> State.FAILED;
            };
        }

        @Override
        public Twist2d command(Situation situation) {
            if (stage == Stage.DRIVE_BACK && situation.now().isAfter(until)) {
                stage = Stage.TURN_TO_PATH;
                turn.begin(situation);
            }
            return switch (stage) {
                case TURN_AROUND -> turnAround(situation);
                case DRIVE_BACK -> driveBack(situation);
                case TURN_TO_PATH -> turn.command(situation);
                case NO_ROOM -> Twist2d.STOP;
            };
        }

        private Twist2d turnAround(Situation situation) {
            double angle = Angles.difference(situation.mapFromBase().theta(), back);
            Twist2d command = driven.controller().turn(situation.obstacles(), angle, situation.motion());
            if (Math.abs(angle) < TURNED) {
                begin(Stage.DRIVE_BACK, driven.time(), situation);
            } else if (command.equals(Twist2d.STOP)) {
                stage = Stage.NO_ROOM;
            }
            return command;
        }

        private Twist2d driveBack(Situation situation) {
            double angle = Angles.difference(situation.mapFromBase().theta(), back);
            Target away = Target.at(new Point2d(Math.cos(angle), Math.sin(angle)), false);
            Twist2d fast = driven.controller().drive(situation.obstacles(), away, situation.motion());
            double share = Math.min(1, driven.speed() / Math.max(driven.speed(), fast.vx()));
            return driven.controller()
                    .guarded(situation.obstacles(), Twist2d.drive(share * fast.vx(), fast.omega()), situation.motion());
        }
    }
}
