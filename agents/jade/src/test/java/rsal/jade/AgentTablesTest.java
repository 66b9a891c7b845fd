package rsal.jade;

import static org.assertj.core.api.Assertions.assertThat;

import jade.core.AID;
import jade.core.Agent;
import jade.core.AgentDescriptor;
import jade.wrapper.AgentContainer;
import jade.wrapper.ContainerController;
import java.lang.reflect.Field;
import java.lang.reflect.Method;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import rsal.testkit.LongTest;

/// JADE's tables of agents, as a platform has them.
@Timeout(60)
class AgentTablesTest {
    private static final int OTHERS = 500_000; // a hash map of so many is empty for 20 ms while it grows

    @Test
    @LongTest
    void whoIsThereIsFoundWhileOthersComeAndGo() throws Exception {
        JadePlatform platform = JadePlatform.start();
        try {
            List<AID> others = IntStream.range(0, OTHERS)
                    .mapToObj(i -> platform.agent("agent-" + i))
                    .toList();
            for (Table table : tables(platform)) {
                assertThat(missed(table, platform.agent("amy"), others))
                        .as("times that nobody was in %s", table)
                        .isZero();
            }
        } finally {
            platform.endSoon();
        }
    }

    /// How often one who is there all the time is not found while others come and go.
    private static int missed(Table table, AID there, List<AID> others) throws Exception {
        var missed = new AtomicInteger();
        var begun = new CountDownLatch(1);
        var over = new AtomicBoolean();
        table.put(there);
        Thread seeker = Thread.ofPlatform().daemon().start(() -> {
            while (!over.get()) {
                if (!table.finds(there)) {
                    missed.incrementAndGet();
                }
                begun.countDown();
            }
            table.remove(there); // not by another thread, as this one may still hold it
        });
        begun.await();
        others.forEach(table::put);
        others.forEach(table::remove);
        over.set(true);
        seeker.join();
        return missed.get();
    }

    /// Of the container, and of all.
    private static List<Table> tables(JadePlatform platform) throws ReflectiveOperationException {
        var container = (AgentContainer) get(JadePlatform.class, "container", platform);
        Object here = get(ContainerController.class, "myImpl", container);
        Class<?> implementation = Class.forName("jade.core.AgentContainerImpl");
        Object main = get(implementation, "myMainContainer", here);
        return List.of(
                Table.of(get(implementation, "localAgents", here), new Agent()),
                Table.of(get(main.getClass(), "platformAgents", main), new AgentDescriptor()));
    }

    private static Object get(Class<?> owner, String name, Object of) throws ReflectiveOperationException {
        Field field = owner.getDeclaredField(name);
        field.setAccessible(true);
        return field.get(of);
    }

    /// One of JADE's, which it shows nobody.
    ///
    /// @param one what is put there for every name
    private record Table(Object table, Object one, Method put, Method remove, Method acquire, Method release) {
        static Table of(Object table, Object one) throws NoSuchMethodException {
            return new Table(
                    table,
                    one,
                    method(table, "put", AID.class, one.getClass()),
                    method(table, "remove", AID.class),
                    method(table, "acquire", AID.class),
                    method(table, "release", AID.class));
        }

        private static Method method(Object table, String name, Class<?>... parameters) throws NoSuchMethodException {
            Method method = table.getClass().getDeclaredMethod(name, parameters);
            method.setAccessible(true);
            return method;
        }

        void put(AID agent) {
            call(put, agent, one);
        }

        void remove(AID agent) {
            call(remove, agent);
        }

        boolean finds(AID agent) {
            boolean found = call(acquire, agent) != null;
            if (found) {
                call(release, agent);
            }
            return found;
        }

        private Object call(Method method, Object... arguments) {
            try {
                return method.invoke(table, arguments);
            } catch (ReflectiveOperationException e) {
                throw new LinkageError(e.getMessage(), e);
            }
        }

        /// `LADT`
        @Override
        public String toString() {
            return table.getClass().getSimpleName();
        }
    }
}
