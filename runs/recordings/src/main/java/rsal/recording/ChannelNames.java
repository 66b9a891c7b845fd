package rsal.recording;

/// What channels are called.
final class ChannelNames {
    static final String EVENTS = "/events";
    static final String LOG = "/log";
    static final String STATE = "/state";
    static final String ROBOTS = "/robots";
    static final String THINGS = "/things";
    static final String DEVICES = "/devices";
    static final String AGENTS = "/agents";
    static final String MINDS = "/minds";
    static final String MESSAGES = "/messages";
    static final String LINKS = "/links";
    static final String SCAN = "scan";
    static final String RANGES = "ranges";
    static final String PARTICLES = "particles";
    static final String MAP = "map";
    static final String PATH = "path";
    static final String LOCAL_PATH = "local_path";
    static final String ESTIMATE = "estimate";
    static final String DEVICE = "device/";

    private ChannelNames() {}

    /// Of what was said about a topic of agents: `/messages.caught`, which no topic of a robot is called.
    ///
    /// @param kind where the topic is of several kinds; else empty
    static String content(String topic, String kind) {
        return MESSAGES + "." + topic + (kind.isEmpty() ? "" : "." + kind);
    }

    /// What of a channel that is of many is of one of them: no topic of a robot, whatever that is called.
    static String about(String topic, String name) {
        return topic + "\n" + name;
    }

    /// Of a robot: `/r1/scan`.
    static String of(String robot, String what) {
        return "/" + robot + "/" + what;
    }
}
