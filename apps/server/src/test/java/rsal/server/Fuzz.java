package rsal.server;

import java.nio.charset.StandardCharsets;
import java.util.Random;

/// Input that nobody meant.
final class Fuzz {
    private static final String[] KEYS = {
        "robot",
        "x",
        "y",
        "heading",
        "factor",
        "seed",
        "configuration",
        "arguments",
        "frame",
        "events",
        "couriers",
        "driver",
        "vx",
        "vy",
        "omega",
        "behavior",
        "kind",
        "name",
        ""
    };
    private static final String[] VALUES = {
        "\"courier-1\"",
        "\"nobody\"",
        "0",
        "-1",
        "1e308",
        "1e999",
        "9223372036854775808",
        "null",
        "true",
        "[]",
        "{}",
        "\"\"",
        "\"max\"",
        "\"\\u0000\"",
        "\"\\ud800\"",
        "NaN",
        "\"1\"",
        "[[1]]",
        "{\"couriers\":\"1\"}",
        "\"pair\"",
        "\"wander\"",
        "\"me\"",
        "\"BOX\"",
        "\"box-1\""
    };

    private Fuzz() {}

    /// Nearly what is expected, and sometimes cut off.
    static String json(Random random) {
        var json = new StringBuilder("{");
        int members = random.nextInt(6);
        for (int i = 0; i < members; i++) {
            json.append(i == 0 ? "" : ",")
                    .append('"')
                    .append(KEYS[random.nextInt(KEYS.length)])
                    .append("\":")
                    .append(VALUES[random.nextInt(VALUES.length)]);
        }
        json.append('}');
        return random.nextInt(8) == 0 ? json.substring(0, random.nextInt(json.length())) : json.toString();
    }

    /// A request with noise in it; it always ends, so that the server need not wait for more.
    static byte[] request(byte[] noise, Random random) {
        String text = new String(noise, StandardCharsets.ISO_8859_1);
        String request = random.nextBoolean()
                ? "GET /" + text + " HTTP/1.1\r\nHost: x\r\nConnection: close\r\n\r\n"
                : "GET / HTTP/1.1\r\nHost: x\r\nConnection: close\r\n" + text + "\r\n\r\n";
        return request.getBytes(StandardCharsets.ISO_8859_1);
    }
}
