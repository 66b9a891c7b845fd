package rsal.stage;

import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.TreeMap;
import rsal.data.Pose2d;
import rsal.data.Rgb;
import rsal.robot.RobotSpec;
import rsal.scene.Block;
import rsal.scene.Entity;
import rsal.scene.NamedSeed;
import rsal.scene.Scene;
import rsal.scene.SolidRaster;
import rsal.scene.Surface;
import rsal.scene.Touch;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;
import rsal.stage.Pieces.Piece;
import rsal.world.MapPainter;
import rsal.world.Overlaps;
import rsal.world.Overlaps.Overlap;
import rsal.world.Upright;

/// Turns a world of Stage into what the simulation knows: large bitmaps become walls, bases with all that stands on
/// them robots, all else things.
final class SceneMaker {
    private static final Duration SHORTEST_STEP = Duration.ofMillis(10);
    private static final Duration LONGEST_STEP = Duration.ofMillis(200);
    private static final double MOST_POWER = 1e9; // that a thing gives [W]

    private final StageWorld world;
    private final String path;
    private final long seed;
    private final Duration step;
    private final WorldProblems findings = new WorldProblems();
    private final Pieces pieces = new Pieces(findings);
    private final RobotMaker makes;
    private final IdentityHashMap<Traits, List<Piece>> bodies = new IdentityHashMap<>();
    private final List<SolidRaster> walls = new ArrayList<>();
    private final List<Entity> things = new ArrayList<>();
    private final List<RobotSpec> robots = new ArrayList<>();
    private final Map<String, Entity> robotBodies = new HashMap<>();
    private final Map<String, Location> starts = new HashMap<>(); // where robots are written, by id
    private final Map<String, Pose2d> odomFromBase = new HashMap<>();
    private final Map<String, String> programs = new HashMap<>();
    private final TreeMap<String, Integer> contents = new TreeMap<>();

    /// @param path of the world, for messages
    /// @param seed of colors that are drawn
    SceneMaker(StageWorld world, String path, long seed) {
        this.world = world;
        this.path = path;
        this.seed = seed;
        this.step = possible(world.step());
        this.makes = new RobotMaker(step, findings);
    }

    /// @throws InvalidSettings when it is too large
    Scene scene() {
        world.forEach(model -> contents.merge(model.macro(), 1, Integer::sum));
        world.models().forEach(this::add);
        warnOfOverlaps();
        var warnings = new ArrayList<>(world.warnings());
        warnings.addAll(findings.warnings(path));
        try {
            return new Scene(
                    world.title(),
                    new MapPainter(walls, things, List.copyOf(robotBodies.values())).map(),
                    Optional.of(step),
                    world.quitTime(),
                    Touch.STALL,
                    walls,
                    things,
                    robots,
                    robotBodies,
                    odomFromBase,
                    programs,
                    contents,
                    List.of(),
                    warnings);
        } catch (MapPainter.TooLarge e) {
            throw new InvalidSettings(
                    Location.of(path), String.valueOf(e.getMessage()), "Maybe a 'pose' or a 'unit_length' is wrong.");
        }
    }

    private void warnOfOverlaps() {
        List<Entity> bodies = robots.stream()
                .map(robot -> Objects.requireNonNull(robotBodies.get(robot.id())))
                .toList();
        for (Overlap overlap : Overlaps.of(walls, things, bodies)) {
            Location at = Objects.requireNonNull(starts.get(overlap.robot().name()));
            findings.warn(at, overlap.message(), Overlap.REMEDY);
        }
    }

    private Duration possible(Duration wanted) {
        Duration possible = wanted.compareTo(SHORTEST_STEP) < 0
                ? SHORTEST_STEP
                : wanted.compareTo(LONGEST_STEP) > 0 ? LONGEST_STEP : wanted;
        if (!possible.equals(wanted)) {
            findings.warn(
                    Location.of(path),
                    "'interval_sim' is taken for %d ms.".formatted(possible.toMillis()),
                    "Steps are from %d ms to %d ms.".formatted(SHORTEST_STEP.toMillis(), LONGEST_STEP.toMillis()));
        }
        return possible;
    }

    private void add(StageModel model) {
        if (model.traits().kind() instanceof ModelKind.Position position) {
            addRobot(model, position);
        } else {
            addThing(model);
            model.children().forEach(this::add);
        }
    }

    private void addThing(StageModel model) {
        Traits traits = model.traits();
        StageColor color = traits.color().orElseGet(() -> drawn(model.name()));
        double giving = Math.min(traits.energy().give(), MOST_POWER);
        if (traits.body().raster().isPresent() && !traits.returns().gripper() && giving == 0) {
            Optional<SolidRaster> upright = upright(
                    traits.body().raster().get(), model.worldFromModel(), Pieces.surface(traits.returns(), color));
            if (upright.isPresent()) {
                walls.add(upright.get());
                addThing(model, new SolidBody(traits.body().prisms(), Optional.empty()), color);
                return;
            }
        }
        addThing(model, traits.body(), color);
    }

    private static Optional<SolidRaster> upright(SolidBody.Raster raster, Placement worldFromModel, Surface surface) {
        if (!(raster.cellLength() > 0 && raster.cellWidth() > 0)) {
            return Optional.empty();
        }
        return Upright.of(
                raster.bitmap(),
                worldFromModel.pose().compose(raster.modelFromCorner()),
                raster.cellLength(),
                raster.cellWidth(),
                new rsal.data.Interval(
                        worldFromModel.z() + raster.heights().min(),
                        worldFromModel.z() + raster.heights().max()),
                surface,
                false);
    }

    private void addThing(StageModel model, SolidBody body, StageColor color) {
        warnOfSupply(model, body);
        if (body.isEmpty()) {
            return;
        }
        List<Piece> made = bodies.computeIfAbsent(model.traits(), _ -> pieces.of(model, body, Placement.ORIGIN));
        var rgb = Rgb.of(color.rgb());
        List<Block> blocks = made.stream().map(piece -> piece.in(rgb)).toList();
        if (!blocks.isEmpty()) {
            things.add(new Entity(
                    model.name(),
                    blocks,
                    model.worldFromModel().pose(),
                    model.worldFromModel().z(),
                    Math.min(model.traits().energy().give(), MOST_POWER)));
        }
    }

    private void warnOfSupply(StageModel model, SolidBody body) {
        Traits.Energy energy = model.traits().energy();
        if (energy.give() > 0 && body.isEmpty()) {
            findings.warn(
                    model.location(),
                    "'give_watts' has no effect: nothing can touch '%s'."
                            .formatted(WorldProblems.shortened(model.name())),
                    "Give it a body.");
        } else if (energy.give() > 0 && energy.stored().orElse(Double.POSITIVE_INFINITY) < Double.POSITIVE_INFINITY) {
            findings.warn(
                    model.location(),
                    "What '%s' gives does not end when its 'joules' have."
                            .formatted(WorldProblems.shortened(model.macro())),
                    "Write 'joules -1', which says so.");
        }
    }

    private void addRobot(StageModel base, ModelKind.Position position) {
        RobotMaker.Made made = makes.make(base);
        String id = base.name().replace('/', '.'); // as a slash is what sets devices off from robots
        StageColor color = base.traits().color().orElseGet(() -> drawn(base.name()));
        Rgb rgb = Rgb.of(color.rgb());
        Pose2d pose = base.worldFromModel().pose();
        robots.add(new RobotSpec(id, base.macro(), made.model(), Optional.of(pose), rgb.toString()));
        robotBodies.put(
                id, new Entity(id, made.blocks(rgb), pose, base.worldFromModel().z()));
        starts.put(id, base.location());
        boolean knows = position.localization() == ModelKind.Localization.GPS;
        odomFromBase.put(
                id,
                knows ? pose : position.odometryOrigin().map(Placement::pose).orElse(pose));
        base.traits().controllers().stream()
                .findFirst()
                .ifPresent(controller -> programs.put(id, controller.library()));
    }

    /// A color that follows from the seed and the model's name.
    private StageColor drawn(String name) {
        var random = new SplittableRandom(NamedSeed.of(seed, name));
        return new StageColor(random.nextInt(256), random.nextInt(256), random.nextInt(256), 255);
    }
}
