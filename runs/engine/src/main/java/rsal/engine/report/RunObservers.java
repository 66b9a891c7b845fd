package rsal.engine.report;

import java.time.Duration;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import rsal.agent.bdi.Mind;

/// Several who see the same.
record RunObservers(List<RunObserver> all) implements RunObserver {
    RunObservers {
        if (all.isEmpty()) {
            throw new IllegalArgumentException("Nobody sees it.");
        }
        all = List.copyOf(all);
    }

    @Override
    public Duration period() {
        return all.stream()
                .map(RunObserver::period)
                .min(Comparator.naturalOrder())
                .orElseThrow();
    }

    @Override
    public boolean looks() {
        return all.stream().anyMatch(RunObserver::looks);
    }

    @Override
    public void sees(Snapshot now, String hash) {
        all.stream().filter(RunObserver::looks).forEach(each -> each.sees(now, hash));
    }

    @Override
    public void looksInto(Duration time, Map<String, Mind.View> minds) {
        all.forEach(each -> each.looksInto(time, minds));
    }

    @Override
    public void happened(RunEvent event, String hash) {
        all.forEach(each -> each.happened(event, hash));
    }

    @Override
    public void heard(SentMessage message, Object content) {
        all.forEach(each -> each.heard(message, content));
    }
}
