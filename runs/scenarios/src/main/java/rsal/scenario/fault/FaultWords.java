package rsal.scenario.fault;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Locale;
import java.util.Set;
import java.util.TreeSet;
import rsal.fault.Fault;
import rsal.scenario.fault.PlannedFault.Mishap;
import rsal.scenario.fault.PlannedFault.OfMessages;
import rsal.scenario.fault.PlannedFault.OfRobot;
import rsal.scenario.fault.PlannedFault.Target;

/// Says for people what goes wrong, so that it can stand after `no longer`, too.
final class FaultWords {
    private FaultWords() {}

    static String of(Target target) {
        return switch (target) {
            case OfRobot broken -> of(broken.fault());
            case OfMessages messages -> of(messages);
        };
    }

    private static String of(Fault fault) {
        return switch (fault) {
            case Fault.Dead _ -> "dead";
            case Fault.Frozen _ -> "frozen";
            case Fault.Biased(double range, double angle) -> "biased" + by(range, angle);
            case Fault.Noisy(double range, double angle) -> "noisy" + by(range, angle);
            case Fault.MotorDead(double power) ->
                power == 0 ? "without motors" : String.format(Locale.ROOT, "at %.0f %% of its power", 100 * power);
            case Fault.Slip(double way, double turn, double drift) ->
                String.format(
                        Locale.ROOT,
                        "slipping: %+.0f %% of the distance, %+.0f %% of the turn, %+.1f°/m",
                        100 * way,
                        100 * turn,
                        Math.toDegrees(drift));
            case Fault.Gone(boolean stays) -> stays ? "gone and in the way" : "gone";
        };
    }

    private static String by(double range, double angle) {
        var errors = new ArrayList<String>();
        if (range != 0) {
            errors.add(String.format(Locale.ROOT, "%.2f m", range));
        }
        if (angle != 0) {
            errors.add(String.format(Locale.ROOT, "%.1f°", Math.toDegrees(angle)));
        }
        return " by " + String.join(" and ", errors);
    }

    private static String of(OfMessages messages) {
        String what = switch (messages.mishap()) {
            case Mishap.Lost _ -> "lost";
            case Mishap.Late(Span delay) -> "late by " + of(delay);
            case Mishap.Doubled(Span delay) -> delay.most().isZero() ? "doubled" : "doubled, " + of(delay) + " later";
        };
        var which = new ArrayList<String>();
        if (messages.share() < 1) {
            which.add(String.format(Locale.ROOT, "%.0f %%", 100 * messages.share()));
        }
        if (!messages.topics().isEmpty()) {
            which.add("about " + String.join(", ", messages.topics()));
        }
        messages.from().ifPresent(names -> which.add("from " + sorted(names)));
        messages.to().ifPresent(names -> which.add("to " + sorted(names)));
        return which.isEmpty() ? what : what + " (" + String.join(", ", which) + ")";
    }

    private static String sorted(Set<String> names) {
        return String.join(", ", new TreeSet<>(names));
    }

    private static String of(Span span) {
        return span.least().equals(span.most())
                ? of(span.most())
                : String.format(Locale.ROOT, "%.2f to %s", seconds(span.least()), of(span.most()));
    }

    private static String of(Duration time) {
        return String.format(Locale.ROOT, "%.2f s", seconds(time));
    }

    private static double seconds(Duration time) {
        return time.toNanos() / 1e9;
    }
}
