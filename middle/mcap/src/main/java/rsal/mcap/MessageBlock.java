package rsal.mcap;

import java.util.BitSet;

/// Messages that lie together: a chunk, or a part of the file where they are in no chunk.
///
/// @param offset of the record, or of the first message [B]
/// @param length of all [B]
/// @param isChunk else it is records as they are
/// @param start earliest log time of a message, in ns
/// @param end latest log time, in ns
/// @param channels ids of those with messages; handed over, not shared
record MessageBlock(long offset, long length, boolean isChunk, long start, long end, BitSet channels) {}
