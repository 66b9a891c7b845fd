package rsal.mcap;

/// What messages look like.
///
/// @param id from 1
/// @param encoding of the data: `protobuf`
/// @param data handed over, not shared
public record Schema(int id, String name, String encoding, byte[] data) {}
