package rsal.server.http;

import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.Optional;
import java.util.SequencedMap;
import java.util.function.LongSupplier;
import org.jspecify.annotations.Nullable;
import rsal.server.message.Refusal;

/// Who alone may change anything on a server for now, of those who have the token. Nobody has it at first, and then all
/// may. It is held for some seconds and kept again and again meanwhile, so that a page that is closed, or asleep,
/// locks nobody out. Everybody who has the token may take it over: it keeps people out of each other's way, and nobody
/// from the robots.
///
/// May be used from any thread.
public final class Lease {
    /// For how long it is held when it isn't kept.
    static final Duration TERM = Duration.ofSeconds(10);

    private static final int LONGEST = 64; // characters of an id, and of a name
    private static final int MOST_NAMES = 64; // that are known

    private final LongSupplier clock;
    private final SequencedMap<String, String> names = new LinkedHashMap<>(); // by id, of those who had it last
    private @Nullable Holder holder;

    /// @param operator known to this operator, and to nobody else
    /// @param name for people
    /// @param until on the clock [ns]
    private record Holder(String operator, String name, long until) {}

    /// @param clock in real time [ns]
    Lease(LongSupplier clock) {
        this.clock = clock;
    }

    /// Takes it, or keeps it for another term.
    ///
    /// @param over whether also from somebody else
    /// @throws Refusal when somebody else has it, or nobody could be called like that
    public synchronized void take(String operator, String name, boolean over) {
        checkIsName(operator);
        checkIsName(name);
        if (!over) {
            check(operator);
        }
        hold(operator, name.strip());
        names.putLast(operator, name.strip());
        if (names.size() > MOST_NAMES) {
            names.pollFirstEntry();
        }
    }

    /// Keeps it for another term. Nothing happens when somebody else has it, or nobody: what is said again and
    /// again may come after it was given back.
    public synchronized void keep(String operator) {
        heldBy(operator).ifPresent(now -> hold(operator, now.name()));
    }

    private void hold(String operator, String name) {
        holder = new Holder(operator, name, clock.getAsLong() + TERM.toNanos());
    }

    private static void checkIsName(String name) {
        if (name.isBlank() || name.length() > LONGEST || name.chars().anyMatch(Character::isISOControl)) {
            throw new Refusal(
                    400,
                    "An operator's name has 1 to %d characters; this is none: '%s'."
                            .formatted(LONGEST, Refusal.shortened(name)));
        }
    }

    /// Gives it back; nothing happens when it is another's.
    public synchronized void giveBack(String operator) {
        if (isHeldBy(operator)) {
            holder = null;
        }
    }

    /// @param operator empty of one who says none, as a program
    /// @throws Refusal when somebody else has it
    public void check(String operator) {
        heldBack(operator).ifPresent(why -> {
            throw new Refusal(409, why);
        });
    }

    /// Why somebody may not change anything now, as somebody else has it; empty when they may.
    ///
    /// @param operator empty of one who says none, as a program
    public synchronized Optional<String> heldBack(String operator) {
        return current()
                .filter(now -> !now.operator().equals(operator))
                .map(now ->
                        "%s has control of this run. Take it over (in the page, or by --take-control of a command), or wait until it is given back; an emergency stop is always taken."
                                .formatted(now.name()));
    }

    /// Name of who has it; empty when nobody has.
    public synchronized Optional<String> holder() {
        return current().map(Holder::name);
    }

    /// What somebody is called who has it or had it; of others, that they have it not, when somebody else does.
    ///
    /// @param operator empty of one who says none, as a program
    /// @return empty when nobody knows
    public synchronized String name(String operator) {
        String unknown = current().isPresent() ? "somebody without control" : "";
        return names.getOrDefault(operator, unknown);
    }

    public synchronized boolean isHeldBy(String operator) {
        return heldBy(operator).isPresent();
    }

    private Optional<Holder> heldBy(String operator) {
        return current().filter(now -> now.operator().equals(operator));
    }

    private Optional<Holder> current() {
        return Optional.ofNullable(holder).filter(now -> now.until() - clock.getAsLong() > 0);
    }
}
