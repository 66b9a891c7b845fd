/// Files of other simulators and servers, read as worlds: Stage's worlds, and Player's configurations of it. Knows
/// nothing of any robot system.
module rsal.stage {
    requires rsal.worlds;
    requires rsal.devices;
    requires static org.jspecify;

    provides rsal.world.SceneFormat with
            rsal.stage.StageFormat,
            rsal.stage.playercfg.PlayerFormat;
}
