package rsal.jason;

import jason.asSemantics.ActionExec;
import jason.asSemantics.Circumstance;
import jason.asSemantics.Event;
import jason.asSemantics.Intention;
import jason.asSyntax.StringTerm;
import jason.asSyntax.StringTermImpl;
import jason.asSyntax.Structure;
import jason.asSyntax.Term;
import java.util.AbstractMap;
import java.util.AbstractSet;
import java.util.Comparator;
import java.util.HashMap;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.jspecify.annotations.Nullable;

/// Jason's circumstance with what is pending in the order in which it began. Jason's own order hangs on numbers that
/// are counted for the whole process, so that two equal runs in one would differ; so do numbers in its messages, which
/// are left out.
final class Pending extends Circumstance {
    private static final long serialVersionUID = 1;
    private static final String MESSAGE = "error_msg";

    private final Map<String, Integer> suspended = new HashMap<>(); // pending events, the how many-th
    private int everSuspended;

    @Override
    public void addEvent(Event event) {
        if (event.getTrigger().getLiteral().getAnnot(MESSAGE) instanceof Structure said
                && said.getArity() == 1
                && said.getTerm(0) instanceof StringTerm message) {
            said.setTerm(0, new StringTermImpl(Terms.masked(message.getString())));
        }
        super.addEvent(event);
    }

    @Override
    public void addPendingEvent(String id, Term reason, Event event) {
        suspended.keySet().retainAll(super.getPendingEvents().keySet());
        suspended.put(id, ++everSuspended);
        super.addPendingEvent(id, reason, event);
    }

    @Override
    public Map<String, Event> getPendingEvents() {
        return new Sorted<>(
                super.getPendingEvents(), Comparator.comparingInt(event -> suspended.getOrDefault(event.getKey(), 0)));
    }

    @Override
    public Map<Integer, ActionExec> getPendingActions() {
        return new Sorted<>(super.getPendingActions(), Comparator.comparing(Map.Entry::getKey));
    }

    @Override
    public Map<String, Intention> getPendingIntentions() {
        return new Sorted<>(
                super.getPendingIntentions(),
                Comparator.comparingInt((Map.Entry<String, Intention> pending) ->
                                pending.getValue().getId())
                        .thenComparing(Map.Entry::getKey));
    }

    /// A map seen in an order.
    private static final class Sorted<K, V> extends AbstractMap<K, V> {
        private final Map<K, V> map;
        private final Comparator<Entry<K, V>> order;

        Sorted(Map<K, V> map, Comparator<Entry<K, V>> order) {
            this.map = map;
            this.order = order;
        }

        @Override
        public @Nullable V get(Object key) {
            return map.get(key);
        }

        @Override
        public boolean containsKey(Object key) {
            return map.containsKey(key);
        }

        @Override
        public @Nullable V put(K key, V value) {
            return map.put(key, value);
        }

        @Override
        public @Nullable V remove(Object key) {
            return map.remove(key);
        }

        @Override
        public Set<Entry<K, V>> entrySet() {
            List<Entry<K, V>> sorted = map.entrySet().stream().sorted(order).toList();
            return new AbstractSet<>() {
                @Override
                public Iterator<Entry<K, V>> iterator() {
                    Iterator<Entry<K, V>> all = sorted.iterator();
                    return new Iterator<>() {
                        private @Nullable Entry<K, V> last;

                        @Override
                        public boolean hasNext() {
                            return all.hasNext();
                        }

                        @Override
                        public Entry<K, V> next() {
                            Entry<K, V> next = all.next();
                            last = next;
                            return next;
                        }

                        @Override
                        public void remove() {
                            if (last == null) {
                                throw new IllegalStateException("There is nothing to remove before the first element.");
                            }
                            map.remove(last.getKey());
                        }
                    };
                }

                @Override
                public int size() {
                    return map.size();
                }
            };
        }
    }
}
