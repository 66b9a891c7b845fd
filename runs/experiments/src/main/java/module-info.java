/// Experiments: many runs of a scenario with other arguments, configurations and seeds, the result of each,
/// and what that says. Knows nothing of robots and agents beyond what a run's result tells.
module rsal.experiments {
    requires transitive rsal.engine;
    requires java.desktop; // draws figures
    requires tools.jackson.databind;
    requires org.apache.commons.statistics.distribution;
    requires org.apache.pdfbox;
    requires static org.jspecify;

    exports rsal.experiment;
    exports rsal.experiment.report;
    exports rsal.experiment.statistics;

    opens rsal.experiment to
            tools.jackson.databind;
}
