package rsal.recording;

/// What channels are called.
final class Topics {
    static final String EVENTS = "/events";
    static final String STATE = "/state";

    private Topics() {}

    /// Of a robot: `/r1/scan`.
    static String of(String robot, String what) {
        return "/" + robot + "/" + what;
    }
}
