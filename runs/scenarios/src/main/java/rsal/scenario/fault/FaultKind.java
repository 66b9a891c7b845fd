package rsal.scenario.fault;

import java.util.List;
import java.util.Optional;
import rsal.fault.Fault;
import rsal.scenario.fault.PlannedFault.Mishap;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// What a scenario can let go wrong, declared once for the reader and the schema.
public enum FaultKind {
    DEAD("dead", Of.SENSORS, "Sensors show nothing any more, and are stale."),
    FROZEN("frozen", Of.SENSORS, "Sensors show what they showed last, as if it were new."),
    BIASED("biased", Of.SENSORS, "Sensors measure with a constant error."),
    NOISY("noisy", Of.SENSORS, "Sensors measure with Gaussian errors besides those that they have anyway."),
    MOTOR_DEAD("motorDead", Of.BASES, "Motors are weaker than commanded."),
    SLIP("slip", Of.BASES, "Odometry counts more than robots drive (slip)."),
    GONE("gone", Of.ROBOTS, "Robots are gone, their devices are lost, and their agents neither hear nor are heard."),
    LOST("lost", Of.MESSAGES, "Messages are lost."),
    LATE("late", Of.MESSAGES, "Messages come late."),
    DOUBLED("doubled", Of.MESSAGES, "Messages come twice.");

    /// What can have it.
    public enum Of {
        SENSORS,
        BASES,
        ROBOTS,
        MESSAGES;

        /// By which settings it is told which ones.
        public List<String> keys() {
            return switch (this) {
                case SENSORS -> List.of("robots", "devices");
                case BASES, ROBOTS -> List.of("robots");
                case MESSAGES -> List.of("topics", "from", "to");
            };
        }
    }

    public static final Parameter<Double> SHARE = Parameter.number(
            "share", 1, 0, 1, "", "How likely it is, for each message and each agent that should hear it.");

    private static final String RANGE = "range";
    private static final String ANGLE = "angle";
    private static final Parameter<Double> RANGE_BIAS =
            Parameter.number(RANGE, 0, -100, 100, "m", "Offset of all ranges; of a pose: ahead.");
    private static final Parameter<Double> ANGLE_BIAS =
            Parameter.number(ANGLE, 0, -180, 180, "deg", "Offset to the left.");
    private static final Parameter<Double> RANGE_NOISE =
            Parameter.number(RANGE, 0, 0, 100, "m", "Standard deviation of ranges; of a pose: ahead and aside.");
    private static final Parameter<Double> ANGLE_NOISE =
            Parameter.number(ANGLE, 0, 0, 180, "deg", "Standard deviation of angles.");
    private static final Parameter<Double> POWER =
            Parameter.number("power", 0, 0, 1, "", "Part of the speeds wanted that is left.");
    private static final Parameter<Double> WAY =
            Parameter.number("way", 0.2, -0.9, 10, "", "Share of the distance that odometry counts in addition.");
    private static final Parameter<Double> TURN =
            Parameter.number("turn", 0, -0.9, 10, "", "Part of the turn that is counted besides.");
    private static final Parameter<Double> DRIFT =
            Parameter.number("drift", 0, -360, 360, "deg/m", "Turn to the left counted for each meter forward.");
    private static final Parameter<Boolean> STAYS =
            Parameter.flag("stays", false, "Whether they stand in the way of others where they were.");

    private final String word;
    private final Of of;
    private final String description;

    FaultKind(String word, Of of, String description) {
        this.word = word;
        this.of = of;
        this.description = description;
    }

    public String word() {
        return word;
    }

    public Of of() {
        return of;
    }

    public String description() {
        return description;
    }

    public List<Parameter<?>> parameters() {
        return switch (this) {
            case DEAD, FROZEN -> List.of();
            case BIASED -> List.of(RANGE_BIAS, ANGLE_BIAS);
            case NOISY -> List.of(RANGE_NOISE, ANGLE_NOISE);
            case MOTOR_DEAD -> List.of(POWER);
            case SLIP -> List.of(WAY, TURN, DRIFT);
            case GONE -> List.of(STAYS);
            case LOST, LATE, DOUBLED -> List.of(SHARE);
        };
    }

    /// How much later than it should a message comes, if it does; what it is unless somebody says otherwise [s].
    public Optional<Double> delay() {
        return switch (this) {
            case LATE -> Optional.of(1.0);
            case DOUBLED -> Optional.of(0.0);
            default -> Optional.empty();
        };
    }

    /// @throws IllegalStateException when it is none of robots
    public Fault fault(Arguments arguments) {
        return switch (this) {
            case DEAD -> new Fault.Dead();
            case FROZEN -> new Fault.Frozen();
            case BIASED -> new Fault.Biased(arguments.get(RANGE_BIAS), arguments.radians(ANGLE_BIAS));
            case NOISY -> new Fault.Noisy(arguments.get(RANGE_NOISE), arguments.radians(ANGLE_NOISE));
            case MOTOR_DEAD -> new Fault.MotorDead(arguments.get(POWER));
            case SLIP -> new Fault.Slip(arguments.get(WAY), arguments.get(TURN), arguments.radians(DRIFT));
            case GONE -> new Fault.Gone(arguments.get(STAYS));
            case LOST, LATE, DOUBLED ->
                throw new IllegalStateException("'%s' is not a fault of robots.".formatted(word));
        };
    }

    /// @throws IllegalStateException when it is none of messages
    public Mishap mishap(Span delay) {
        return switch (this) {
            case LOST -> new Mishap.Lost();
            case LATE -> new Mishap.Late(delay);
            case DOUBLED -> new Mishap.Doubled(delay);
            default -> throw new IllegalStateException("'%s' is not a fault of messages.".formatted(word));
        };
    }
}
