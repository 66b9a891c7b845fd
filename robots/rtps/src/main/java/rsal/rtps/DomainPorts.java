package rsal.rtps;

import java.util.OptionalInt;

/// Which UDP ports participants of a domain use (DDSI-RTPS 2.5, 9.6.2.3).
public final class DomainPorts {
    /// Whose ports exist.
    public static final int LAST_DOMAIN = 232;

    /// Participants of one machine and domain that have ports of their own.
    static final int PARTICIPANTS = 120;

    private static final int BASE = 7_400;
    private static final int OF_DOMAIN = 250;
    private static final int OF_PARTICIPANT = 2;
    private static final int UNICAST = 10;

    private DomainPorts() {}

    /// Where all participants hear of new ones.
    public static int multicast(int domain) {
        return BASE + OF_DOMAIN * domain;
    }

    /// The other way round; empty for a port where no domain's participants hear of new ones.
    public static OptionalInt domain(int multicastPort) {
        int domain = (multicastPort - BASE) / OF_DOMAIN;
        boolean isOne = domain >= 0 && domain <= LAST_DOMAIN && multicast(domain) == multicastPort;
        return isOne ? OptionalInt.of(domain) : OptionalInt.empty();
    }

    /// Where one participant receives.
    ///
    /// @param participant of this machine, from 0 on
    public static int unicast(int domain, int participant) {
        return BASE + OF_DOMAIN * domain + UNICAST + OF_PARTICIPANT * participant;
    }
}
