package rsal.rtps;

import java.net.InetSocketAddress;
import java.util.List;
import rsal.rtps.wire.GuidPrefix;
import rsal.rtps.wire.Locator;

/// A participant, and where it receives.
record Addressee(GuidPrefix prefix, List<InetSocketAddress> addresses) {
    /// Of several addresses of one machine, the one from which it was heard; all of them where that is none.
    static Addressee of(GuidPrefix prefix, List<Locator> locators, InetSocketAddress heardFrom) {
        List<InetSocketAddress> all = locators.stream()
                .flatMap(each -> each.unicast().stream())
                .distinct()
                .toList();
        List<InetSocketAddress> heard = all.stream()
                .filter(each -> each.getAddress().equals(heardFrom.getAddress()))
                .toList();
        return new Addressee(prefix, heard.isEmpty() ? all : heard);
    }
}
