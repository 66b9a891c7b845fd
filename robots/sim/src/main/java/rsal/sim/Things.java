package rsal.sim;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import rsal.data.Solid;
import rsal.device.SimulationControl.Standing;
import rsal.scene.Block;
import rsal.scene.Entity;
import rsal.sim.world.Body;

/// What is in the world that is neither a wall nor a robot, by name, in the order in which it came.
final class Things {
    private final Map<String, Item> items = new LinkedHashMap<>();
    private @Nullable List<Item> givers; // null until somebody asks, since what charges came or went
    private int newest;

    /// A thing.
    static final class Item {
        private final int number;
        private final Body body;
        private final List<Block> blocks;
        private final double givingPower;
        private @Nullable Standing shown;

        private Item(int number, Body body, List<Block> blocks, double givingPower) {
            this.number = number;
            this.body = body;
            this.blocks = blocks;
            this.givingPower = givingPower;
        }

        Body body() {
            return body;
        }

        List<Block> blocks() {
            return blocks;
        }

        /// With which it charges each robot that touches it [W].
        double givingPower() {
            return givingPower;
        }

        private boolean isGrippable() {
            return blocks.stream().anyMatch(block -> block.surface().grippable());
        }

        private Standing standing() {
            Standing now = shown;
            if (now == null || !now.mapFromThing().equals(body.pose()) || now.height() != body.height()) {
                Solid solid = now == null ? Entity.look(blocks).orElseThrow() : now.body();
                now = new Standing(number, body.name(), solid, body.pose(), body.height(), isGrippable());
                shown = now;
            }
            return now;
        }
    }

    /// @param blocks that the body is made of, at least one
    /// @param givingPower with which it charges each robot that touches it [W]
    void add(Body body, List<Block> blocks, double givingPower) {
        var item = new Item(++newest, body, blocks, givingPower);
        items.put(body.name(), item);
        noteChange(item);
    }

    Optional<Body> remove(String name) {
        Optional<Item> removed = Optional.ofNullable(items.remove(name));
        removed.ifPresent(this::noteChange);
        return removed.map(Item::body);
    }

    private void noteChange(Item item) {
        if (item.givingPower > 0) {
            givers = null;
        }
    }

    Optional<Item> find(String name) {
        return Optional.ofNullable(items.get(name));
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
        List<Item> known = givers;
        if (known == null) {
            known = items.values().stream().filter(item -> item.givingPower > 0).toList();
            givers = known;
        }
        return known;
    }

    /// How people see them.
    List<Standing> standing() {
        var all = new ArrayList<Standing>(items.size());
        items.values().forEach(item -> all.add(item.standing()));
        return List.copyOf(all);
    }
}
