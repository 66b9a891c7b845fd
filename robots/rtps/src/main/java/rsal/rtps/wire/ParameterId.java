package rsal.rtps.wire;

/// Numbers of parameters that discovery and inline QoS use (DDSI-RTPS 2.5, table 9.14 and 9.18).
public final class ParameterId {
    public static final int PARTICIPANT_LEASE_DURATION = 0x0002;
    public static final int TOPIC_NAME = 0x0005;
    public static final int TYPE_NAME = 0x0007;
    public static final int DOMAIN_ID = 0x000f;
    public static final int PROTOCOL_VERSION = 0x0015;
    public static final int VENDOR_ID = 0x0016;
    public static final int RELIABILITY = 0x001a;
    public static final int LIVELINESS = 0x001b;
    public static final int DURABILITY = 0x001d;
    public static final int OWNERSHIP = 0x001f;
    public static final int DEADLINE = 0x0023;
    public static final int PARTITION = 0x0029;
    public static final int LIFESPAN = 0x002b;
    public static final int USER_DATA = 0x002c;
    public static final int UNICAST_LOCATOR = 0x002f;
    public static final int DEFAULT_UNICAST_LOCATOR = 0x0031;
    public static final int METATRAFFIC_UNICAST_LOCATOR = 0x0032;
    public static final int HISTORY = 0x0040;
    public static final int PARTICIPANT_GUID = 0x0050;
    public static final int BUILTIN_ENDPOINT_SET = 0x0058;
    public static final int ENDPOINT_GUID = 0x005a;
    public static final int ENTITY_NAME = 0x0062;
    public static final int KEY_HASH = 0x0070;
    public static final int STATUS_INFO = 0x0071;
    public static final int DATA_REPRESENTATION = 0x0073;

    /// Of services, as the standard has it.
    public static final int RELATED_SAMPLE_IDENTITY = 0x0083;

    public static final int DOMAIN_TAG = 0x4014;

    /// The same, as Fast DDS up to 2.9 sends it alone.
    public static final int RELATED_SAMPLE_IDENTITY_OF_FAST_DDS = 0x800f;

    private ParameterId() {}
}
