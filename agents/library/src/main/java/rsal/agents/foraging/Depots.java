package rsal.agents.foraging;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;
import rsal.agent.AgentContext;
import rsal.data.Point2d;

/// Where robots bring things: its own depots, of which it tells others, and those of others that tell of theirs.
final class Depots {
    private final AgentContext self;
    private final List<Depot> own = new ArrayList<>();

    Depots(AgentContext self) {
        this.self = self;
    }

    /// Keeps in mind where others bring things.
    void listen() {
        self.subscribe(Depot.TOPIC, message -> note(message.content()));
    }

    /// It brings things to places of its own, from now on.
    ///
    /// @param names what others know each by
    /// @param radius around a place that counts [m]
    void settle(List<String> names, List<Point2d> mapFromDepots, double radius) {
        own.clear();
        for (int i = 0; i < names.size(); i++) {
            own.add(new Depot(names.get(i), mapFromDepots.get(i), radius));
        }
    }

    /// Names for the depots of a robot: `robot/1`.
    static List<String> numbered(String robot, int count) {
        return IntStream.rangeClosed(1, count)
                .mapToObj(number -> robot + "/" + number)
                .toList();
    }

    /// Tells others where its own are, if it has any. To be repeated: they may have missed it.
    void publish() {
        for (Depot depot : own) {
            note(depot);
            self.publish(Depot.TOPIC, depot);
        }
    }

    private void note(Depot depot) {
        self.blackboard().write(Depot.TOPIC, depot.robot(), depot);
    }

    /// Whether a thing lies in a depot that it knows of.
    boolean hold(Point2d mapFromThing) {
        return self.blackboard().read(Depot.TOPIC).stream()
                .anyMatch(depot -> depot.content().holds(mapFromThing));
    }

    /// That of its own to which a thing is brought.
    ///
    /// @throws java.util.NoSuchElementException when it has none
    Point2d nearest(Point2d mapFromThing) {
        return own.stream()
                .map(Depot::mapFromDepot)
                .min(Comparator.comparingDouble(mapFromThing::distanceTo))
                .orElseThrow();
    }
}
