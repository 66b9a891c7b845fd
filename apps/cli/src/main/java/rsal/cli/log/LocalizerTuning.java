package rsal.cli.log;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;
import rsal.cli.run.RunChoices;
import rsal.data.OccupancyGrid;
import rsal.navigation.amcl.Amcl;
import rsal.navigation.amcl.LocalizationMap;
import rsal.navigation.amcl.OdometryModel;
import rsal.navigation.amcl.SensorModel;
import rsal.navigation.parameter.AmclParameters;
import rsal.settings.Arguments;
import rsal.settings.Parameter;
import rsal.settings.Suggestion;

/// `--set`: parameters of the localizer, by the names and with the ranges that they have in a scenario, so that what
/// was
/// found on a log can be written there.
final class LocalizerTuning {
    /// Of the driver's parameters, those that a log has a use for.
    private static final Set<String> OF_LOGS = Set.of(
            "hitDeviation", "randomShare", "independentBeams", "updateDistance", "updateAngle", "odometryNoiseScale");

    /// Parameters with an option of their own.
    private static final Map<String, String> OPTIONS = Map.of(
            "beams", "--beams",
            "maxRange", "--max-range",
            "minParticles", "--min-particles",
            "maxParticles", "--max-particles",
            "model", "--model");

    private static final double USUAL_DOUBT = 2; // that the odometry of logs is taken with

    @Spec(Spec.Target.MIXEE)
    @SuppressWarnings("NullAway.Init") // picocli fills it in
    private CommandSpec spec;

    @Option(
            names = "--set",
            paramLabel = "NAME=VALUE",
            converter = RunChoices.Setting.Converter.class,
            description =
                    "Set a parameter of the localizer 'amcl': hitDeviation, randomShare, independentBeams,"
                            + " updateDistance, updateAngle or odometryDoubt ('rsal show amcl' explains them). May be repeated.")
    private List<RunChoices.Setting> settings = List.of();

    /// @throws ParameterException when a parameter does not exist, or its value is out of range
    Arguments arguments() {
        List<Parameter<?>> parameters = AmclParameters.ALL.stream()
                .filter(parameter -> OF_LOGS.contains(parameter.name()))
                .toList();
        var given = new LinkedHashMap<String, Object>();
        settings.forEach(setting -> given.put(setting.name(), value(setting, parameters)));
        return Arguments.of(parameters, given);
    }

    private Object value(RunChoices.Setting setting, List<Parameter<?>> parameters) {
        Parameter<?> parameter = parameters.stream()
                .filter(known -> known.name().equals(setting.name()))
                .findFirst()
                .orElseThrow(() -> unknown(setting.name(), parameters));
        try {
            return parameter.parse(setting.value());
        } catch (IllegalArgumentException e) {
            throw wrong(String.valueOf(e.getMessage()));
        }
    }

    private ParameterException unknown(String name, List<Parameter<?>> parameters) {
        String option = OPTIONS.get(name);
        return wrong("Option '--set' can't set '%s' here. %s"
                .formatted(
                        name,
                        option != null
                                ? "Use %s.".formatted(option)
                                : Suggestion.among(
                                        name,
                                        parameters.stream().map(Parameter::name).toList())));
    }

    private ParameterException wrong(String message) {
        return new ParameterException(spec.commandLine(), message);
    }

    static LocalizationMap map(OccupancyGrid grid, Arguments tuned) {
        return new LocalizationMap(
                grid, tuned.get(AmclParameters.HIT_DEVIATION), tuned.get(AmclParameters.RANDOM_SHARE));
    }

    static Amcl.Settings settings(int minParticles, int maxParticles, SensorModel.Kind model, Arguments tuned) {
        Amcl.Settings usual = Amcl.Settings.of(minParticles, maxParticles);
        OdometryModel wheels = usual.odometry();
        double doubt = tuned.get(AmclParameters.ODOMETRY_NOISE_SCALE) / USUAL_DOUBT;
        return new Amcl.Settings(
                minParticles,
                maxParticles,
                tuned.get(AmclParameters.INDEPENDENT_BEAMS),
                tuned.get(AmclParameters.UPDATE_DISTANCE),
                tuned.radians(AmclParameters.UPDATE_ANGLE),
                new OdometryModel(
                        doubt * wheels.distancePerMeter(),
                        doubt * wheels.headingPerMeter(),
                        doubt * wheels.headingPerRadian()),
                usual.kld(),
                model);
    }
}
