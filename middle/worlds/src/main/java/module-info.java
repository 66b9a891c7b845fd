/// Maps, images and worlds, as files, and those that come with RSAL.
module rsal.worlds {
    requires transitive rsal.models;
    requires java.desktop; // ImageIO reads map images
    requires static org.jspecify;

    exports rsal.image;
    exports rsal.map;
    exports rsal.world;
    exports rsal.world.yaml;

    uses rsal.world.SceneExport;
    uses rsal.world.SceneFormat;

    provides rsal.world.SceneFormat with
            rsal.world.yaml.YamlFormat;
}
