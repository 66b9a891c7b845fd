package rsal.ros2.link;

import java.util.Optional;

/// What another program publishes or subscribes to.
///
/// @param isPublisher a subscription otherwise
/// @param profile nearest to what it offers or wants
/// @param typeHash of its type, `RIHS01_…`; empty where it does not say, as Humble's don't
public record RosEndpoint(RosTopic topic, boolean isPublisher, Profile profile, Optional<String> typeHash) {}
