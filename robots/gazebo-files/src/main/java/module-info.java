/// Worlds of Gazebo (SDF), read as worlds and written. Knows nothing of any robot system.
module rsal.gazebo {
    requires rsal.worlds;
    requires rsal.devices;
    requires static org.jspecify;

    provides rsal.world.SceneFormat with
            rsal.gazebo.SdfFormat;
    provides rsal.world.SceneExport with
            rsal.gazebo.SdfExport;
}
