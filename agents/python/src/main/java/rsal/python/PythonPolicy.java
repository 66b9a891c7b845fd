package rsal.python;

import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.ServiceLoader;
import org.jspecify.annotations.Nullable;
import rsal.agent.AgentContext;

/// What a trained policy in Python observes and does, at a steady rate as in the environment that it was trained in.
/// On the agent's lane.
final class PythonPolicy {
    private final AgentContext self;
    private final PythonRequests.Heard heard;
    private ObservationService.@Nullable Observed observed;

    PythonPolicy(AgentContext self, PythonRequests.Heard heard) {
        this.self = self;
        this.heard = heard;
    }

    /// Sends observations under a number from now on.
    ///
    /// @param first time until the first one
    /// @param period time between two of them
    void begin(int number, List<?> observe, @Nullable Object act, Duration first, Duration period) {
        ObservationService.Observed began = ServiceLoader.load(ObservationService.class)
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException("This RSAL has no learning environments."))
                .of(self, observe.stream().map(PythonPolicy::words).toList(), words(act));
        observed = began;
        self.scheduler().after(first, () -> {
            heard.hear(number, true, began.observe());
            self.scheduler().every(period, () -> heard.hear(number, true, began.observe()));
        });
    }

    void act(List<?> numbers) {
        ObservationService.Observed began = observed;
        if (began == null) {
            throw new IllegalArgumentException("An agent must observe before it acts.");
        }
        var action = new float[numbers.size()];
        for (int i = 0; i < action.length; i++) {
            action[i] = (float) FromWords.number(numbers.get(i));
        }
        began.act(action);
    }

    private static Map<String, Object> words(@Nullable Object given) {
        var words = new LinkedHashMap<String, Object>();
        if (!(given instanceof Map<?, ?> map)) {
            throw new IllegalArgumentException("'%s' is no dict with a 'type'.".formatted(given));
        }
        map.forEach((name, value) -> words.put(String.valueOf(name), value));
        return words;
    }
}
