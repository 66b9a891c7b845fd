package rsal.data;

import java.util.List;

/// The state of a robot's bumpers (Player `bumper`).
///
/// @param baseFromBumpers the middle of each, its x axis pointing outwards
/// @param pressed as many as bumpers
public record BumperState(List<Pose2d> baseFromBumpers, List<Boolean> pressed) {
    public BumperState {
        baseFromBumpers = List.copyOf(baseFromBumpers);
        pressed = List.copyOf(pressed);
        if (baseFromBumpers.size() != pressed.size()) {
            throw new IllegalArgumentException(
                    "Each of %d bumpers is pressed or not, not %d.".formatted(baseFromBumpers.size(), pressed.size()));
        }
    }

    public boolean any() {
        return pressed.contains(true);
    }
}
