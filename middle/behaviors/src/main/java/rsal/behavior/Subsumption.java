package rsal.behavior;

import java.util.ArrayList;
import java.util.List;
import rsal.data.Twist2d;

/// Behaviors on top of each other, each seeing what those under it want and free to change it. Layers may come
/// and go at any time, also from within a behavior: that counts from the next decision on.
public final class Subsumption {
    private final List<Layer> layers = new ArrayList<>();

    private record Layer(String name, Behavior behavior) {}

    /// Puts a layer on top.
    ///
    /// @return this
    /// @throws IllegalArgumentException when there is one of that name
    public Subsumption layer(String name, Behavior behavior) {
        insert(layers.size(), name, behavior);
        return this;
    }

    /// Puts a layer right above another.
    ///
    /// @return this
    /// @throws IllegalArgumentException when there is one of that name, or no such other
    public Subsumption layerAbove(String other, String name, Behavior behavior) {
        int below = names().indexOf(other);
        if (below < 0) {
            throw new IllegalArgumentException("There is no layer '%s' among %s.".formatted(other, names()));
        }
        insert(below + 1, name, behavior);
        return this;
    }

    /// @return whether there was one of that name
    public boolean remove(String name) {
        return layers.removeIf(layer -> layer.name.equals(name));
    }

    /// Names of the layers, the lowest first.
    public List<String> names() {
        return layers.stream().map(Layer::name).toList();
    }

    /// Asks all layers, the lowest first. Without any the robot stands still.
    public Decision decide(Percept percept) {
        Twist2d twist = Twist2d.STOP;
        String inCharge = "";
        var opinions = new ArrayList<Decision.Opinion>(layers.size());
        for (Layer layer : List.copyOf(layers)) {
            Twist2d wanted = layer.behavior.act(percept, twist);
            if (opinions.isEmpty() || !wanted.equals(twist)) {
                inCharge = layer.name;
            }
            twist = wanted;
            opinions.add(new Decision.Opinion(layer.name, wanted, layer.behavior.state()));
        }
        return new Decision(twist, inCharge, opinions);
    }

    private void insert(int at, String name, Behavior behavior) {
        if (names().contains(name)) {
            throw new IllegalArgumentException("There is a layer '%s' already.".formatted(name));
        }
        layers.add(at, new Layer(name, behavior));
    }
}
