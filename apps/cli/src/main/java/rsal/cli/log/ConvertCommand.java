package rsal.cli.log;

import java.util.Optional;
import java.util.ServiceLoader;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import rsal.cli.terminal.Exit;
import rsal.cli.terminal.FileName;
import rsal.cli.terminal.Subcommand;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;
import rsal.world.yaml.YamlFormat;

/// `rsal convert`
@Command(
        name = "convert",
        description =
                "Write a world of Stage as the same world in YAML, its floor plans as images beside it; a robot model"
                        + " of a robot description of ROS (URDF), with parts for its lasers beside it; or a robot's log in another"
                        + " format: a bag of ROS 2 as a log of CARMEN, and the reverse.")
public final class ConvertCommand extends Subcommand {
    @Parameters(
            index = "0",
            converter = FileName.class,
            paramLabel = "FILE.world|ROBOT.urdf|LOG",
            description = "The world's, the robot's or the log's file, or the folder of a bag; a .xacro file must be"
                    + " expanded first.")
    private String file = "";

    @Parameters(
            index = "1",
            arity = "0..1",
            converter = FileName.class,
            paramLabel = "OUT",
            description =
                    "Where to write it: a world OUT" + YamlFormat.SUFFIX
                            + ", a robot OUT.yaml, by default beside the file; a log OUT.log (CARMEN), OUT.mcap or FOLDER/ (bag).")
    private @Nullable String out;

    @Option(names = "--force", description = "Overwrite files that are there.")
    private boolean force;

    @Override
    protected int run() {
        Optional<String> target = Optional.ofNullable(out);
        Conversion conversion = ServiceLoader.load(Conversion.class).stream()
                .map(ServiceLoader.Provider::get)
                .filter(each -> each.accepts(file, target))
                .findFirst()
                .orElseThrow(() -> unknown());
        tell(conversion.convert(new Conversion.Request(file, target, force, spec.commandLine())));
        return Exit.SUCCESS;
    }

    private InvalidSettings unknown() {
        return new InvalidSettings(
                Location.of(file),
                out == null
                        ? "This is no file that can be converted."
                        : "This can't be converted to '%s'.".formatted(out),
                ServiceLoader.load(Conversion.class).stream()
                        .map(each -> each.get().description())
                        .sorted()
                        .collect(Collectors.joining("; ", "What can be converted: ", ".")));
    }

    private void tell(Conversion.Result result) {
        if (json) {
            printJson(result.json());
            return;
        }
        result.notes().forEach(err()::println);
        result.lines().forEach(out()::println);
        out().flush();
    }
}
