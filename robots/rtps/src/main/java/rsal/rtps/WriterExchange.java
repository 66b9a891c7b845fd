package rsal.rtps;

import rsal.rtps.wire.MessageWriter;

/// What the writers of a participant share.
///
/// @param fragmentSize most of a sample that one datagram has [B]
record WriterExchange(MessageWriter messages, Transmitter network, int fragmentSize, RtpsLimits limits) {}
