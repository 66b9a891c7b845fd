package rsal.agents.driving;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import rsal.agent.AgentContext;
import rsal.agent.protocol.Conversation;
import rsal.agent.protocol.ConversationResult;
import rsal.agent.protocol.Request;
import rsal.agents.driving.PlaceSearch.Found;
import rsal.agents.driving.PlaceSearch.Wanted;
import rsal.data.Point2d;
import rsal.settings.Parameter;

/// Has places found for a team by one of its robots that can ([PlaceSearch]); by another when that one fails or is
/// silent. Says in its agent's state what it waits for.
public final class PlaceQuest {
    public static final Parameter<Double> CLEARANCE = Parameter.number(
            "clearance", 0.4, 0.05, 10, "m", "Minimum distance of places to find, and of paths to them, from walls.");

    private final AgentContext self;
    private final Consumer<List<Point2d>> onFound;
    private final Request<Wanted, Found> search;
    private final Set<String> asked = new TreeSet<>(); // in vain, for the same number
    private Optional<Wanted> wanted = Optional.empty();
    private @Nullable Conversation conversation; // while it waits
    private boolean found;
    private String failure = "";

    /// @param onFound told the places, on the agent's lane
    public PlaceQuest(AgentContext self, Consumer<List<Point2d>> onFound) {
        this.self = self;
        this.onFound = onFound;
        this.search = PlaceSearch.service(self);
    }

    /// Begins to look for places, unless these are found or looked for already. When all have failed, it is their turn
    /// again.
    ///
    /// @param agents who are there
    public void want(Wanted places, List<String> agents) {
        if (!wanted.equals(Optional.of(places))) {
            wanted = Optional.of(places);
            found = false;
            asked.clear();
            giveUp();
        }
        if (conversation == null && !found) {
            askOneOf(agents, places);
        }
    }

    /// Whether what is wanted now is found.
    public boolean isFound() {
        return found;
    }

    private void askOneOf(List<String> agents, Wanted places) {
        List<String> able = agents.stream()
                .filter(agent -> self.directory().capabilities(agent).contains(PlaceSearch.CAPABILITY))
                .toList();
        if (able.isEmpty()) {
            self.state("waiting for a robot that can find places");
            return;
        }
        Optional<String> next =
                able.stream().filter(agent -> !asked.contains(agent)).findFirst();
        if (next.isEmpty()) {
            self.state("found no places: " + failure);
            asked.clear();
            return;
        }
        asked.add(next.get());
        self.state("waiting for %s to find %d places".formatted(next.get(), places.count()));
        conversation = search.ask(next.get(), places, ending -> {
            if (wanted.equals(Optional.of(places))) {
                ended(places, ending, agents);
            }
        });
    }

    private void giveUp() {
        if (conversation != null) {
            Conversation unwanted = conversation;
            conversation = null;
            unwanted.cancel();
        }
    }

    private void ended(Wanted places, ConversationResult<Found> ending, List<String> agents) {
        conversation = null;
        switch (ending) {
            case ConversationResult.Informed<Found>(Found reported)
            when reported.mapFromPlaces().size() == places.count() -> {
                found = true;
                onFound.accept(reported.mapFromPlaces());
                return;
            }
            case ConversationResult.Informed<Found>(Found reported) ->
                failure = "%d instead of %d were told"
                        .formatted(reported.mapFromPlaces().size(), places.count());
            case ConversationResult.Refused<Found>(String why) -> failure = why;
            case ConversationResult.Failed<Found>(String why) -> failure = why;
            case ConversationResult.NotUnderstood<Found>(String why) -> failure = why;
            case ConversationResult.Silent<Found>(String why) -> failure = why;
            case ConversationResult.Cancelled<Found> _ -> failure = "cancelled";
        }
        askOneOf(agents, places);
    }
}
