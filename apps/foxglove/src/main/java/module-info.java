/// Shows a run to Foxglove while it happens, and takes goals and poses from it: WebSocket, JSON, protobuf. Knows
/// runs as recordings do, and nothing of our own page.
module rsal.foxglove {
    requires transitive rsal.recordings;
    requires org.eclipse.jetty.http;
    requires org.eclipse.jetty.server;
    requires org.eclipse.jetty.util;
    requires org.eclipse.jetty.websocket.api;
    requires org.eclipse.jetty.websocket.server;
    requires org.slf4j;
    requires tools.jackson.databind;
    requires static org.jspecify;

    exports rsal.foxglove;
}
