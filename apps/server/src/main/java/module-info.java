/// Shows a run to browsers on this machine and takes their commands: HTTP, WebSocket, JSON. Knows runs only as
/// [rsal.scenario.LiveRun], or as [rsal.recording.Playback] when they were recorded; knows nothing of simulators, agent
/// hosts or the command line. Sweeps that are begun in a page it leaves to [rsal.experiment].
module rsal.server {
    requires rsal.models;
    requires rsal.worlds;
    requires rsal.behaviors;
    requires rsal.experiments;
    requires transitive rsal.recordings;
    requires transitive rsal.engine;
    requires io.javalin;
    requires io.prometheus.metrics.model;
    requires io.prometheus.writer.text;
    requires java.management; // memory and threads of this process
    requires jdk.management; // its processor time
    requires org.eclipse.jetty.ee10.servlet;
    requires org.eclipse.jetty.ee10.websocket.jetty.server;
    requires org.eclipse.jetty.server;
    requires org.eclipse.jetty.util;
    requires org.eclipse.jetty.websocket.api;
    requires org.slf4j;
    requires tools.jackson.databind;
    requires static org.jspecify;

    exports rsal.server;
    exports rsal.server.access;

    opens rsal.server.message to
            tools.jackson.databind;
}
