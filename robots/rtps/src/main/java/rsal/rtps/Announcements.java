package rsal.rtps;

import java.net.InetSocketAddress;
import java.util.Collection;
import java.util.HashSet;
import java.util.Set;
import java.util.stream.Collectors;
import rsal.rtps.discovery.ParticipantData;

/// When a participant announces itself, and to whom: to the multicast group, and to addresses where somebody may
/// listen. Announcements of n participants to each other are n² datagrams. So those that are known, and are heard in
/// the group themselves, seldom get one of their own; and each of many participants announces itself less often.
final class Announcements {
    private static final long SECOND = 1_000_000_000; // ns
    private static final int FIRST = 5;
    private static final long BETWEEN_FIRST = SECOND / 10;
    private static final long BETWEEN = 3 * SECOND / 2; // of few: who was cut off is found within 2 s
    private static final int FEW = 20; // participants; of more, each announces itself less often
    private static final int OF_LEASE = 6; // announcements within a lease at least, of which some may be lost
    private static final int TO_KNOWN = 3; // of these, to those that may not hear the multicast group

    private final long lease; // ns
    private final Set<InetSocketAddress> here; // where it hears what it sends itself
    private int count;
    private long due; // ns
    private long dueToKnown; // ns

    /// @param now [ns]
    Announcements(ParticipantData self, long now) {
        lease = self.lease();
        here = self.metatraffic().stream()
                .flatMap(each -> each.unicast().stream())
                .collect(Collectors.toUnmodifiableSet());
        due = now;
        dueToKnown = now;
    }

    /// When the next one is due [ns].
    long due() {
        return due;
    }

    /// Sends one if it is due.
    ///
    /// @param announced what the participant says of itself
    /// @param now [ns]
    void announce(DatagramOutbox outbox, byte[] announced, Collection<RemoteParticipant> others, long now) {
        if (now < due) {
            return;
        }
        boolean isToKnown = now >= dueToKnown;
        DiscoveryMessages.announce(outbox.toAll(), announced);
        outbox.announce(isToKnown ? here : known(others, now));
        count++;
        long toKnown = Math.max(lease / TO_KNOWN, BETWEEN_FIRST);
        long longest = Math.max(lease / OF_LEASE, Math.min(BETWEEN, toKnown));
        long usual = count < FIRST ? BETWEEN_FIRST : BETWEEN;
        dueToKnown = isToKnown ? now + toKnown : dueToKnown;
        due = Math.min(now + Math.min(usual * (1 + others.size() / FEW), longest), dueToKnown);
    }

    /// Where those hear that are known, and whose own announcements came by the multicast group lately: most likely,
    /// they hear ours there, too.
    private Set<InetSocketAddress> known(Collection<RemoteParticipant> others, long now) {
        var known = new HashSet<InetSocketAddress>(here);
        for (RemoteParticipant other : others) {
            if (other.isInGroup(now)) {
                known.addAll(other.metatraffic.addresses());
            }
        }
        return known;
    }
}
