package rsal.ros2.rosbridge;

import java.io.IOException;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.Supplier;
import rsal.ros2.cdr.RosMessage;
import rsal.ros2.link.RosLink.Served;
import rsal.ros2.link.RosLink.Server;
import rsal.ros2.link.RosLink.ServiceClient;
import rsal.ros2.type.InvalidDefinition;
import tools.jackson.core.JsonGenerator;

/// Services of others that this program calls through a server, and its own ones.
final class BridgedServices {
    private static final String REQUEST = "_Request";
    private static final String RESPONSE = "_Response";

    private final RosbridgeSession session;
    private final Supplier<Optional<MessageValues>> values;
    private final Map<String, Own> own = new ConcurrentHashMap<>(); // by name

    /// @param values of the server; empty as long as it is not known
    BridgedServices(RosbridgeSession session, Supplier<Optional<MessageValues>> values) {
        this.session = session;
        this.values = values;
    }

    private record Own(String name, String type, Server server) {}

    ServiceClient client(String name, String type, BooleanSupplier isAvailable) {
        return new ServiceClient() {
            @Override
            public boolean isAvailable() {
                return isAvailable.getAsBoolean();
            }

            @Override
            public CompletionStage<byte[]> call(byte[] request) {
                if (values.get().isEmpty()) {
                    return CompletableFuture.failedStage(
                            new IOException(session.trouble().orElse("The server has not answered yet.")));
                }
                MessageValues its = values.get().get();
                RosMessage fields;
                try {
                    fields = its.ofCdr(type + REQUEST, request);
                } catch (InvalidDefinition e) { // the server's distribution does not have the service
                    return CompletableFuture.failedStage(new IOException(e.getMessage(), e));
                }
                return ResponseMessages.toCdr(session.call(name, out -> its.write(fields, out)), its, type + RESPONSE);
            }

            @Override
            public void close() {
                // servers keep nothing of clients
            }
        };
    }

    Served serve(String name, String type, Server server) {
        var service = new Own(name, type, server);
        own.put(name, service);
        values.get().ifPresent(its -> announce(service, its));
        return () -> {
            if (own.remove(name, service)) {
                session.send("unadvertise_service", out -> out.writeStringProperty("service", name));
            }
        };
    }

    private void announce(Own service, MessageValues its) {
        session.send("advertise_service", out -> {
            out.writeStringProperty("service", service.name);
            out.writeStringProperty("type", its.version().wire(service.type));
        });
    }

    /// Tells the server of all own ones, as it has forgotten them.
    void announceAll(MessageValues its) {
        own.values().forEach(each -> announce(each, its));
    }

    /// Answers a request of somebody else.
    ///
    /// @param call `call_service`
    void answer(WireValue.Fields call) throws InvalidMessage {
        String name = call.text("service").orElseThrow(() -> new InvalidMessage("A request has no 'service'."));
        Own service = own.get(name);
        Optional<MessageValues> known = values.get();
        if (service == null || known.isEmpty()) {
            return; // it comes after it was closed
        }
        MessageValues its = known.get();
        WireValue args = call.find("args").orElseGet(() -> new WireValue.Fields(Map.of()));
        service.server.answer(its.toCdr(service.type + REQUEST, args)).whenComplete((response, error) -> {
            if (error == null) {
                var fields = its.ofCdr(service.type + RESPONSE, response);
                respond(call, name, true, out -> its.write(fields, out));
            } else {
                respond(call, name, false, out -> out.writeString(String.valueOf(error.getMessage())));
            }
        });
    }

    private void respond(WireValue.Fields call, String name, boolean isGood, Consumer<JsonGenerator> response) {
        session.send("service_response", out -> {
            call.text("id").ifPresent(id -> out.writeStringProperty("id", id));
            out.writeStringProperty("service", name);
            out.writeName("values");
            response.accept(out);
            out.writeBooleanProperty("result", isGood);
        });
    }
}
