package rsal.engine.communication;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.IntStream;
import java.util.stream.LongStream;
import rsal.engine.report.Reception;

/// Counts who hears whom, in tables rather than maps of pairs, as a thousand agents make a million of them.
final class ReceptionCounts {
    /// How many lines are told at most.
    static final int MOST = 10_000;

    /// How many of one agent are told at most.
    static final int MOST_OF_ONE = 60;

    private static final String ALL = "";
    private static final Comparator<Reception> ORDER = Comparator.comparing(Reception::sender)
            .thenComparing(Reception::listener)
            .thenComparing(Reception::topic);

    private final Map<String, Integer> columns = new HashMap<>(); // by listener
    private final List<String> listeners = new ArrayList<>();
    private final Map<String, Map<String, Counts>> counts = new TreeMap<>(); // by topic and sender

    private static final class Counts {
        private long[] heard = {};
        private long[] lost = {};

        long entries() {
            return IntStream.range(0, heard.length)
                    .filter(i -> heard[i] + lost[i] > 0)
                    .count();
        }

        Optional<Reception> at(String sender, String listener, String topic, int column) {
            return column < heard.length && heard[column] + lost[column] > 0
                    ? Optional.of(new Reception(sender, listener, topic, heard[column], lost[column]))
                    : Optional.empty();
        }

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

    /// Of all pairs and topics of which there was anything to hear, by sender, listener and topic. Of too many pairs to
    /// tell, all listeners of a sender together; of too many senders, these together, too.
    List<Reception> all() {
        if (entries() <= MOST) {
            return each();
        }
        var together = new ArrayList<Reception>();
        counts.forEach((topic, bySender) -> bySender.forEach((sender, own) -> together.add(new Reception(
                sender,
                ALL,
                topic,
                LongStream.of(own.heard).sum(),
                LongStream.of(own.lost).sum()))));
        if (together.size() <= MOST) {
            together.sort(ORDER);
            return together;
        }
        var byTopic = new TreeMap<String, Reception>();
        for (Reception one : together) {
            byTopic.merge(
                    one.topic(),
                    new Reception(ALL, ALL, one.topic(), one.heard(), one.lost()),
                    (sum, next) ->
                            new Reception(ALL, ALL, sum.topic(), sum.heard() + next.heard(), sum.lost() + next.lost()));
        }
        return List.copyOf(byTopic.values());
    }

    private long entries() {
        return counts.values().stream()
                .flatMap(bySender -> bySender.values().stream())
                .mapToLong(Counts::entries)
                .sum();
    }

    /// What one agent heard of others, and others of it; those first of which most was lost.
    List<Reception> of(String agent) {
        var own = new ArrayList<Reception>();
        Integer column = columns.get(agent);
        counts.forEach((topic, bySender) -> {
            if (column != null) {
                bySender.forEach(
                        (sender, said) -> said.at(sender, agent, topic, column).ifPresent(own::add));
            }
            Counts said = bySender.get(agent);
            for (int i = 0; said != null && i < said.heard.length; i++) {
                said.at(agent, listeners.get(i), topic, i).ifPresent(own::add);
            }
        });
        own.sort(Comparator.comparingLong(Reception::lost).reversed().thenComparing(ORDER));
        return own.size() <= MOST_OF_ONE ? own : List.copyOf(own.subList(0, MOST_OF_ONE));
    }

    private List<Reception> each() {
        var all = new ArrayList<Reception>();
        counts.forEach((topic, bySender) -> bySender.forEach((sender, own) -> {
            for (int i = 0; i < own.heard.length; i++) {
                own.at(sender, listeners.get(i), topic, i).ifPresent(all::add);
            }
        }));
        all.sort(ORDER);
        return all;
    }
}
