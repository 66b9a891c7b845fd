package rsal.cli.log;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Optional;
import java.util.stream.Stream;
import rsal.cli.log.WorldConversion.Converted;
import rsal.scene.Scene;
import rsal.settings.Location;
import rsal.world.SceneExport;

/// The world of a file or a scenario, for another program.
public final class ExportConversion implements Conversion {
    @Override
    public String description() {
        return "worlds and scenarios for Gazebo (SCENARIO OUT.sdf)";
    }

    @Override
    public boolean accepts(String file, Optional<String> out) {
        return !file.endsWith(ModelConversion.URDF)
                && out.flatMap(SceneExport::of).isPresent();
    }

    @Override
    public Result convert(Request request) {
        SceneExport export = request.out().flatMap(SceneExport::of).orElseThrow();
        Path target = ConvertedFiles.target(request, "$", export.suffix());
        String name = String.valueOf(target.getFileName());
        Scene scene = ExportedWorld.of(request.file(), request.seed());
        var written = export.write(
                scene, name.substring(0, name.length() - export.suffix().length()), Location.of(request.file()));
        var files = new ConvertedFiles();
        written.files().forEach((beside, bytes) -> files.add(target.resolveSibling(beside), bytes));
        files.write(request.force());
        var lines = new ArrayList<>(files.names());
        lines.add(written.summary());
        return new Result(
                Converted.of(request.file(), files, scene),
                lines,
                Stream.concat(
                                scene.warnings().stream().map(String::valueOf),
                                written.notes().stream().map(note -> "Note: " + note))
                        .toList());
    }
}
