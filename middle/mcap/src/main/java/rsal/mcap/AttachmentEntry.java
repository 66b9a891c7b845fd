package rsal.mcap;

/// An attachment that is in a file, to be asked for.
///
/// @param offset of its record [B]
/// @param length of its record [B]
/// @param size of its data [B]
public record AttachmentEntry(String name, String mediaType, long logTime, long offset, long length, long size) {}
