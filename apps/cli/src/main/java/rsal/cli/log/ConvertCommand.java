package rsal.cli.log;

import java.util.Optional;
import java.util.ServiceLoader;
import java.util.regex.Pattern;
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
        description = "Convert a world of Stage or Gazebo to YAML, with images of its floor plans. Or convert any"
                + " world or scenario for Gazebo (OUT.sdf), with its robots, and a configuration for"
                + " ros_gz_bridge. Or convert a robot description of ROS (URDF) to a robot model, with"
                + " parts for its lasers. Or convert the log of a robot: a bag of ROS 2 to a log of"
                + " CARMEN, or the reverse.")
public final class ConvertCommand extends Subcommand {
    private static final String SDF = ".sdf";
    private static final Pattern WITHOUT_SUFFIX = // of a file, or the configuration of a scenario
            Pattern.compile("(\\.world\\.yaml|\\.yaml|\\.world|:[\\w-]+)$");

    @Parameters(
            index = "0",
            converter = FileName.class,
            paramLabel = "FILE.world|FILE.sdf|SCENARIO|ROBOT.urdf|LOG",
            description = "The file of the world, the robot or the log, or the folder of a bag; for Gazebo also a"
                    + " scenario. Expand a .xacro file first.")
    private String file = "";

    @Parameters(
            index = "1",
            arity = "0..1",
            converter = FileName.class,
            paramLabel = "OUT",
            description = "The file to write: for a world OUT" + YamlFormat.SUFFIX + " or, for Gazebo, OUT.sdf;"
                    + " for a robot OUT.yaml; for a log OUT.log (CARMEN), OUT.mcap or FOLDER/ (bag). Default:"
                    + " for worlds and robots in YAML, a file in the folder of the input file.")
    private @Nullable String out;

    @Option(
            names = "--sdf",
            description = "For Gazebo: write an .sdf file with the name of the input file, if OUT does not name one.")
    private boolean sdf;

    @Option(names = "--force", description = "Overwrite existing files.")
    private boolean force;

    @Option(
            names = "--seed",
            paramLabel = "N",
            description = "For Gazebo: seed of the start poses, if a scenario draws them at random. Default: 1.")
    private long seed = 1;

    @Override
    protected int run() {
        Optional<String> target = target();
        Conversion conversion = ServiceLoader.load(Conversion.class).stream()
                .map(ServiceLoader.Provider::get)
                .filter(each -> each.accepts(file, target))
                .findFirst()
                .orElseThrow(() -> unknown());
        print(conversion.convert(new Conversion.Request(file, target, force, seed, spec.commandLine())));
        return Exit.SUCCESS;
    }

    private Optional<String> target() {
        if (!sdf) {
            return Optional.ofNullable(out);
        }
        check(!file.endsWith(SDF), "'%s' is SDF already. Leave out --sdf to convert it to YAML.".formatted(file));
        check(out == null || out.endsWith(SDF), "--sdf writes a file such as OUT.sdf, not '%s'.".formatted(out));
        return Optional.of(out == null ? WITHOUT_SUFFIX.matcher(file).replaceFirst("") + SDF : out);
    }

    private InvalidSettings unknown() {
        return new InvalidSettings(
                Location.of(file),
                out == null
                        ? "This is not a file that can be converted."
                        : "This can't be converted to '%s'.".formatted(out),
                ServiceLoader.load(Conversion.class).stream()
                        .map(each -> each.get().description())
                        .sorted()
                        .collect(Collectors.joining("; ", "What can be converted: ", ".")));
    }

    private void print(Conversion.Result result) {
        if (json) {
            printJson(result.json());
            return;
        }
        result.notes().forEach(err()::println);
        result.lines().forEach(out()::println);
        out().flush();
    }
}
