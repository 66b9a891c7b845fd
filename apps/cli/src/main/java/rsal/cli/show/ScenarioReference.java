package rsal.cli.show;

import java.io.File;
import java.util.Optional;
import rsal.scenario.Scenario;

/// A scenario as typed: `hunt-and-prey`, `hunt-and-prey:advanced`, `my.yaml:advanced`.
///
/// @param nameOrFile for [Scenario#load]
public record ScenarioReference(String nameOrFile, Optional<String> configuration) {
    public static final String DEFAULT = "hunt-and-prey";
    /// What people are told that they may type.
    public static final String WHAT =
            "A scenario of RSAL ('rsal list'), a scenario file, or its folder (with scenario.yaml, or a file named"
                    + " like the folder)";

    /// @param typed as [rsal.cli.terminal.FileName] reads it
    public static ScenarioReference parse(String typed) {
        int colon = typed.lastIndexOf(':');
        boolean inFolder = typed.lastIndexOf('/') > colon; // on Windows, `C:/labs/hunt.yaml` is a file
        if (colon < 0 || inFolder || new File(typed).exists()) {
            return new ScenarioReference(typed, Optional.empty());
        }
        return new ScenarioReference(typed.substring(0, colon), Optional.of(typed.substring(colon + 1)));
    }

    /// @throws rsal.settings.InvalidSettings with all of its errors, or when it is something else
    public Scenario load() {
        FileKind.requireScenario(nameOrFile);
        return Scenario.load(nameOrFile);
    }
}
