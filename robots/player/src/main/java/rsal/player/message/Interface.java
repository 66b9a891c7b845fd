package rsal.player.message;

import java.util.Arrays;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Collectors;
import rsal.player.wire.Address;

/// What a device of Player's can be, with its code.
public enum Interface {
    PLAYER(1),
    POWER(2),
    GRIPPER(3),
    POSITION2D(4),
    SONAR(5),
    LASER(6),
    BLOBFINDER(7),
    PTZ(8),
    AUDIO(9),
    FIDUCIAL(10),
    SPEECH(12),
    GPS(13),
    BUMPER(14),
    DIO(20),
    AIO(21),
    IR(22),
    WIFI(23),
    LOCALIZE(25),
    POSITION3D(30),
    SIMULATION(31),
    BLINKENLIGHT(33),
    CAMERA(40),
    MAP(42),
    PLANNER(44),
    LOG(45),
    JOYSTICK(49),
    SPEECH_RECOGNITION(50),
    OPAQUE(51),
    POSITION1D(52),
    ACTARRAY(53),
    LIMB(54),
    GRAPHICS2D(55),
    RFID(56),
    WSN(57),
    GRAPHICS3D(58),
    HEALTH(59),
    IMU(60),
    POINTCLOUD3D(61),
    RANGER(62),
    VECTORMAP(63),
    BLACKBOARD(64),
    STEREO(65),
    COOPOBJECT(66);

    private static final Map<Integer, Interface> BY_CODE =
            Arrays.stream(values()).collect(Collectors.toUnmodifiableMap(each -> each.code, Function.identity()));
    private static final Map<String, Interface> BY_WORD =
            Arrays.stream(values()).collect(Collectors.toUnmodifiableMap(Interface::word, Function.identity()));

    private final int code;

    Interface(int code) {
        this.code = code;
    }

    public int code() {
        return code;
    }

    /// As configuration files have it.
    public String word() {
        return name().toLowerCase(Locale.ROOT);
    }

    public static Optional<Interface> of(int code) {
        return Optional.ofNullable(BY_CODE.get(code));
    }

    public static Optional<Interface> of(String word) {
        return Optional.ofNullable(BY_WORD.get(word));
    }

    /// A device for people: `position2d:0`.
    public static String words(Address device) {
        return of(device.interf()).map(Interface::word).orElse("interface " + device.interf()) + ":" + device.index();
    }
}
