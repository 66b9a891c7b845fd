package rsal.rtps;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.function.Consumer;
import rsal.rtps.WriterProxy.Arrival;
import rsal.rtps.wire.Submessage.Content;

/// Hands samples to a listener. One that fails harms no other one, and gets the next sample.
final class Hearing implements Consumer<Arrival> {
    private static final Logger LOG = System.getLogger(Hearing.class.getName());

    private final SampleListener listener;
    private final String topic;
    private boolean hasFailed; // which is logged once

    Hearing(SampleListener listener, String topic) {
        this.listener = listener;
        this.topic = topic;
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
            if (!hasFailed) {
                LOG.log(Level.ERROR, () -> "A listener of '%s' failed.".formatted(topic), e);
            }
            hasFailed = true;
        }
    }
}
