package rsal.engine.communication;

import java.time.Duration;
import java.util.HashMap;
import java.util.function.Supplier;
import rsal.engine.report.Answer;
import rsal.engine.report.Link;

/// Who hears whom, looked for once in each second of a run, however often that is asked. What is as it was
/// before is the same object. On the run's thread.
public final class LinkSampler {
    private long second = -1;
    private Answer.Linked links = Answer.Linked.NONE;

    /// @param time since the run's start
    public Answer.Linked at(Duration time, Supplier<Answer.Linked> look) {
        if (time.toSeconds() != second) {
            second = time.toSeconds();
            links = keep(look.get());
        }
        return links;
    }

    private Answer.Linked keep(Answer.Linked now) {
        if (now.equals(links)) {
            return links;
        }
        var before = new HashMap<Link, Link>();
        links.links().forEach(link -> before.put(link, link));
        return new Answer.Linked(
                now.links().stream()
                        .map(link -> before.getOrDefault(link, link))
                        .toList(),
                now.ofChosen());
    }
}
