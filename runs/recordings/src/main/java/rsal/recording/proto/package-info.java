/// What is in messages, in the encoding of Protocol Buffers (protobuf.dev, "Encoding"): kinds of messages that describe
/// themselves, so that readers of a file need nothing else, and their bytes.
@NullMarked
package rsal.recording.proto;

import org.jspecify.annotations.NullMarked;
