package rsal.rtps.wire;

/// Numbers of submessages (DDSI-RTPS 2.5, 9.4.5.1.1).
final class SubmessageId {
    static final int PAD = 0x01;
    static final int ACKNACK = 0x06;
    static final int HEARTBEAT = 0x07;
    static final int GAP = 0x08;
    static final int INFO_TIME = 0x09;
    static final int INFO_SOURCE = 0x0c;
    static final int INFO_DESTINATION = 0x0e;
    static final int NACK_FRAGMENTS = 0x12;
    static final int DATA = 0x15;
    static final int DATA_FRAGMENTS = 0x16;

    private SubmessageId() {}
}
