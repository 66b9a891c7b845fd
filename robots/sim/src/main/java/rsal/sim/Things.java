package rsal.sim;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import rsal.sim.world.Body;

/// What is in the world that is neither a wall nor a robot, by name, in the order in which it came.
final class Things {
    private final Map<String, Item> items = new LinkedHashMap<>();
    private List<Item> givers = List.of();

    /// @param givingPower with which it charges each robot that touches it [W]
    record Item(Body body, double givingPower) {}

    void add(Body body, double givingPower) {
        items.put(body.name(), new Item(body, givingPower));
        findGivers();
    }

    Optional<Body> remove(String name) {
        Optional<Body> removed = Optional.ofNullable(items.remove(name)).map(Item::body);
        findGivers();
        return removed;
    }

    private void findGivers() {
        givers = items.values().stream().filter(item -> item.givingPower > 0).toList();
    }

    Optional<Body> find(String name) {
        return Optional.ofNullable(items.get(name)).map(Item::body);
    }

    boolean contains(Body body) {
        Item item = items.get(body.name());
        return item != null && item.body == body;
    }

    Set<String> names() {
        return items.keySet();
    }

    /// Those that charge robots.
    List<Item> givers() {
        return givers;
    }
}
