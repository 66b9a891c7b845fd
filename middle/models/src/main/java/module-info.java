/// Robot models and the parts that are mounted on robots, as files, and those that come with RSAL.
module rsal.models {
    requires transitive rsal.devices;
    requires transitive rsal.yaml;
    requires java.xml; // URDF
    requires static org.jspecify;

    exports rsal.model;
    exports rsal.model.urdf;
    exports rsal.model.xml;
}
