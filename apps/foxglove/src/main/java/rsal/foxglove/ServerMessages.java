package rsal.foxglove;

import java.util.List;
import java.util.Map;
import rsal.recording.Origin;

/// What is sent to clients as text, with the names of the protocol.
final class ServerMessages {
    private ServerMessages() {}

    /// Who this is and what it can do; the first message of each connection.
    record ServerInfo(
            String op,
            String name,
            List<String> capabilities,
            List<String> supportedEncodings,
            Map<String, String> metadata,
            String sessionId) {

        /// @param mayPublish whether the client knows the token
        /// @param session which is another one for each run
        static ServerInfo of(Origin origin, boolean mayPublish, String session) {
            var plan = origin.plan();
            return new ServerInfo(
                    "serverInfo",
                    "RSAL: " + plan.scenario().name() + ":" + plan.configuration(),
                    mayPublish ? List.of("time", "clientPublish") : List.of("time"),
                    mayPublish ? List.of("json") : List.of(),
                    Map.of(
                            "scenario", plan.scenario().name(),
                            "configuration", plan.configuration(),
                            "seed", Long.toString(plan.seed()),
                            "program", origin.program()),
                    session);
        }
    }

    /// For people.
    record Status(String op, int level, String message) {
        static Status info(String message) {
            return new Status("status", 0, message);
        }

        static Status warning(String message) {
            return new Status("status", 1, message);
        }

        static Status error(String message) {
            return new Status("status", 2, message);
        }
    }

    /// Channels that there are from now on.
    record Advertise(String op, List<Offer> channels) {
        Advertise(List<Offer> channels) {
            this("advertise", List.copyOf(channels));
        }
    }

    /// @param schema in base 64
    record Offer(int id, String topic, String encoding, String schemaName, String schemaEncoding, String schema) {}

    static String json(Record message) {
        return ClientJson.MAPPER.writeValueAsString(message);
    }
}
