/// Runs in files: [rsal.recording.mcap] writes and reads MCAP, [rsal.recording.proto] what is in its messages, and
/// [rsal.recording] what of a run becomes which message. Knows runs as people see them, and nothing of what is behind.
module rsal.recordings {
    requires rsal.models;
    requires rsal.worlds;
    requires rsal.behaviors;
    requires transitive rsal.engine;
    requires com.github.luben.zstd_jni;
    requires java.desktop; // to draw animations
    requires static org.jspecify;

    exports rsal.recording;
    exports rsal.recording.animation;
    exports rsal.recording.mcap;
}
