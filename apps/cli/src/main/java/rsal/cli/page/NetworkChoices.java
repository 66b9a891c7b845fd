package rsal.cli.page;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.UnknownHostException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.TypeConversionException;
import rsal.cli.terminal.Destination;
import rsal.cli.terminal.Unreachable;
import rsal.server.access.Listening;
import rsal.server.access.Role;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;

/// Whether other machines reach the page, as options: only by TLS, and only with a token.
final class NetworkChoices {
    private static final int PORT = 8443;

    /// RFC 6750, section 2.1. So it can stand in a header and in a cookie.
    private static final Pattern TOKEN = Pattern.compile("[A-Za-z0-9._~+/=-]{%d,}".formatted(Listening.SHORTEST_TOKEN));

    @Option(
            names = "--listen",
            paramLabel = "ADDRESS[:PORT]",
            description = "Let other machines reach the page at this address of this machine (0.0.0.0: all"
                    + " addresses), by HTTPS and with a token only. Needs --certificate and --key. Default port: "
                    + PORT
                    + ".")
    private @Nullable String listen;

    @Option(
            names = "--certificate",
            paramLabel = "FILE.pem",
            description = "The certificate for --listen, with its chain. 'rsal certificate' makes one.")
    private @Nullable Path certificate;

    @Option(names = "--key", paramLabel = "FILE.pem", description = "The private key of the certificate.")
    private @Nullable Path key;

    @Option(
            names = "--token-file",
            paramLabel = "FILE",
            description =
                    "File of tokens for --listen: one role (watch, operate or admin) and its token per line. Default:"
                            + " the file that RSAL_TOKEN_FILE names, or only the token in the printed address.")
    private @Nullable Path tokens;

    @Option(
            names = "--origin",
            paramLabel = "URL",
            description =
                    "The address of a reverse proxy, such as https://robots.example.org, whose pages may connect to"
                            + " --listen.")
    private List<String> origins = List.of();

    Optional<Listening> listening(CommandLine line) {
        if (listen == null) {
            if (certificate != null || key != null || tokens != null || !origins.isEmpty()) {
                throw new ParameterException(line, "--certificate, --key, --token-file and --origin need --listen.");
            }
            return Optional.empty();
        }
        if (certificate == null || key == null) {
            throw new ParameterException(
                    line, "--listen needs --certificate FILE.pem and --key FILE.pem. 'rsal certificate' makes them.");
        }
        return Optional.of(
                new Listening(address(line, listen), PemFiles.identity(certificate, key), tokens(line), origins(line)));
    }

    private static InetSocketAddress address(CommandLine line, String typed) {
        int colon = typed.lastIndexOf(':');
        boolean hasPort = colon >= 0 && (typed.indexOf(':') == colon || typed.charAt(colon - 1) == ']');
        String host = (hasPort ? typed.substring(0, colon) : typed).replaceAll("[\\[\\]]", "");
        int port = hasPort ? port(line, typed.substring(colon + 1)) : PORT;
        if (host.isEmpty() || port == 0) {
            throw new ParameterException(
                    line,
                    "'%s' is not an address to listen at, like 192.168.1.5 or 0.0.0.0:%d.".formatted(typed, PORT));
        }
        try {
            return new InetSocketAddress(InetAddress.getByName(host), port);
        } catch (UnknownHostException e) {
            throw new Unreachable("There is no address '%s' to listen at.".formatted(host));
        }
    }

    private static int port(CommandLine line, String typed) {
        try {
            return new PageChoices.Port().convert(typed);
        } catch (TypeConversionException e) {
            throw new ParameterException(line, String.valueOf(e.getMessage()), e);
        }
    }

    private List<String> origins(CommandLine line) {
        for (String origin : origins) {
            if (!origin.matches("https?://[^/]+")) {
                throw new ParameterException(
                        line,
                        "'%s' is not an origin, like https://robots.example.org, without a path.".formatted(origin));
            }
        }
        return origins;
    }

    private Map<String, Role> tokens(CommandLine line) {
        Path file = tokens != null
                ? tokens
                : Optional.ofNullable(System.getenv("RSAL_TOKEN_FILE"))
                        .filter(name -> !name.isEmpty())
                        .map(Destination::path)
                        .orElse(null);
        if (file == null) {
            return Map.of();
        }
        Map<String, Role> read = read(file);
        if (SecretFile.isReadByOthers(file)) {
            line.getErr()
                    .println("rsal: Others on this machine can read the tokens in '%1$s': chmod 600 %1$s"
                            .formatted(file));
        }
        return read;
    }

    /// Lines of a role and a token. Empty ones, and those that begin with `#`, say nothing.
    static Map<String, Role> read(Path file) {
        var tokens = new LinkedHashMap<String, Role>();
        List<String> lines;
        try {
            lines = Files.readAllLines(file);
        } catch (NoSuchFileException _) {
            throw new InvalidSettings(Location.of(file.toString()), "There is no file '%s'.".formatted(file), "");
        } catch (IOException e) {
            throw new InvalidSettings(Location.of(file.toString()), "This file can't be read: %s.".formatted(e), "");
        }
        for (int i = 0; i < lines.size(); i++) {
            String line = lines.get(i).strip();
            if (!line.isEmpty() && !line.startsWith("#")) {
                String[] words = line.split("\\s+", -1);
                if (words.length != 2
                        || !TOKEN.matcher(words[1]).matches()
                        || tokens.put(words[1], role(words[0], file, i + 1)) != null) {
                    throw new InvalidSettings(
                            new Location(file.toString(), i + 1, 1),
                            "A line must have a role, and a token of at least %d characters that no other line has: letters, digits and -._~+/=."
                                    .formatted(Listening.SHORTEST_TOKEN), // never the token itself
                            "Write, for instance: watch %s".formatted("x".repeat(Listening.SHORTEST_TOKEN)));
                }
            }
        }
        return tokens;
    }

    private static Role role(String word, Path file, int line) {
        for (Role role : Role.values()) {
            if (role.name().toLowerCase(Locale.ROOT).equals(word)) {
                return role;
            }
        }
        throw new InvalidSettings(
                new Location(file.toString(), line, 1),
                "There is no role '%s'.".formatted(word),
                "Roles: watch, operate, admin.");
    }
}
