/// Reads settings strictly from YAML, with the place of each value. Knows nothing of what they are for.
module rsal.yaml {
    requires transitive rsal.settings;
    requires org.snakeyaml.engine;
    requires static org.jspecify;

    exports rsal.yaml;
}
