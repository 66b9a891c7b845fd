package rsal.player.message;

/// Interface `power`: a battery.
public final class Power {
    public static final int STATE = 1;

    public static final int CHARGING = 1;

    /// [State#valid]
    public static final int VOLTS = 1;

    public static final int WATTS = 2;
    public static final int JOULES = 4;
    public static final int PERCENT = 8;
    public static final int IS_CHARGING = 16;

    private Power() {}

    /// @param valid which of the others mean something, as bits
    /// @param charging 1 it is charged, −1 it gives, 0 neither
    public record State(int valid, float volts, float percent, float joules, float watts, int charging) {}

    public record Charging(int takes, int gives) {}
}
