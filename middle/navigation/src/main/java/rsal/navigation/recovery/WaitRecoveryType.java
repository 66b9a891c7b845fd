package rsal.navigation.recovery;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import rsal.data.Twist2d;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// Stands still for a while, so that others can pass, as Nav2's wait does.
public final class WaitRecoveryType implements RecoveryType {
    static final Parameter<Double> AFTER =
            Parameter.number("after", 3, 0.5, 600, "s", "time without progress after which it begins");
    static final Parameter<Integer> TIMES =
            Parameter.integer("times", 1, 1, 1000, "", "number of tries until there is progress");
    private static final Parameter<Double> DURATION =
            Parameter.number("duration", 5, 0.1, 600, "s", "time for which the robot stands");

    @Override
    public String key() {
        return "wait";
    }

    @Override
    public String description() {
        return "Stands still for a while, so that others can pass.";
    }

    @Override
    public List<Parameter<?>> parameters() {
        return List.of(AFTER, TIMES, DURATION);
    }

    @Override
    public Recovery create(Arguments arguments, Driven driven) {
        var attempts = new Attempts(arguments.seconds(AFTER), arguments.get(TIMES));
        Duration time = arguments.seconds(DURATION);
        return new Recovery() {
            private Instant until = Instant.MIN;

            @Override
            public boolean isDue(Situation situation) {
                return attempts.isDue(situation);
            }

            @Override
            public void begin(Situation situation) {
                attempts.begin();
                until = situation.now().plus(time);
            }

            @Override
            public State state(Situation situation) {
                return situation.now().isBefore(until) ? State.RUNNING : State.DONE;
            }

            @Override
            public Twist2d command(Situation situation) {
                return Twist2d.STOP;
            }
        };
    }
}
