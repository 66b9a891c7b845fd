package rsal.cli.show;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import rsal.cli.terminal.Exit;
import rsal.cli.terminal.FileName;
import rsal.cli.terminal.Subcommand;
import rsal.cli.terminal.Unreachable;
import rsal.map.Maps;
import rsal.model.RobotModels;
import rsal.navigation.rooms.RoomMap;
import rsal.recording.Recording;
import rsal.scenario.RunOptions;
import rsal.scenario.Scenario;
import rsal.scenario.picture.WorldPicture;
import rsal.scene.Scene;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;
import rsal.settings.Suggestion;

/// `rsal show`
@Command(
        name = "show",
        description = "Show the content of a file: a scenario, a world (with an image), a map, a robot model, a part,"
                + " a recording, an agent, a metric or a controller. Or show the parameters of what"
                + " 'rsal list' names: an agent type, a device driver, an algorithm such as 'vfh', a"
                + " metric, a robot system or an agent platform.")
public final class ShowCommand extends Subcommand {
    private static final int PICTURE = 1600; // longest side [px]
    private static final int MOST_PLACES = 128; // more take too long to compare

    @Parameters(
            converter = FileName.class,
            paramLabel = "SCENARIO[:CONFIGURATION]|WORLD|AGENT|NAME",
            description =
                    ScenarioReference.WHAT
                            + "; a world (FILE.world.yaml, Stage's FILE.world, Gazebo's FILE.sdf, or Player's FILE.cfg); a map (ROS's YAML); a recording (FILE.mcap); an agent in Java or AgentSpeak (FILE.java, FILE.asl); a metric or a controller in Java (FILE.java); or what 'rsal list WHAT' names.")
    private String name = "";

    @Option(
            names = "--image",
            paramLabel = "OUT.png",
            description = "File for the image of a world or a map. Default: its name with .png, in this folder.")
    private @Nullable Path image;

    @Option(
            names = "--rooms",
            description = "Divide a map into rooms, corridors and closets: list them with the gates between them, and"
                    + " draw them.")
    private boolean rooms;

    @Option(
            names = "--places",
            paramLabel = "N",
            description =
                    "With --rooms: choose places for 1 to 128 robots by each objective, compare them, and draw those"
                            + " of the objective 'rooms'.")
    private @Nullable Integer places;

    @Override
    protected int run() throws IOException {
        checkPlaces();
        if (rooms) {
            showRooms();
            return Exit.SUCCESS;
        }
        if (Scenario.isWorld(name)) {
            showWorld();
            return Exit.SUCCESS;
        }
        if (image == null && RecordingFile.is(name)) {
            try (Recording recording = RecordingFile.open(name, true)) {
                var shown = ShownRecording.of(name, recording);
                show(shown, shown.text());
            }
            return Exit.SUCCESS;
        }
        if (FileKind.of(name).equals(Optional.of(FileKind.MAP))) {
            showMap();
            return Exit.SUCCESS;
        }
        Optional<InstalledKind> plugin = image == null ? OwnPlugin.of(name) : Optional.empty();
        if (plugin.isPresent()) {
            show(plugin.get(), plugin.get().text());
            return Exit.SUCCESS;
        }
        Optional<ShownAgent> agent = image == null ? ShownAgent.of(name) : Optional.empty();
        if (agent.isPresent()) {
            show(agent.get(), agent.get().text());
            return Exit.SUCCESS;
        }
        Optional<ShownPart> part = ShownPart.of(name);
        if (image == null && part.isPresent()) {
            show(part.get(), part.get().text());
            return Exit.SUCCESS;
        }
        if (image != null) {
            throw new ParameterException(
                    spec.commandLine(),
                    "Only maps and worlds (FILE.world.yaml, FILE.world, FILE.sdf, FILE.cfg) are drawn.");
        }
        List<InstalledKind> all = InstalledKind.all();
        List<InstalledKind> named = all.stream().filter(kind -> kind.is(name)).toList();
        List<InstalledKind> found = named.isEmpty()
                ? all.stream()
                        .filter(kind -> kind.offers(name))
                        .map(kind -> kind.about(name))
                        .toList()
                : named;
        if (found.isEmpty() || Scenario.builtInNames().contains(name)) {
            show(ScenarioReference.parse(name), all, found);
        } else if (json) {
            printJson(Map.of("found", found));
        } else {
            print(found.stream().map(InstalledKind::text).collect(Collectors.joining("\n")));
        }
        return Exit.SUCCESS;
    }

    private void show(Record found, String text) {
        if (json) {
            printJson(found);
        } else {
            print(text);
        }
    }

    private void showMap() {
        Maps.Found found = ShownMap.find(name);
        ShownMap map = ShownMap.of(name, found);
        Path drawn = draw(Scene.of(found.grid()));
        show(map, map.text());
        if (!json) {
            found.warnings().forEach(warning -> out().println(ShownWorld.line(warning)));
            out().println("\nDrawn to " + drawn);
            out().flush();
        }
    }

    private void checkPlaces() {
        if (places != null && !rooms) {
            throw new ParameterException(
                    spec.commandLine(),
                    "Places for '%d' robots (--places) are chosen by the rooms of a map. Maybe --rooms is missing."
                            .formatted(places));
        }
        if (places != null && (places < 1 || places > MOST_PLACES)) {
            throw new ParameterException(
                    spec.commandLine(),
                    "Places can be chosen for 1 to %d robots (--places), not for '%d'. Maybe a smaller team will do."
                            .formatted(MOST_PLACES, places));
        }
    }

    private void showRooms() {
        if (!Maps.builtIn().contains(name) && !FileKind.of(name).equals(Optional.of(FileKind.MAP))) {
            throw new ParameterException(
                    spec.commandLine(),
                    "Only maps have rooms: ROS's YAML, or one of %s.".formatted(String.join(", ", Maps.builtIn())));
        }
        Maps.Found file = ShownMap.find(name);
        RoomMap found = RoomMap.of(file.grid());
        Optional<ShownPlaces> chosen = Optional.ofNullable(places).map(number -> places(found, number));
        Path drawn = write(
                () -> RoomPicture.png(found, chosen.map(ShownPlaces::roomPlaces).orElse(List.of())));
        var shown = ShownRooms.of(name, found, chosen, drawn.toString(), file.warnings());
        show(shown, shown.text());
        if (!json) {
            file.warnings().forEach(warning -> out().println(ShownWorld.line(warning)));
            out().println("\nDrawn to " + drawn);
            out().flush();
        }
    }

    private ShownPlaces places(RoomMap found, int number) {
        try {
            return ShownPlaces.of(found, number);
        } catch (IllegalArgumentException e) { // what cannot be: each says why
            throw new ParameterException(spec.commandLine(), String.valueOf(e.getMessage()), e);
        }
    }

    /// What makes a picture.
    private interface Drawing {
        byte[] png() throws IOException;
    }

    /// @return where it was drawn
    private Path draw(Scene scene) {
        return write(() -> WorldPicture.of(scene, PICTURE));
    }

    /// @return where it was written
    private Path write(Drawing drawing) {
        String file = new File(name).getName().replace(':', '-'); // which Windows forbids in names
        Path drawn = image != null ? image : Path.of(file + ".png");
        try {
            System.setProperty("java.awt.headless", "true"); // a server has no screen
            Files.write(drawn, drawing.png());
            return drawn;
        } catch (IOException e) {
            throw new Unreachable("The picture '%s' can't be written: %s.".formatted(drawn, e));
        }
    }

    private void showWorld() {
        Scene scene = Scenario.scene(name);
        Path drawn = draw(scene);
        var shown = ShownWorld.of(name, scene, drawn.toString());
        if (json) {
            printJson(shown);
        } else {
            print(shown.text());
            scene.warnings().forEach(warning -> out().println(ShownWorld.line(warning)));
            out().println("\nDrawn to " + drawn);
            out().flush();
        }
    }

    /// @param namesakes what goes by the scenario's name, too
    private void show(ScenarioReference reference, List<InstalledKind> others, List<InstalledKind> namesakes) {
        checkName(reference.nameOrFile(), others);
        Scenario scenario = reference.load();
        var options = reference
                .configuration()
                .map(RunOptions.NONE::withConfiguration)
                .orElse(RunOptions.NONE);
        var shown = ShownScenario.of(scenario, scenario.plan(options));
        if (json) {
            printJson(shown);
        } else {
            print(ScenarioText.of(shown)
                    + namesakes.stream().map(InstalledKind::alsoText).collect(Collectors.joining()));
        }
    }

    /// A mistyped name of something else is not a file that is missing.
    private static void checkName(String typed, List<InstalledKind> others) {
        List<String> scenarios = Scenario.builtInNames();
        if (scenarios.contains(typed)) {
            return; // an agent may be called like it
        }
        Optional<String> closest = Suggestion.closest(
                typed, Stream.concat(scenarios.stream(), others(others)).toList());
        boolean mayBeAScenario = closest.filter(scenarios::contains).isPresent();
        if (!mayBeAScenario && !typed.contains(".") && !typed.contains("/") && !new File(typed).exists()) {
            throw new InvalidSettings(
                    Location.of(typed),
                    "There is nothing called '%s'.".formatted(typed),
                    closest.map("Maybe '%s' was meant?"::formatted)
                            .orElse("'rsal list' shows what is installed. Name your own scenarios, worlds, maps and "
                                    + "recordings by their files."));
        }
    }

    private static Stream<String> others(List<InstalledKind> kinds) {
        return Stream.of(
                        kinds.stream().map(InstalledKind::name),
                        Maps.builtIn().stream(),
                        RobotModels.builtIn().stream(),
                        RobotModels.builtInParts().stream())
                .flatMap(names -> names);
    }

    private void print(String text) {
        out().print(text);
        out().flush();
    }
}
