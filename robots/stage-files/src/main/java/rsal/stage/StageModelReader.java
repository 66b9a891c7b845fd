package rsal.stage;

import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import rsal.settings.Location;

/// Turns what is written into models: their names, where they are, and their traits.
final class StageModelReader {
    static final int MAX_MODELS = 250_000;

    private static final Set<String> FOR_VIEWERS =
            Set.of("threads", "confirm_on_quit", "show_clock", "show_clock_interval", "test");

    private static final Set<String> OF_WINDOWS = Set.of(
            "size",
            "center",
            "rotate",
            "scale",
            "pcam_loc",
            "pcam_angle",
            "pcam_on",
            "interval",
            "screenshot_skip",
            "screenshots",
            "follow_model");

    private final String path;
    private final WorldFile file;
    private final WorldProblems findings;
    private final Units units;
    private final TraitsReader traits;
    private final IdentityHashMap<WorldfileEntity, Traits> known =
            new IdentityHashMap<>(); // macros share what is in them
    private final Set<String> names = new HashSet<>();
    private int count;

    StageModelReader(String path, WorldFile file, WorldFiles files, WorldProblems findings) {
        this.path = path;
        this.file = file;
        this.findings = findings;
        this.units = units(new EntityFields(file.root(), "a world", Units.DEFAULT, findings));
        this.traits = new TraitsReader(path, files, units, findings);
    }

    StageWorld world() {
        var fields = new EntityFields(file.root(), "a world", units, findings);
        fields.ignore(FOR_VIEWERS);
        fields.withoutEffect("speedup", 1, "Choose the speed of a run when you start it: --speed FACTOR.");
        fields.withoutEffect("paused", 0, "Pause the run on its page.");
        fields.ignore(Set.of("unit_length", "unit_angle"));
        String title = fields.text("name").filter(name -> !name.isBlank()).orElse(path);
        Duration step = fields.milliseconds("interval_sim", 100);
        double resolution = fields.positive("resolution", Units.Kind.NUMBER, 0.02);
        double quit = fields.notNegative("quit_time", Units.Kind.NUMBER, 0);
        fields.done();
        List<StageModel> models = children(file.root(), "", Placement.ORIGIN);
        findings.throwIfAny();
        return new StageWorld(
                title,
                step,
                resolution,
                quit > 0 ? Optional.of(Duration.ofNanos(Math.round(Math.min(quit, 1e9) * 1e9))) : Optional.empty(),
                models,
                findings.warnings(path));
    }

    private static Units units(EntityFields fields) {
        double length = switch (fields.choice("unit_length", "m", List.of("m", "cm", "mm"))) {
            case "cm" -> 0.01;
            case "mm" -> 0.001;
            default -> 1;
        };
        boolean radians = fields.choice("unit_angle", "degrees", List.of("degrees", "radians"))
                .equals("radians");
        return new Units(length, radians ? 1 : Math.toRadians(1));
    }

    /// The models in an entity, in the order of the file.
    ///
    /// @param prefix of their names
    /// @param worldFromParent where their poses count from
    private List<StageModel> children(WorldfileEntity parent, String prefix, Placement worldFromParent) {
        var models = new ArrayList<StageModel>();
        var ofType = new HashMap<String, Integer>();
        for (WorldfileEntity child : parent.children()) {
            if (Types.MODELS.contains(child.type())) {
                int index = ofType.merge(child.type(), 1, Integer::sum) - 1;
                models.add(model(child, prefix, index, worldFromParent));
            } else {
                other(child, parent.type());
            }
        }
        return models;
    }

    private StageModel model(WorldfileEntity entity, String prefix, int index, Placement worldFromParent) {
        if (++count > MAX_MODELS) {
            throw findings.fatal(
                    entity.location(), "The world has more than %d models.".formatted(MAX_MODELS), "Use fewer.");
        }
        String name = unique(name(entity, prefix, index), entity.location());
        Traits own = known.computeIfAbsent(entity.make().orElse(entity), traits::read);
        Placement parentFromModel = pose(entity);
        Placement worldFromModel = worldFromParent.compose(parentFromModel);
        double top = own.stacksChildren() ? own.size().z() : 0;
        return new StageModel(
                name,
                entity.macro(),
                entity.location(),
                parentFromModel,
                worldFromModel,
                own,
                children(entity, name + ".", worldFromModel.raised(top)));
    }

    private Placement pose(WorldfileEntity entity) {
        return entity.find("pose").isPresent()
                ? new EntityFields(entity, "", units, findings).pose("pose").orElse(Placement.ORIGIN)
                : Placement.ORIGIN;
    }

    /// As Stage calls it: `parent.type:index`, or the given name, which a leading slash frees from the parent's.
    private static String name(WorldfileEntity entity, String prefix, int index) {
        String given = entity.find("name").map(s -> Units.text(s.value())).orElse("");
        if (given.isBlank()) {
            return prefix + entity.type() + ":" + index;
        }
        return given.startsWith("/") ? given.substring(1) : prefix + given;
    }

    private String unique(String name, Location location) {
        String unique = name;
        for (int i = 2; !names.add(unique); i++) {
            unique = name + "~" + i;
        }
        if (!unique.equals(name)) {
            findings.warn(
                    location,
                    "There is more than one model '%s'; this one is called '%s' here."
                            .formatted(WorldProblems.shortened(name), WorldProblems.shortened(unique)),
                    "Give each a name of its own.");
        }
        return unique;
    }

    /// An entity that is no model.
    private void other(WorldfileEntity entity, String parent) {
        switch (entity.type()) {
            case Types.WINDOW -> window(entity, parent);
            case Types.BLOCK -> {
                if (parent.equals("world")) {
                    misplaced(entity, "It shapes the model that it stands in.");
                }
            }
            case Types.SENSOR -> {
                if (!parent.equals("ranger")) {
                    misplaced(entity, "Put it into a ranger ( ... ).");
                }
            }
            default -> unknown(entity);
        }
    }

    private void window(WorldfileEntity entity, String parent) {
        if (!parent.equals("world")) {
            misplaced(entity, "It belongs to the world, outside of models.");
        }
        var fields = new EntityFields(entity, "a window", units, findings);
        fields.ignore(OF_WINDOWS);
        for (String name : entity.settings().keySet()) {
            if (name.startsWith("show_")) {
                fields.ignore(Set.of(name));
            }
        }
        fields.done();
    }

    private void misplaced(WorldfileEntity entity, String remedy) {
        findings.warn(entity.location(), "'%s' has no effect here.".formatted(entity.macro()), remedy);
    }

    /// Errors where the world would not be what its author meant, a warning where nothing else is lost.
    private void unknown(WorldfileEntity entity) {
        String type = WorldProblems.shortened(entity.type());
        String macro = WorldProblems.shortened(entity.macro());
        String what = type.equals(macro) ? "'%s' is".formatted(type) : "'%s' is made of '%s',".formatted(macro, type);
        String replacement = Types.REPLACED.get(type);
        if (replacement != null) {
            findings.error(
                    entity.location(), "%s a type that later versions of Stage dropped.".formatted(what), replacement);
        } else if (Types.DISPENSABLE.contains(type)) {
            findings.warn(
                    entity.location(),
                    "%s a type that later versions of Stage dropped; it is ignored.".formatted(what),
                    "");
        } else if (file.complete() // else what was not included may define it
                && !file.known().contains(type)) { // else its definition was told to be wrong
            guess(entity, type);
        }
    }

    private void guess(WorldfileEntity entity, String type) {
        String message = "'%s' is neither a type nor a macro".formatted(type);
        Optional<String> close = findings.guess(type, file.known());
        if (close.isPresent()) {
            findings.error(entity.location(), message + ".", "Maybe '%s' was meant?".formatted(close.get()));
        } else {
            findings.warn(
                    entity.location(),
                    message + "; it is ignored with all that is in it.",
                    "Maybe an include is missing.");
        }
    }
}
