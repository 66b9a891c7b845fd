package rsal.player;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import rsal.player.message.Session;

/// Where a robot is.
///
/// @param servers that have its devices; one at least
/// @param index which robot of these servers it is, from 0
record ServerAddress(List<Server> servers, int index) {
    private static final Pattern ENTRY =
            Pattern.compile("(?:player://)?([^\\s:/+]{1,253}):(\\d{1,5})(?::(\\d{1,4}))?/?");

    ServerAddress {
        servers = List.copyOf(servers);
    }

    /// @param port 1–65535
    record Server(String host, int port) {}

    /// Reads where robots are, one after the other, divided by commas or spaces: `HOST:PORT`, or with
    /// `player://` before; `HOST:PORT:INDEX` when it is not the first robot there. Servers of one robot are
    /// joined by `+`; the last one's index counts.
    ///
    /// @throws IllegalArgumentException with a sentence when it is something else
    static List<ServerAddress> read(String text) {
        var berths = new ArrayList<ServerAddress>();
        for (String entry : text.split("[\\s,]+", -1)) {
            if (!entry.isEmpty()) {
                berths.add(one(entry));
            }
        }
        return berths;
    }

    private static ServerAddress one(String entry) {
        var servers = new ArrayList<Server>();
        int index = 0;
        for (String part : entry.split("\\+", -1)) {
            Matcher parts = ENTRY.matcher(part);
            int port = parts.matches() ? Integer.parseInt(parts.group(2)) : 0;
            if (port < 1 || port > Session.LAST_PORT) {
                throw new IllegalArgumentException(
                        "'%s' is not a server. Write HOST:PORT, as localhost:6665; its second robot is HOST:PORT:1, and servers of one robot are joined by +."
                                .formatted(shortened(part)));
            }
            servers.add(new Server(parts.group(1), port));
            index = parts.group(3) == null ? index : Integer.parseInt(parts.group(3));
        }
        return new ServerAddress(servers, index);
    }

    private static String shortened(String text) {
        return text.length() > 60 ? text.substring(0, 60) + "…" : text;
    }

    /// As many as there are to be, on the ports from one on.
    static List<ServerAddress> from(String host, int port, int index, int robots) {
        var berths = new ServerAddress[robots];
        Arrays.setAll(berths, robot -> new ServerAddress(List.of(new Server(host, port + robot)), index));
        return List.of(berths);
    }

    /// For people.
    @Override
    public String toString() {
        String all = String.join(
                "+",
                servers.stream()
                        .map(server -> server.host() + ":" + server.port())
                        .toList());
        return index == 0 ? all : all + ":" + index;
    }
}
