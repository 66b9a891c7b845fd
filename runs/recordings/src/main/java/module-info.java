/// Runs in MCAP files: [rsal.recording.proto] is what is in the messages, and [rsal.recording] what of a run
/// becomes which message. Knows runs as people see them, and nothing of what is behind.
module rsal.recordings {
    requires rsal.models;
    requires rsal.worlds;
    requires rsal.behaviors;
    requires transitive rsal.engine;
    requires transitive rsal.mcap;
    requires java.desktop; // to draw animations
    requires static org.jspecify;

    exports rsal.recording;
    exports rsal.recording.animation;
}
