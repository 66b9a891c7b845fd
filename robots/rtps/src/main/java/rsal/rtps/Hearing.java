package rsal.rtps;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import rsal.rtps.WriterProxy.Arrival;
import rsal.rtps.discovery.EndpointData;
import rsal.rtps.discovery.Qos;
import rsal.rtps.wire.Submessage.Content;

/// Hands samples to a listener. One that fails harms no other one, and gets the next sample.
final class Hearing implements SampleReader.Receiver {
    private static final Logger LOG = System.getLogger(Hearing.class.getName());

    private final SampleListener listener;
    private final EndpointData reader;
    private boolean hasFailed; // which is logged once

    Hearing(SampleListener listener, EndpointData reader) {
        this.listener = listener;
        this.reader = reader;
    }

    @Override
    public boolean hasRoom() {
        Qos qos = reader.qos();
        try {
            return !qos.isReliable() || qos.depth() != Qos.KEEP_ALL || listener.hasRoom();
        } catch (RuntimeException e) {
            failed(e);
            return true;
        }
    }

    @Override
    public void accept(Arrival sample) {
        if (!sample.content().equals(Content.DATA)) {
            return;
        }
        try {
            listener.onSample(new SampleListener.Sample(
                    sample.writer(), sample.number(), sample.timestamp(), sample.inlineQos(), sample.payload()));
        } catch (RuntimeException e) {
            failed(e);
        }
    }

    private void failed(RuntimeException e) {
        if (!hasFailed) {
            LOG.log(Level.ERROR, () -> "A listener of '%s' failed.".formatted(reader.topic()), e);
        }
        hasFailed = true;
    }
}
