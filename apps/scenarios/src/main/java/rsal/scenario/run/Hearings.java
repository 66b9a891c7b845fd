package rsal.scenario.run;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/// Counts who hears whom, in tables rather than maps of pairs, as a thousand agents make a million of them.
final class Hearings {
    private static final Comparator<Hearing> ORDER = Comparator.comparing(Hearing::sender)
            .thenComparing(Hearing::listener)
            .thenComparing(Hearing::topic);

    private final Map<String, Integer> columns = new HashMap<>(); // by listener
    private final List<String> listeners = new ArrayList<>();
    private final Map<String, Map<String, Counts>> counts = new TreeMap<>(); // by topic and sender

    private static final class Counts {
        private long[] heard = {};
        private long[] lost = {};

        void makeRoom(int column, int known) {
            if (column >= heard.length) {
                heard = Arrays.copyOf(heard, known);
                lost = Arrays.copyOf(lost, known);
            }
        }
    }

    void heard(String sender, String listener, String topic) {
        int column = column(listener);
        of(sender, topic, column).heard[column]++;
    }

    void lost(String sender, String listener, String topic) {
        int column = column(listener);
        of(sender, topic, column).lost[column]++;
    }

    private int column(String listener) {
        Integer known = columns.get(listener);
        if (known == null) {
            known = listeners.size();
            columns.put(listener, known);
            listeners.add(listener);
        }
        return known;
    }

    private Counts of(String sender, String topic, int column) {
        Counts own = counts.computeIfAbsent(topic, _ -> new HashMap<>()).computeIfAbsent(sender, _ -> new Counts());
        own.makeRoom(column, listeners.size());
        return own;
    }

    /// Of all pairs and topics of which there was anything to hear, by sender, listener and topic.
    List<Hearing> all() {
        var all = new ArrayList<Hearing>();
        counts.forEach((topic, bySender) -> bySender.forEach((sender, own) -> {
            for (int i = 0; i < own.heard.length; i++) {
                if (own.heard[i] + own.lost[i] > 0) {
                    all.add(new Hearing(sender, listeners.get(i), topic, own.heard[i], own.lost[i]));
                }
            }
        }));
        all.sort(ORDER);
        return all;
    }
}
