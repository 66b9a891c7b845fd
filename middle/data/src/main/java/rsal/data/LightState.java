package rsal.data;

import java.time.Duration;

/// State of a light (Player `blinkenlight`).
///
/// @param color color of its light
/// @param signal the commanded signal: on, off, or blink
/// @param lit whether it shines at the time of the reading
public record LightState(Rgb color, Signal signal, boolean lit) {
    /// What a light may be told: to shine for a share of each period, from its begin.
    ///
    /// @param period from one flash to the next
    /// @param dutyCycle share of the period in which it shines, 0–1
    public record Signal(Duration period, double dutyCycle) {
        public static final Signal OFF = new Signal(Duration.ofSeconds(1), 0);
        public static final Signal ON = new Signal(Duration.ofSeconds(1), 1);

        public Signal {
            if (!period.isPositive() || !(dutyCycle >= 0 && dutyCycle <= 1)) {
                throw new IllegalArgumentException(
                        "A light's period '%s' must be positive and its duty cycle '%s' from 0 to 1."
                                .formatted(period, dutyCycle));
            }
        }

        /// Whether it shines so long after it was told.
        public boolean litAfter(Duration time) {
            long into = Math.floorMod(time.toNanos(), period.toNanos());
            return into < dutyCycle * period.toNanos();
        }
    }
}
