package rsal.ros2.link;

import java.nio.ByteBuffer;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.function.LongSupplier;
import rsal.ros2.cdr.CdrWriter;
import rsal.ros2.type.Distribution;
import rsal.rtps.SampleReader;
import rsal.rtps.SampleWriter;
import rsal.rtps.UdpParticipant;
import rsal.rtps.discovery.Qos;
import rsal.rtps.wire.EntityId;
import rsal.rtps.wire.Guid;

/// Which nodes a participant has, and which writers and readers they have: `ros_discovery_info`, by which
/// tools list nodes. Each change is published at once, or with others of its time ([#together]). Safe for several
/// threads.
final class NodeGraph {
    private static final String TOPIC = "ros_discovery_info";
    private static final String TYPE = "rmw_dds_common::msg::dds_::ParticipantEntitiesInfo_";
    private static final int HUMBLE_GID = 24; // bytes, the last of which are 0; others have Guid.BYTES

    private final UdpParticipant participant;
    private final Distribution distribution;
    private final LongSupplier date; // [ns] since 1970
    private final SampleWriter writer;
    private final Set<Node> nodes = new LinkedHashSet<>();
    private int batches; // that are open
    private boolean isOld; // what was published last

    /// One of them. The graph guards it.
    static final class Node {
        private final String namespace;
        private final String name;
        private final Set<Guid> writers = new LinkedHashSet<>();
        private final Set<Guid> readers = new LinkedHashSet<>();

        private Node(String namespace, String name) {
            this.namespace = namespace;
            this.name = name;
        }
    }

    NodeGraph(UdpParticipant participant, Distribution distribution, LongSupplier date) {
        this.participant = participant;
        this.distribution = distribution;
        this.date = date;
        writer = participant.createWriter(TOPIC, TYPE, Qos.LATCHED, "");
    }

    /// @param namespace `/` for none
    synchronized Node add(String namespace, String name) {
        var node = new Node(namespace, name);
        nodes.add(node);
        announce();
        return node;
    }

    synchronized void remove(Node node) {
        nodes.remove(node);
        announce();
    }

    synchronized void opened(Node node, List<SampleWriter> writers, List<SampleReader> readers) {
        writers.forEach(each -> node.writers.add(each.data().guid()));
        readers.forEach(each -> node.readers.add(each.data().guid()));
        announce();
    }

    synchronized void closed(Node node, List<SampleWriter> writers, List<SampleReader> readers) {
        writers.forEach(each -> node.writers.remove(each.data().guid()));
        readers.forEach(each -> node.readers.remove(each.data().guid()));
        announce();
    }

    /// Publishes once what changes meanwhile: all of a hundred robots with ten endpoints each would be published a
    /// thousand times otherwise.
    void together(Runnable changes) {
        synchronized (this) {
            batches++;
        }
        try {
            changes.run();
        } finally {
            end();
        }
    }

    private synchronized void end() {
        batches--;
        if (isOld) {
            announce();
        }
    }

    private void announce() {
        isOld = batches > 0;
        if (!isOld) {
            publish();
        }
    }

    /// `rmw_dds_common/msg/ParticipantEntitiesInfo`
    private void publish() {
        var info = new CdrWriter();
        var self = new Guid(writer.data().guid().prefix(), EntityId.PARTICIPANT);
        info.int8s(gid(self)).int32(nodes.size());
        for (Node node : nodes) {
            info.text(node.namespace).text(node.name);
            gids(info, node.readers);
            gids(info, node.writers);
        }
        participant.write(writer, date.getAsLong(), info.toBytes());
    }

    private void gids(CdrWriter info, Set<Guid> all) {
        info.int32(all.size());
        all.forEach(each -> info.int8s(gid(each)));
    }

    private byte[] gid(Guid guid) {
        var bytes = ByteBuffer.allocate(distribution == Distribution.HUMBLE ? HUMBLE_GID : Guid.BYTES);
        guid.write(bytes);
        return bytes.array();
    }
}
