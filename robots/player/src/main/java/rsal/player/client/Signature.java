package rsal.player.client;

import rsal.player.wire.Header;

/// What tells which messages are alike: about what, for which device.
record Signature(int interf, int index, int subtype) {
    static Signature of(Header header) {
        return new Signature(header.address().interf(), header.address().index(), header.subtype());
    }
}
