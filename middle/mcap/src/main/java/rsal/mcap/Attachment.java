package rsal.mcap;

/// A file within the file.
///
/// @param logTime when it was attached, in ns
/// @param createTime when it was made, in ns; 0 when nobody knows
/// @param mediaType `text/plain`
/// @param data handed over, not shared
public record Attachment(long logTime, long createTime, String name, String mediaType, byte[] data) {}
