package rsal.jade;

import jade.wrapper.AgentContainer;
import jade.wrapper.ContainerController;
import java.lang.reflect.Field;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;

/// JADE's tables of a platform's agents: that of a container, and that of all.
///
/// JADE 4.3 puts agents into plain hash maps without the lock under which others look for them: `LADT.put`,
/// `GADT.put`. While such a map grows, for an instant nobody is in it: what is said to an agent just then is lost, or
/// comes without what is not text, as JADE takes it for one on another machine. Of a thousand agents that speak while
/// others start, one in ten thousand was not heard.
final class AgentTables {
    private AgentTables() {}

    /// Lets agents be looked for while others come and go.
    ///
    /// @param container that nobody has begun to use
    /// @throws IllegalStateException when this is another JADE
    static void mend(AgentContainer container) {
        try {
            Object here = get(ContainerController.class, "myImpl", container);
            Class<?> implementation = Class.forName("jade.core.AgentContainerImpl");
            replaceMap(get(implementation, "localAgents", here));
            Object main = get(implementation, "myMainContainer", here);
            replaceMap(get(main.getClass(), "platformAgents", main));
        } catch (ReflectiveOperationException | RuntimeException e) {
            throw new IllegalStateException("This is not JADE 4.3: its tables of agents are not where they were.", e);
        }
    }

    private static void replaceMap(Object table) throws ReflectiveOperationException {
        Object agents = get(table.getClass(), "agents", table);
        Field hidden = field(agents.getClass(), "realHiddenMap");
        hidden.set(agents, new ConcurrentHashMap<>((Map<?, ?>) hidden.get(agents)));
    }

    private static Object get(Class<?> owner, String name, Object of) throws ReflectiveOperationException {
        return field(owner, name).get(of);
    }

    private static Field field(Class<?> owner, String name) throws ReflectiveOperationException {
        Field field = owner.getDeclaredField(name);
        field.setAccessible(true);
        return field;
    }
}
