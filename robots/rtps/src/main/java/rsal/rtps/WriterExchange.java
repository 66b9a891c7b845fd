package rsal.rtps;

/// What the writers of a participant share.
///
/// @param fragmentSize most of a sample that one datagram has [B]
record WriterExchange(DatagramOutbox outbox, int fragmentSize, RtpsLimits limits) {}
