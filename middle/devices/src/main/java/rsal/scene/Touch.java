package rsal.scene;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/// What becomes of a robot that drives into something.
public enum Touch {
    /// It stops where it touches, wheels and all, until it drives elsewhere: as in Stage, and as most robots do.
    STALL,

    /// It slides along what it touches, without friction, as far as its way leads past it; its wheels slip, so that
    /// odometry counts more than it moves. Where nothing is left of its way it stalls.
    SLIDE;

    /// What files call it.
    public String word() {
        return name().toLowerCase(Locale.ROOT);
    }

    /// What files call them all.
    public static List<String> words() {
        return Arrays.stream(values()).map(Touch::word).toList();
    }

    /// The one of a word; empty when there is none.
    public static Optional<Touch> of(Object word) {
        return Arrays.stream(values())
                .filter(touch -> touch.word().equals(word))
                .findFirst();
    }
}
