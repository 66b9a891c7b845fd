package rsal.world.yaml;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.UnaryOperator;
import org.jspecify.annotations.Nullable;
import rsal.data.Pose2d;
import rsal.data.Rgb;
import rsal.model.BodyReader;
import rsal.model.RobotColors;
import rsal.model.RobotModels;
import rsal.model.RobotModels.Choice;
import rsal.robot.RobotModel;
import rsal.robot.RobotModel.Part;
import rsal.scene.Block;
import rsal.scene.Entity;
import rsal.scene.Surface;
import rsal.settings.FileSource;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;
import rsal.settings.Problems;
import rsal.settings.Section;
import rsal.settings.Value;

/// Reads the robots of a world, and the models and parts that it describes itself.
final class CrewReader {
    private static final String START = "start";

    private final FileSource files;
    private final Names names;
    private final Problems problems;
    private final Map<String, Value.Mapping> ownModels = new HashMap<>();
    private final Map<String, Value.Mapping> ownParts = new HashMap<>();
    private final Map<List<Object>, Optional<Model>> known = new HashMap<>();
    private final List<Member> members = new ArrayList<>();
    private RobotModels models;

    /// @param files beside the world
    CrewReader(FileSource files, Names names, Problems problems) {
        this.files = files;
        this.names = names;
        this.problems = problems;
        this.models = new RobotModels(files);
    }

    /// A kind of robot.
    ///
    /// @param figure when its body is told in the world
    private record Model(RobotModel model, Optional<SolidReader> figure) {}

    /// A robot.
    ///
    /// @param place empty when one is to be chosen
    /// @param blocks of its body, when they are more than its model tells
    /// @param odometry where it thinks it is at first; its start when empty and `fromStart`
    record Member(
            String id,
            String role,
            RobotModel model,
            Optional<FloorPlace> place,
            Free free,
            Rgb color,
            Optional<List<Block>> blocks,
            boolean fromStart,
            Optional<Pose2d> odometry,
            Optional<String> program,
            Location location) {
        /// Its body as it is for others.
        List<Block> body() {
            return blocks.orElseGet(() -> Entity.blocks(model.body(), color));
        }
    }

    /// Where a place is looked for.
    ///
    /// @param within left, bottom, right, top [m]; null for anywhere
    record Free(double clearance, double @Nullable [] within) {
        boolean holds(Pose2d pose) {
            return within == null
                    || (pose.x() >= within[0]
                            && pose.y() >= within[1]
                            && pose.x() <= within[2]
                            && pose.y() <= within[3]);
        }
    }

    List<Member> members() {
        return members;
    }

    void read(Section parts, Section own, Section robots) {
        for (String name : parts.names()) {
            ownParts.put(name, parts.section(name).mapping());
        }
        for (String name : own.names()) {
            ownModels.put(name, own.section(name).mapping());
        }
        models = new RobotModels(files, ownParts);
        own.names().forEach(name -> model(own.section(name).location(), name, Map.of())); // errors in unused ones
        int number = 0;
        for (String name : robots.names()) {
            group(name, robots.section(name), number++);
        }
        robots.done();
    }

    private void group(String name, Section section, int number) {
        String role = section.text("role", name);
        int count = section.has("count") ? (int) Keys.whole(section, Keys.COUNT) : 0;
        boolean several =
                count > 0 || section.find("pose").filter(FloorPlace::isList).isPresent();
        Optional<Model> model = section.has("model")
                ? model(section.locationOf("model"), section.text("model"), choices(section.section("devices")))
                : missing(section);
        Rgb color = section.has("color")
                ? BodyReader.color(section, "color")
                : Rgb.parse(RobotColors.of(number)).orElseThrow();
        boolean reported =
                Keys.SURFACE.stream().anyMatch(parameter -> section.names().contains(parameter.name()));
        UnaryOperator<Surface> surface = SurfaceReader.reported(section);
        Optional<String> program = section.has("program") ? Optional.of(section.text("program")) : Optional.empty();
        boolean fromStart = section.find("odometry")
                .filter(value ->
                        value instanceof Value.Scalar word && word.value().equals(START))
                .isPresent();
        Optional<Pose2d> odometry = fromStart || !section.has("odometry")
                ? Optional.empty()
                : Optional.of(FloorPlace.one(section, "odometry").pose());
        boolean free = !section.has("pose") || isFree(section);
        Free where = free && section.has("pose") ? free(section.section("pose")) : new Free(0.4, null);
        List<Optional<FloorPlace>> places = free
                ? java.util.Collections.nCopies(Math.max(1, count), Optional.empty())
                : (several ? FloorPlace.several(section, "pose", count) : List.of(FloorPlace.one(section, "pose")))
                        .stream().map(Optional::of).toList();
        section.done();
        if (model.isEmpty()) {
            return;
        }
        Optional<SolidReader> figure = model.get().figure();
        boolean high = places.stream()
                .anyMatch(place -> place.filter(p -> p.height() != 0).isPresent());
        List<Block> plain = figure.map(f -> f.blocks(color))
                .orElseGet(() -> Entity.blocks(model.get().model().body(), color));
        Optional<List<Block>> blocks = !reported && !high && figure.isEmpty()
                ? Optional.empty()
                : Optional.of(List.copyOf(plain.stream()
                        .map(block -> block.with(surface.apply(block.surface())))
                        .toList()));
        for (int i = 0; i < places.size(); i++) {
            String id = several ? name + "-" + (i + 1) : name;
            claim(id, plain.size(), section);
            members.add(new Member(
                    id,
                    role,
                    model.get().model(),
                    places.get(i),
                    where,
                    color,
                    blocks,
                    fromStart,
                    odometry,
                    program,
                    section.location()));
        }
    }

    private void claim(String id, int pieces, Section section) {
        names.claim(id, pieces, section.location());
        if (id.contains("/")) {
            section.problem(
                    section.location(),
                    "'%s' can't be the name of a robot, since a slash separates robots from devices.".formatted(id),
                    "");
        }
    }

    private static Optional<Model> missing(Section section) {
        section.text("model");
        return Optional.empty();
    }

    private static Map<String, Choice> choices(Section devices) {
        var choices = new LinkedHashMap<String, Choice>();
        for (String device : devices.names()) {
            choices.put(device, new Choice(devices.text(device), devices.locationOf(device)));
        }
        return choices;
    }

    private Optional<Model> model(Location at, String name, Map<String, Choice> choices) {
        var chosen = new LinkedHashMap<String, String>();
        choices.forEach((device, choice) -> chosen.put(device, choice.part()));
        return known.computeIfAbsent(List.of(name, chosen), _ -> read(at, name, choices));
    }

    private Optional<Model> read(Location at, String name, Map<String, Choice> choices) {
        if (name.isEmpty()) {
            return Optional.empty();
        }
        var own = new Problems();
        try {
            Value.Mapping mapping = ownModels.get(name);
            if (mapping == null) {
                return Optional.of(new Model(models.read(name, at, choices), Optional.empty()));
            }
            var section = new Section("models." + name, mapping, own);
            SolidReader figure = SolidReader.ofRobot(
                    section.section("body"), section.section("mounts").names());
            RobotModel model = models.read(name, figure.solid(), section, choices);
            checkCarriers(section, figure, model);
            own.throwIfAny();
            return Optional.of(new Model(model, Optional.of(figure)));
        } catch (InvalidSettings e) {
            problems.addAll(e);
            return Optional.empty();
        }
    }

    private static void checkCarriers(Section section, SolidReader figure, RobotModel model) {
        figure.pieces().stream()
                .flatMap(piece -> piece.carrier().stream())
                .distinct()
                .filter(carrier -> model.sensors().containsKey(carrier)
                        && !(model.sensors().get(carrier) instanceof Part.Actuator))
                .forEach(carrier -> section.problem(
                        "body",
                        "A piece of its body stands on '%s', which is not an actuator.".formatted(carrier),
                        ""));
    }

    private static boolean isFree(Section section) {
        return section.find("pose")
                .filter(value -> value instanceof Value.Mapping place
                        && place.find("free").isPresent())
                .isPresent();
    }

    private static Free free(Section pose) {
        if (!(pose.find("free").orElseThrow() instanceof Value.Scalar yes
                && yes.value().equals(true))) {
            pose.problem("free", "'%s' can only be true.".formatted(pose.path("free")), "");
        }
        double clearance = Keys.number(pose, Keys.CLEARANCE);
        double[] within = FloorPlace.area(pose, "within").orElse(null);
        pose.done();
        return new Free(clearance, within);
    }
}
