package rsal.cli.page;

import java.io.IOException;
import java.net.InetAddress;
import java.security.GeneralSecurityException;
import java.security.KeyStore;
import java.security.cert.X509Certificate;
import java.util.Collection;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import rsal.server.access.Listening;

/// By which hosts other machines reach a page that listens at all addresses of this machine.
final class ReachableHosts {
    private static final int DNS = 2; // RFC 5280, GeneralName
    private static final int IP = 7;
    private static final List<String> ONLY_HERE = List.of("localhost", "127.0.0.1", "0:0:0:0:0:0:0:1");

    private ReachableHosts() {}

    /// The address that is listened at. Of all addresses, the names in the certificate, for which browsers do not warn;
    /// if it has none, the name of this machine.
    ///
    /// @return at least one, as written in an address
    static List<String> of(Listening listening) {
        InetAddress address = listening.address().getAddress();
        if (!address.isAnyLocalAddress()) {
            return List.of(written(listening.address().getHostString()));
        }
        List<String> named = names(listening.identity()).stream()
                .filter(name -> !ONLY_HERE.contains(name))
                .map(ReachableHosts::written)
                .toList();
        return named.isEmpty() ? List.of(ownName()) : named;
    }

    private static String written(String host) {
        return host.contains(":") ? "[" + host + "]" : host;
    }

    private static List<String> names(KeyStore identity) {
        try {
            return Collections.list(identity.aliases()).stream()
                    .flatMap(alias -> certificate(identity, alias).stream())
                    .flatMap(ReachableHosts::names)
                    .distinct()
                    .toList();
        } catch (GeneralSecurityException _) {
            return List.of();
        }
    }

    private static Optional<X509Certificate> certificate(KeyStore identity, String alias) {
        try {
            return identity.getCertificate(alias) instanceof X509Certificate certificate
                    ? Optional.of(certificate)
                    : Optional.empty();
        } catch (GeneralSecurityException _) {
            return Optional.empty();
        }
    }

    private static Stream<String> names(X509Certificate certificate) {
        try {
            return Optional.ofNullable(certificate.getSubjectAlternativeNames()).stream()
                    .flatMap(Collection::stream)
                    .filter(name ->
                            name.getFirst().equals(DNS) || name.getFirst().equals(IP))
                    .map(name -> String.valueOf(name.get(1)))
                    .filter(name -> !name.startsWith("*"));
        } catch (GeneralSecurityException _) {
            return Stream.empty();
        }
    }

    private static String ownName() {
        try {
            return InetAddress.getLocalHost().getHostName();
        } catch (IOException _) {
            return "localhost";
        }
    }
}
