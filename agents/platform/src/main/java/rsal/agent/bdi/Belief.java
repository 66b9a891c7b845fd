package rsal.agent.bdi;

/// Something that an agent takes for true. Setting it makes the agent think again. On the agent's lane.
public final class Belief<T> {
    private final Mind mind;
    private final String name;
    private T value;

    Belief(Mind mind, String name, T value) {
        this.mind = mind;
        this.name = name;
        this.value = value;
    }

    public String name() {
        return name;
    }

    public T get() {
        return value;
    }

    public void set(T newer) {
        if (!newer.equals(value)) {
            value = newer;
            mind.believes(this);
        }
    }
}
