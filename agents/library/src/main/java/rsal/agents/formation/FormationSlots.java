package rsal.agents.formation;

import java.time.Duration;
import java.util.Collections;
import java.util.Locale;
import java.util.NavigableMap;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.Collectors;
import rsal.agent.MessageContent;
import rsal.agent.Topic;
import rsal.agent.message.MessageCheck;
import rsal.data.Pose2d;

/// Where the robots of a formation should be. This is repeated as the formation moves, so that one lost message
/// has no effect.
///
/// @param shape for people: `wedge`, `column`
/// @param formed whether all robots have been at their places since these were last assigned
/// @param ahead time from the message until all should be at their places
/// @param slots the place of each robot, by the robot's id
public record FormationSlots(String shape, boolean formed, Duration ahead, NavigableMap<String, Slot> slots)
        implements MessageContent {
    public static final Topic<FormationSlots> TOPIC = new Topic<>("ranks", FormationSlots.class);

    public FormationSlots {
        MessageCheck.given("shape", shape);
        if (!ahead.isPositive()) {
            throw new IllegalArgumentException(
                    "Robots aim at where they should be later, not after %s.".formatted(ahead));
        }
        slots = Collections.unmodifiableNavigableMap(new TreeMap<>(slots));
        slots.forEach((_, slot) -> MessageCheck.given("slot", slot));
    }

    /// The place of one robot.
    ///
    /// @param mapFromSlot where it should be now
    /// @param mapFromAim where it should be later
    public record Slot(Pose2d mapFromSlot, Pose2d mapFromAim) {
        public Slot {
            MessageCheck.somewhere("slot", mapFromSlot);
            MessageCheck.somewhere("aim", mapFromAim);
        }
    }

    /// Where a slot is some time after this was said.
    public static Pose2d at(Slot slot, Duration since, Duration ahead) {
        double share = Math.min(1, (double) since.toNanos() / ahead.toNanos());
        return slot.mapFromSlot.towards(slot.mapFromAim, share);
    }

    @Override
    public String toString() {
        return (formed ? shape : "into " + shape)
                + slots.entrySet().stream()
                        .map(entry -> String.format(
                                Locale.ROOT,
                                "; %s at (%.2f, %.2f)",
                                entry.getKey(),
                                entry.getValue().mapFromSlot.x(),
                                entry.getValue().mapFromSlot.y()))
                        .collect(Collectors.joining());
    }

    /// It is said again and again.
    @Override
    public Optional<String> eventKind() {
        return Optional.empty();
    }
}
