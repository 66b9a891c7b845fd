package rsal.navigation.recovery;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import rsal.data.Angles;
import rsal.data.Twist2d;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// Turns in place by an angle to see what is around, as Nav2's spin does. It fails where there is no room to turn.
public final class SpinRecoveryType implements RecoveryType {
    private static final Parameter<Double> ANGLE =
            Parameter.number("angle", 90, -720, 720, "deg", "angle of the turn; left is positive");
    private static final Parameter<Double> MAX_DURATION =
            Parameter.number("maxDuration", 20, 0.5, 600, "s", "maximum time of the turn");

    @Override
    public String key() {
        return "spin";
    }

    @Override
    public String description() {
        return "Turns in place by an angle, so that the robot sees its surroundings.";
    }

    @Override
    public List<Parameter<?>> parameters() {
        return List.of(WaitRecoveryType.AFTER, WaitRecoveryType.TIMES, ANGLE, MAX_DURATION);
    }

    @Override
    public Recovery create(Arguments arguments, Driven driven) {
        return new Spin(
                driven,
                new Attempts(arguments.seconds(WaitRecoveryType.AFTER), arguments.get(WaitRecoveryType.TIMES)),
                arguments.radians(ANGLE),
                arguments.seconds(MAX_DURATION));
    }

    private static final class Spin implements Recovery {
        private static final double TURNED = Math.toRadians(3); // missing; less is done

        private final Driven driven;
        private final Attempts attempts;
        private final double angle;
        private final Duration longest;
        private double missing; // rad; signed
        private double last; // heading at the last step, by odometry [rad]
        private Instant until = Instant.MIN;
        private boolean hasRoom;

        Spin(Driven driven, Attempts attempts, double angle, Duration longest) {
            this.driven = driven;
            this.attempts = attempts;
            this.angle = angle;
            this.longest = longest;
        }

        @Override
        public boolean isDue(Situation situation) {
            return !situation.stalled() && attempts.isDue(situation);
        }

        @Override
        public void begin(Situation situation) {
            attempts.begin();
            missing = angle;
            last = situation.motion().odomFromBase().theta();
            until = situation.now().plus(longest);
            hasRoom = true;
        }

        @Override
        public State state(Situation situation) {
            if (!hasRoom) {
                return State.FAILED;
            }
            boolean isOver = Math.abs(missing) < TURNED || situation.now().isAfter(until);
            return isOver ? State.DONE : State.RUNNING;
        }

        @Override
        public Twist2d command(Situation situation) {
            double heading = situation.motion().odomFromBase().theta();
            missing -= Angles.difference(last, heading);
            last = heading;
            double next = Math.clamp(missing, -Math.PI / 2, Math.PI / 2); // so it knows which way round
            Twist2d command = driven.controller().turn(situation.obstacles(), next, situation.motion());
            hasRoom = !command.equals(Twist2d.STOP);
            return command;
        }
    }
}
