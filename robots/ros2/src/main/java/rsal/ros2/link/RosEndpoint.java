package rsal.ros2.link;

/// What another program publishes or subscribes to.
///
/// @param isPublisher a subscription otherwise
/// @param profile nearest to what it offers or wants
public record RosEndpoint(RosTopic topic, boolean isPublisher, Profile profile) {}
