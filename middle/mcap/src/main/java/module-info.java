/// MCAP files: chunks of messages with their schemas, an index, checksums. Knows nothing of what is in the messages.
module rsal.mcap {
    requires com.github.luben.zstd_jni;
    requires org.lz4.java;
    requires static org.jspecify;

    exports rsal.mcap;
}
