package rsal.ros2.link;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import rsal.rtps.GraphListener;
import rsal.rtps.discovery.EndpointData;
import rsal.rtps.wire.Guid;

/// All that other participants publish and subscribe to, as ROS names it. Each endpoint is read once, when it is found,
/// as those who look for robots ask often. Safe for several threads.
final class FoundEndpoints implements GraphListener {
    private final Map<Guid, RosEndpoint> all = new LinkedHashMap<>();
    private List<RosEndpoint> newest = List.of(); // the same list while nothing changes
    private boolean isOld;

    synchronized List<RosEndpoint> list() {
        if (isOld) {
            newest = List.copyOf(all.values());
            isOld = false;
        }
        return newest;
    }

    @Override
    public synchronized void onEndpoint(EndpointData endpoint) {
        RtpsLink.endpoint(endpoint).ifPresent(found -> isOld |= !found.equals(all.put(endpoint.guid(), found)));
    }

    @Override
    public synchronized void onEndpointLost(Guid endpoint) {
        isOld |= all.remove(endpoint) != null;
    }
}
