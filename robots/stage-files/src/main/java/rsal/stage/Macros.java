package rsal.stage;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import rsal.settings.Location;
import rsal.stage.WorldfileEntity.Setting;

/// Puts macros in where they are used. A macro is worked out once and what is in it shared by all that is made of
/// it, so that a thousand robots of a kind take little room.
final class Macros {
    /// Of entities in each other as they are written, and of macros that build upon each other.
    static final int MAX_DEPTH = 64;

    private static final int MAX_EXPANDED_DEPTH = 256; // both together

    /// In a whole world, macros put in.
    static final long MAX_ENTITIES = 2_000_000;

    private static final long MAX_COPIES = 20_000_000; // of children and settings, while macros are put in

    private static final Set<String> COPIED = Set.of("name", "pose");

    private final WorldProblems findings;
    private final Dialect dialect;
    private final Map<String, Macro> macros = new LinkedHashMap<>();
    private final Map<String, Macro> baseless = new LinkedHashMap<>(); // whose base nobody knows, yet
    private long copies;

    Macros(WorldProblems findings, Dialect dialect) {
        this.findings = findings;
        this.dialect = dialect;
    }

    private static final class Macro {
        final Location location;
        final Syntax body; // its name is the base's
        final @Nullable Macro base; // null when the base is a type
        final int depth; // how many macros it builds upon

        @Nullable
        WorldfileEntity expanded; // null until it is used

        boolean expanding;

        Macro(Location location, Syntax body, @Nullable Macro base) {
            this.location = location;
            this.body = body;
            this.base = base;
            this.depth = base == null ? 0 : base.depth + 1;
        }
    }

    /// Whether models can be of it: a type, or a macro that is defined by now.
    boolean isKnown(String name) {
        return macros.containsKey(name) || dialect.types().contains(name);
    }

    /// The first definition of a name counts, as in Stage.
    ///
    /// @param body named after what the macro builds upon
    void define(String name, Location location, Syntax body) {
        Macro first = macros.get(name);
        if (first != null) {
            if (!first.location.equals(location)) {
                findings.warn(
                        location,
                        "'%s' is defined again, without effect: its first definition counts, at %s."
                                .formatted(WorldProblems.shortened(name), first.location),
                        "Give one of them another name.");
            }
            return;
        }
        Macro base = macros.get(body.name());
        var macro = new Macro(location, body, base);
        if (base == null
                && !dialect.types().contains(body.name())
                && !dialect.dropped().contains(body.name())) {
            baseless.put(name, macro);
        }
        if (macro.depth > MAX_DEPTH) {
            throw findings.fatal(
                    location,
                    "'%s' builds upon more than %d macros.".formatted(WorldProblems.shortened(name), MAX_DEPTH),
                    "Remove some.");
        }
        macros.put(name, macro);
    }

    /// Tells of definitions that build upon nothing, once all are known.
    void reportBaseless() {
        var inCircles = new HashSet<String>();
        baseless.forEach((name, macro) -> {
            String base = macro.body.name();
            List<String> circle = circle(name, macro);
            if (inCircles.addAll(circle)) {
                findings.error(
                        macro.body.location(),
                        "'%s' builds upon itself%s."
                                .formatted(
                                        WorldProblems.shortened(name),
                                        circle.size() == 2 ? "" : ": " + String.join(" → ", circle)),
                        "Write define NAME BASE ( ... ), BASE being a type such as 'model' or 'position'.");
            }
            if (!circle.isEmpty()) {
                return;
            }
            Macro later = macros.get(base);
            String remedy = later == null
                    ? findings.maybe(base, known(), "Types are: %s.".formatted(String.join(", ", dialect.types())))
                    : "It is defined at %s; put that first.".formatted(later.location);
            findings.error(
                    macro.body.location(),
                    "'%s' is neither a type nor a macro that is defined above."
                            .formatted(WorldProblems.shortened(base)),
                    remedy);
        });
    }

    /// The names from a macro's to its own again, each built upon the next; empty when they lead elsewhere.
    private List<String> circle(String name, Macro first) {
        var names = new ArrayList<String>(List.of(name));
        for (Macro macro = first; macro != null && names.size() <= MAX_DEPTH; ) {
            String base = macro.body.name();
            names.add(base);
            if (base.equals(name)) {
                return names;
            }
            macro = macros.get(base);
        }
        return List.of();
    }

    /// Names of all types and macros.
    Set<String> known() {
        var known = new TreeSet<>(dialect.types());
        known.addAll(macros.keySet());
        return known;
    }

    WorldfileEntity expand(Syntax written) {
        return expand(written, macros.get(written.name()), 0);
    }

    private WorldfileEntity expand(Syntax written, @Nullable Macro macro, int depth) {
        if (depth > MAX_EXPANDED_DEPTH) {
            throw findings.fatal(
                    written.location(),
                    "'%s' is more than %d deep in macros."
                            .formatted(WorldProblems.shortened(written.name()), MAX_EXPANDED_DEPTH),
                    "Maybe macros hold each other.");
        }
        WorldfileEntity base = macro == null
                ? new WorldfileEntity(
                        written.name(), written.name(), written.location(), Map.of(), List.of(), Optional.empty(), 1)
                : template(macro, written, depth);
        long size = base.size();
        List<WorldfileEntity> own = new ArrayList<>();
        for (Syntax child : written.children()) {
            WorldfileEntity entity = expand(child, macros.get(child.name()), depth + 1);
            own.add(entity);
            size += entity.size();
        }
        count(written, size, own.size(), base);
        return new WorldfileEntity(
                base.type(),
                written.name(),
                written.location(),
                joined(base.settings(), written.settings()),
                joined(base.children(), own),
                isCopy(written) ? Optional.of(base.make().orElse(base)) : Optional.empty(),
                size);
    }

    /// Whether a macro's user says nothing but where it is and what it is called.
    private static boolean isCopy(Syntax written) {
        return written.children().isEmpty()
                && COPIED.containsAll(written.settings().keySet());
    }

    private WorldfileEntity template(Macro macro, Syntax user, int depth) {
        WorldfileEntity template = macro.expanded;
        if (template == null) {
            if (macro.expanding) {
                findings.error(
                        user.location(),
                        "'%s' is part of its own definition at %s."
                                .formatted(WorldProblems.shortened(user.name()), macro.location),
                        "Take it out there.");
                return new WorldfileEntity(
                        "model", user.name(), user.location(), Map.of(), List.of(), Optional.empty(), 1);
            }
            macro.expanding = true;
            template = expand(macro.body, macro.base, depth + 1);
            macro.expanding = false;
            macro.expanded = template;
        }
        return template;
    }

    private void count(Syntax written, long size, int ownChildren, WorldfileEntity base) {
        if (size > MAX_ENTITIES) {
            throw findings.fatal(
                    written.location(),
                    "'%s' would make more than %d entities."
                            .formatted(WorldProblems.shortened(written.name()), MAX_ENTITIES),
                    "Maybe macros hold each other many times.");
        }
        copies += 1 + written.settings().size() + ownChildren;
        copies += written.settings().isEmpty() ? 0 : base.settings().size();
        copies += ownChildren == 0 ? 0 : base.children().size();
        if (copies > MAX_COPIES) {
            throw findings.fatal(
                    written.location(), "The world is too large after its macros are expanded.", "Use smaller macros.");
        }
    }

    private static Map<String, Setting> joined(Map<String, Setting> base, Map<String, Setting> own) {
        if (base.isEmpty() || own.isEmpty()) {
            return base.isEmpty() ? own : base;
        }
        var all = new LinkedHashMap<>(base);
        all.putAll(own);
        return all;
    }

    private static List<WorldfileEntity> joined(List<WorldfileEntity> base, List<WorldfileEntity> own) {
        if (base.isEmpty() || own.isEmpty()) {
            return base.isEmpty() ? own : base;
        }
        var all = new ArrayList<WorldfileEntity>(base.size() + own.size());
        all.addAll(base);
        all.addAll(own);
        return all;
    }
}
