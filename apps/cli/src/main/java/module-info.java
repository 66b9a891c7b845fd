/// The command `rsal`: reads what a person types, starts runs and their page, prints results. Knows nothing of how
/// robots and agents work; of navigation's algorithms only how to try them on recorded data.
module rsal.cli {
    requires rsal.yaml;
    requires rsal.models;
    requires rsal.worlds;
    requires ch.qos.logback.classic;
    requires ch.qos.logback.core;
    requires info.picocli;
    requires java.desktop; // draws maps
    requires java.management; // how this process was started
    requires java.net.http; // asks runs
    requires jdk.httpserver; // serves the documentation
    requires jdk.management; // memory of the machine
    requires org.slf4j;
    requires rsal.bench;
    requires rsal.environments;
    requires rsal.experiments;
    requires rsal.foxglove;
    requires rsal.frames;
    requires rsal.navigation;
    requires rsal.recordings;
    requires rsal.engine;
    requires rsal.server;
    requires static org.jspecify;
    requires tools.jackson.databind;

    opens rsal.cli to
            info.picocli,
            tools.jackson.databind;
    opens rsal.cli.bench to
            info.picocli,
            tools.jackson.databind;
    opens rsal.cli.grade to
            info.picocli,
            tools.jackson.databind;
    opens rsal.cli.log to
            info.picocli,
            tools.jackson.databind;
    opens rsal.cli.page to
            info.picocli,
            tools.jackson.databind;
    opens rsal.cli.run to
            info.picocli,
            tools.jackson.databind;
    opens rsal.cli.show to
            info.picocli,
            tools.jackson.databind;
    opens rsal.cli.start to
            info.picocli,
            tools.jackson.databind;
    opens rsal.cli.sweep to
            info.picocli,
            tools.jackson.databind;
    opens rsal.cli.terminal to
            info.picocli,
            tools.jackson.databind;

    uses rsal.agent.StrategyComparison;
    uses rsal.cli.log.Conversion;

    provides ch.qos.logback.classic.spi.Configurator with
            rsal.cli.terminal.Logging;
    provides rsal.cli.log.Conversion with
            rsal.cli.log.ExportConversion,
            rsal.cli.log.LogConversion,
            rsal.cli.log.ModelConversion,
            rsal.cli.log.WorldConversion;
}
