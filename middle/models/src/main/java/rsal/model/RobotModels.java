package rsal.model;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import rsal.data.Pose2d;
import rsal.data.Solid;
import rsal.robot.RobotModel;
import rsal.robot.RobotModel.Drive;
import rsal.robot.RobotModel.Part;
import rsal.settings.FileSource;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;
import rsal.settings.Problem;
import rsal.settings.Problems;
import rsal.settings.Section;
import rsal.settings.Suggestion;
import rsal.settings.Value;
import rsal.yaml.Yaml;

/// Reads what robots are like from files: models, and the parts that can be mounted on them. Those that come with
/// the program go by name (`pioneer2dx`, `urg04lx`), a person's own by file (`my-robot.yaml`).
public final class RobotModels {
    /// Chosen for a device, it takes the model's own part away.
    public static final String NO_PART = "none";

    private static final int MOST_BYTES = 1_000_000;
    private static final FileSource MODELS = FileSource.resources(RobotModels.class, "/rsal/model/models/");
    private static final FileSource PARTS = FileSource.resources(RobotModels.class, "/rsal/model/parts/");
    private static final Map<File, Value.Mapping> BUILT_IN = new ConcurrentHashMap<>(); // as far as they were read

    /// @param what a robot model or a part
    private record File(String what, String name) {}

    private final FileSource files;
    private final Map<String, Value.Mapping> ownParts;

    /// @param files where a person's own models and parts are
    public RobotModels(FileSource files) {
        this(files, Map.of());
    }

    /// @param files where a person's own models and parts are
    /// @param ownParts by name, each like a part file; they come before those that come with the program
    public RobotModels(FileSource files, Map<String, Value.Mapping> ownParts) {
        this.files = files;
        this.ownParts = Map.copyOf(ownParts);
    }

    /// Names of the models that come with the program.
    public static List<String> builtIn() {
        return List.of(
                "pioneer2dx",
                "pioneer3at",
                "turtlebot3-burger",
                "turtlebot3-waffle",
                "turtlebot4",
                "jackal",
                "husky",
                "amr-890",
                "robotino",
                "e-puck",
                "kilobot");
    }

    /// The models that come with the program, with the parts that they have by themselves.
    public static List<RobotModel> readBuiltIn() {
        var models = new RobotModels(MODELS);
        return builtIn().stream()
                .map(name -> models.read(name, Location.of(name)))
                .toList();
    }

    /// Names of the parts that come with the program.
    public static List<String> builtInParts() {
        return List.of(
                "urg04lx",
                "utm30lx",
                "lds-01",
                "rplidar-a1",
                "lms111",
                "s300-ring",
                "front8",
                "front8rear8",
                "front8rear8dx",
                "robotino-ir",
                "e-puck-ir",
                "blob-camera",
                "fiducials180",
                "fiducials360",
                "pioneer-gripper",
                "pioneer2dx-bumpers",
                "create3-bumper",
                "turntable",
                "pioneer-battery",
                "small-battery",
                "beacon",
                "depth-camera",
                "imu-bmi088",
                "gnss-m8",
                "own-localizer",
                "own-navigator",
                "own-planner",
                "own-docking",
                "own-map",
                "canvas");
    }

    /// The file of a model or part that comes with the program, as people read it; empty when there is none of the
    /// name.
    public static Optional<String> source(String name) {
        Optional<FileSource> folder = builtIn().contains(name)
                ? Optional.of(MODELS)
                : builtInParts().contains(name) ? Optional.of(PARTS) : Optional.empty();
        return folder.map(
                files -> new String(files.read(name + ".yaml", MOST_BYTES, Location.of(name)), StandardCharsets.UTF_8));
    }

    /// A model with the parts that it has by itself.
    ///
    /// @param askedAt where the name was written, for messages
    /// @throws InvalidSettings when there is no such model or its file is wrong
    public RobotModel read(String name, Location askedAt) {
        return read(name, askedAt, Map.of());
    }

    /// A model with parts of one's choice.
    ///
    /// @param choices parts by device name (`laser: urg04lx`), over the model's own; [#NO_PART] leaves one out
    /// @throws InvalidSettings when there is no such model or part, the model has no place for one, or a file is
    /// wrong
    public RobotModel read(String name, Location askedAt, Map<String, Choice> choices) {
        var problems = new Problems();
        Value.Mapping file = find("robot model", name, builtIn(), MODELS, askedAt);
        var section = new Section("", file, problems);
        String title = section.text("title");
        Solid body = BodyReader.ROBOTS.read(section.section("body"));
        return read(name, title, body, section, choices);
    }

    /// A model that is told elsewhere than in a file of its own.
    ///
    /// @param body that was read already
    /// @param section of which all but the `body` is read, like a model file
    /// @throws InvalidSettings with its errors, and those that were noted before
    public RobotModel read(String name, Solid body, Section section, Map<String, Choice> choices) {
        section.has("body");
        return read(name, section.text("title", name), body, section, choices);
    }

    private RobotModel read(String name, String title, Solid body, Section section, Map<String, Choice> choices) {
        Problems problems = section.problems();
        Drive drive = DriveReader.read(section.section("drive"));
        Map<String, Mount> mounts = Mount.all(section.section("mounts"));
        Map<String, Choice> chosen = own(section.section("sensors"));
        section.done();
        problems.throwIfAny();
        chosen.putAll(choices);
        var sensors = new LinkedHashMap<String, Part>();
        var heights = new LinkedHashMap<String, Double>();
        chosen.forEach((device, choice) -> {
            if (choice.part().equals(NO_PART)) {
                return;
            }
            Optional<Mount> mount = Optional.ofNullable(mounts.get(device));
            var itsProblems = new ArrayList<Problem>();
            Optional<Part> part = part(choice, mount, itsProblems);
            boolean somewhere = part.filter(made -> made instanceof Part.Own || made instanceof Part.Registered)
                    .isEmpty(); // else it is nowhere, or in the base's origin if the model has no place for it
            if (mount.isEmpty() && somewhere) {
                problems.add(
                        choice.writtenAt(),
                        "Robot model '%s' has no place for a device '%s'.".formatted(name, device),
                        Suggestion.among(device, mounts.keySet()));
                return;
            }
            itsProblems.forEach(problems::add);
            part.ifPresent(made -> sensors.put(device, made));
            mount.map(Mount::height).ifPresent(height -> height.ifPresent(value -> heights.put(device, value)));
        });
        Map<String, String> carriers = Mount.carriers(mounts, sensors, problems);
        problems.throwIfAny();
        return new RobotModel(name, title, body, drive, sensors, heights, carriers);
    }

    /// @param part name or file of a part
    /// @param writtenAt where that was written, for messages
    public record Choice(String part, Location writtenAt) {}

    private Value.Mapping find(String what, String name, List<String> known, FileSource own, Location askedAt) {
        if (known.contains(name)) {
            return BUILT_IN.computeIfAbsent(new File(what, name), _ -> Yaml.read(own, name + ".yaml", askedAt));
        }
        if (name.endsWith(".yaml") || name.endsWith(".yml")) {
            return Yaml.read(files, name, askedAt);
        }
        throw new InvalidSettings(askedAt, "There is no %s '%s'.".formatted(what, name), Suggestion.among(name, known));
    }

    /// A part by itself, as it would be in the origin of a robot's base.
    ///
    /// @throws InvalidSettings when there is no such part or its file is wrong
    public Part readPart(String name, Location askedAt) {
        return part(name, Pose2d.ORIGIN, askedAt);
    }

    private static Map<String, Choice> own(Section section) {
        var own = new LinkedHashMap<String, Choice>();
        for (String device : section.names()) {
            own.put(device, new Choice(section.text(device), section.locationOf(device)));
        }
        return own;
    }

    /// A part that is mounted somewhere, or on nothing.
    private Optional<Part> part(Choice choice, Optional<Mount> mount, List<Problem> noted) {
        try {
            Pose2d baseFromDevice = mount.map(Mount::baseFromDevice).orElse(Pose2d.ORIGIN);
            return Optional.of(part(choice.part(), baseFromDevice, choice.writtenAt()));
        } catch (InvalidSettings e) {
            noted.addAll(e.problems());
            return Optional.empty();
        }
    }

    private Part part(String name, Pose2d mount, Location askedAt) {
        var problems = new Problems();
        Value.Mapping own = ownParts.get(name);
        var section = new Section("", own != null ? own : find("part", name, builtInParts(), PARTS, askedAt), problems);
        Part part = PartReader.read(name, mount, section);
        problems.throwIfAny();
        return part;
    }
}
